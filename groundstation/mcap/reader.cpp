#include "groundstation/mcap/reader.hpp"

#include <algorithm>

#include "groundstation/mcap/archive.hpp"
#include "groundstation/mcap/codec.hpp"

namespace skein::mcap {

Reader::Reader(ByteView file) : file_(file) {
  if (file.size() < kMagic.size() || !std::ranges::equal(file.first(kMagic.size()), kMagic)) {
    throw Damaged(0, "this is no MCAP file");
  }
  const auto first = record_at(file, kMagic.size());
  const auto header = first && first->opcode == Opcode::Header ? decode<Header>(first->content) : std::nullopt;
  if (!header) throw Damaged(kMagic.size(), "the file ends in its header, or begins with another record");
  contents_.header = *header;
  if (!open_by_summary()) scan();
}

template <typename Record>
Record Reader::record(std::uint64_t offset, std::uint64_t length) const {
  const auto framed = record_at(file_, offset);
  if (framed && framed->opcode == Record::kOpcode && framed->size == length) {
    if (auto record = decode<Record>(framed->content)) return *std::move(record);
  }
  throw Damaged(offset, "there is no record that the index says");
}

Bytes Reader::expanded(std::uint64_t offset, const Chunk& chunk) const {
  std::optional<Bytes> records = expand(chunk.compression, chunk.records, chunk.uncompressed_size);
  if (!records) throw Damaged(offset, "a chunk that cannot be decompressed");
  if (chunk.uncompressed_crc != 0 && crc_of(*records) != chunk.uncompressed_crc) {
    throw Damaged(offset, "a chunk whose checksum does not match");
  }
  return *std::move(records);
}

Bytes Reader::chunk(const ChunkIndex& index) const {
  const auto held = record<Chunk>(index.chunk_offset, index.chunk_length);
  if (held.start_time != index.start_time || held.end_time != index.end_time ||
      held.uncompressed_size != index.uncompressed_size || held.compression != index.compression) {
    throw Damaged(index.chunk_offset, "a chunk that is not what its index says");
  }
  return expanded(index.chunk_offset, held);
}

void Reader::for_each(const std::function<void(const Message&)>& take) const {
  for (const ChunkIndex& index : contents_.chunks) {
    const Bytes records = chunk(index);
    for (std::size_t at = 0; at < records.size();) {
      const auto framed = record_at(records, at);
      if (!framed) throw Damaged(index.chunk_offset, "a chunk that ends within a record");
      at += framed->size;
      if (framed->opcode != Opcode::Message) continue;
      const auto message = decode<Message>(framed->content);
      if (!message) throw Damaged(index.chunk_offset, "a chunk with a message that is none");
      take(*message);
    }
  }
}

std::vector<Reader::Place> Reader::places_of(std::size_t number) const {
  const ChunkIndex& index = contents_.chunks[number];
  std::vector<Place> places;
  if (!missing_.empty()) {  // the last chunk's indexes may be cut off
    const Bytes records = chunk(index);
    for (std::size_t at = 0; at < records.size();) {
      const auto framed = record_at(records, at);
      if (!framed) throw Damaged(index.chunk_offset, "a chunk that ends within a record");
      const auto message = framed->opcode == Opcode::Message ? decode<Message>(framed->content) : std::nullopt;
      if (message) places.push_back({message->log_time, number, at, message->channel_id});
      at += framed->size;
    }
    return places;
  }
  for (const auto& [channel, offset] : index.message_index_offsets) {
    const auto framed = record_at(file_, offset);
    const auto entries =
        framed && framed->opcode == Opcode::MessageIndex ? decode<MessageIndex>(framed->content) : std::nullopt;
    if (!entries || entries->channel_id != channel) throw Damaged(offset, "there is no message index");
    for (const auto& [time, in_chunk] : entries->entries) places.push_back({time, number, in_chunk, channel});
  }
  return places;
}

void Reader::for_each(std::span<const std::uint16_t> channels, std::uint64_t from, std::uint64_t to,
                      const std::function<void(const Message&)>& take) const {
  std::vector<Place> places;
  for (std::size_t i = 0; i < contents_.chunks.size(); ++i) {
    const ChunkIndex& index = contents_.chunks[i];
    if (index.end_time < from || index.start_time >= to) continue;
    for (const Place& place : places_of(i)) {
      const bool asked = channels.empty() || std::ranges::find(channels, place.channel) != channels.end();
      if (asked && place.time >= from && place.time < to) places.push_back(place);
    }
  }
  std::ranges::sort(places);
  std::map<std::size_t, Bytes> open;  // the chunks that overlap the present time
  for (const Place& place : places) {
    const ChunkIndex& index = contents_.chunks[place.chunk];
    if (!open.contains(place.chunk)) {
      std::erase_if(open, [&](const auto& held) { return contents_.chunks[held.first].end_time < place.time; });
      open[place.chunk] = chunk(index);
    }
    const auto framed = record_at(open[place.chunk], place.offset);
    const auto message = framed && framed->opcode == Opcode::Message ? decode<Message>(framed->content) : std::nullopt;
    if (!message) throw Damaged(index.chunk_offset, "a chunk without the message that its index says");
    take(*message);
  }
}

Attachment Reader::attachment(const AttachmentIndex& index) const {
  auto held = record<Attachment>(index.offset, index.length);
  const auto framed = record_at(file_, index.offset);
  const ByteView before = framed->content.first(framed->content.size() - sizeof(held.crc));
  if (held.crc != 0 && crc_of(before) != held.crc) {
    throw Damaged(index.offset, "attachment '" + index.name + "', whose checksum does not match");
  }
  return held;
}

std::optional<Attachment> Reader::attachment(const std::string& name) const {
  const auto& all = contents_.attachments;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const auto& index) { return index.name == name; });
  return found == all.rend() ? std::nullopt : std::optional(attachment(*found));
}

std::optional<Metadata> Reader::metadata(const std::string& name) const {
  const auto& all = contents_.metadata;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const auto& index) { return index.name == name; });
  return found == all.rend() ? std::nullopt : std::optional(record<Metadata>(found->offset, found->length));
}

void Reader::check_statistics() const {
  Statistics found;
  for_each([&](const Message& message) {
    ++found.message_count;
    ++found.channel_message_counts[message.channel_id];
    if (!contents_.channels.contains(message.channel_id)) throw Damaged(0, "a message of a channel that is not there");
  });
  if (found.message_count != contents_.statistics.message_count ||
      found.channel_message_counts != contents_.statistics.channel_message_counts) {
    throw Damaged(0, "there are not the messages that the statistics say");
  }
}

void Reader::check() const {
  check_statistics();
  for (const AttachmentIndex& index : contents_.attachments) (void)attachment(index);
  for (const MetadataIndex& index : contents_.metadata) (void)record<Metadata>(index.offset, index.length);
  std::uint64_t at = kMagic.size();
  while (const auto framed = record_at(file_, at)) {
    if (framed->opcode == Opcode::DataEnd) {
      const auto end = decode<DataEnd>(framed->content);
      const bool good =
          end && (end->data_crc == 0 || crc_of(file_.first(static_cast<std::size_t>(at))) == end->data_crc);
      if (!good) throw Damaged(at, "the checksum of all before it does not match");
      return;
    }
    at += framed->size;
  }
  if (missing_.empty()) throw Damaged(at, "the records of the file do not lead to its end");
}

}  // namespace skein::mcap
