#include <algorithm>

#include "groundstation/mcap/archive.hpp"
#include "groundstation/mcap/codec.hpp"
#include "groundstation/mcap/reader.hpp"

namespace skein::mcap {
namespace {

constexpr std::size_t kFooterContent = 20;
constexpr std::size_t kFooterRecord = kRecordHead + kFooterContent;

/// Of the format, or of an application.
bool is_opcode(std::uint8_t byte) {
  const bool of_format =
      byte >= static_cast<std::uint8_t>(Opcode::Header) && byte <= static_cast<std::uint8_t>(Opcode::DataEnd);
  return of_format || byte >= 0x80;
}

/// Of a record in the summary or the data section. @throws Damaged
template <typename Record>
Record read(const Framed& framed, std::uint64_t offset) {
  if (auto record = decode<Record>(framed.content)) return *std::move(record);
  throw Damaged(offset, "a record that is not what its opcode says");
}

}  // namespace

bool Reader::open_by_summary() {
  const std::size_t size = file_.size();
  if (size < 2 * kMagic.size() + kFooterRecord) return false;
  if (!std::ranges::equal(file_.last(kMagic.size()), kMagic)) return false;
  const std::size_t footer_at = size - kMagic.size() - kFooterRecord;
  const auto framed = record_at(file_, footer_at);
  if (!framed || framed->opcode != Opcode::Footer || framed->content.size() != kFooterContent) {
    throw Damaged(footer_at, "there is no footer, though the file ends as a whole one does");
  }
  const auto footer = read<Footer>(*framed, footer_at);
  const std::uint64_t start = footer.summary_start == 0 ? footer_at : footer.summary_start;
  if (start > footer_at) throw Damaged(footer_at, "a footer that points behind itself");
  const std::size_t covered = size - kMagic.size() - sizeof(footer.summary_crc);
  const ByteView summary = file_.first(covered).subspan(static_cast<std::size_t>(start));
  if (footer.summary_crc != 0 && crc_of(summary) != footer.summary_crc) {
    throw Damaged(start, "the summary, whose checksum does not match");
  }
  if (footer.summary_start == 0) return false;
  const std::uint64_t end = footer.summary_offset_start == 0 ? footer_at : footer.summary_offset_start;
  if (end < start || end > footer_at) throw Damaged(footer_at, "a footer whose offsets are out of order");
  take_summary(start, end);
  return true;
}

void Reader::take_summary(std::uint64_t from, std::uint64_t to) {
  for (std::uint64_t at = from; at < to;) {
    const auto framed = record_at(file_.first(static_cast<std::size_t>(to)), at);
    if (!framed) throw Damaged(at, "the summary ends within a record");
    if (framed->opcode == Opcode::Schema) {
      auto schema = read<Schema>(*framed, at);
      contents_.schemas[schema.id] = std::move(schema);
    } else if (framed->opcode == Opcode::Channel) {
      auto channel = read<Channel>(*framed, at);
      contents_.channels[channel.id] = std::move(channel);
    } else if (framed->opcode == Opcode::ChunkIndex) {
      contents_.chunks.push_back(read<ChunkIndex>(*framed, at));
    } else if (framed->opcode == Opcode::AttachmentIndex) {
      contents_.attachments.push_back(read<AttachmentIndex>(*framed, at));
    } else if (framed->opcode == Opcode::MetadataIndex) {
      contents_.metadata.push_back(read<MetadataIndex>(*framed, at));
    } else if (framed->opcode == Opcode::Statistics) {
      contents_.statistics = read<Statistics>(*framed, at);
    }
    at += framed->size;
  }
  std::ranges::sort(contents_.chunks, {}, &ChunkIndex::chunk_offset);
}

void Reader::scan() {
  std::uint64_t at = kMagic.size();
  while (const auto framed = record_at(file_, at)) {
    if (framed->opcode == Opcode::DataEnd) {
      check_tail(at + framed->size);
      return end_of_scan(at + framed->size, true);
    }
    if (framed->opcode == Opcode::Chunk) {
      scan_chunk(at, read<Chunk>(*framed, at));
      contents_.chunks.back().chunk_length = framed->size;
    } else if (framed->opcode == Opcode::Attachment) {
      const auto held = read<Attachment>(*framed, at);
      contents_.attachments.push_back(
          {at, framed->size, held.log_time, held.create_time, held.data.size(), held.name, held.media_type});
      ++contents_.statistics.attachment_count;
    } else if (framed->opcode == Opcode::Metadata) {
      contents_.metadata.push_back({at, framed->size, read<Metadata>(*framed, at).name});
      ++contents_.statistics.metadata_count;
    } else if (framed->opcode == Opcode::MessageIndex && !contents_.chunks.empty()) {
      const auto index = read<MessageIndex>(*framed, at);
      contents_.chunks.back().message_index_offsets[index.channel_id] = at;
      contents_.chunks.back().message_index_length += framed->size;
    } else if (framed->opcode == Opcode::Message) {
      throw Damaged(at, "a message outside a chunk");
    }
    at += framed->size;
  }
  check_tail(at);
  end_of_scan(at, false);
}

void Reader::check_tail(std::uint64_t at) const {
  while (const auto framed = record_at(file_, at)) {
    at += framed->size;
    if (framed->opcode != Opcode::Footer) continue;
    const ByteView end = file_.subspan(static_cast<std::size_t>(at));
    const auto [in_file, in_magic] = std::ranges::mismatch(end, kMagic);
    if (in_file != end.end()) throw Damaged(at, "the file does not end as it should after its footer");
    return;
  }
  const ByteView rest = file_.subspan(static_cast<std::size_t>(at));
  if (!rest.empty() && !is_opcode(rest.front())) throw Damaged(at, "what begins there is no record");
}

void Reader::scan_chunk(std::uint64_t offset, const Chunk& chunk) {
  const Bytes records = expanded(offset, chunk);
  Statistics& statistics = contents_.statistics;
  for (std::size_t at = 0; at < records.size();) {
    const auto framed = record_at(records, at);
    if (!framed) throw Damaged(offset, "a chunk that ends within a record");
    if (framed->opcode == Opcode::Schema) {
      auto schema = read<Schema>(*framed, offset);
      contents_.schemas[schema.id] = std::move(schema);
    } else if (framed->opcode == Opcode::Channel) {
      auto channel = read<Channel>(*framed, offset);
      contents_.channels[channel.id] = std::move(channel);
    } else if (framed->opcode == Opcode::Message) {
      const auto message = read<Message>(*framed, offset);
      const bool first = statistics.message_count++ == 0;
      ++statistics.channel_message_counts[message.channel_id];
      statistics.start_time = first ? message.log_time : std::min(statistics.start_time, message.log_time);
      statistics.end_time = first ? message.log_time : std::max(statistics.end_time, message.log_time);
    }
    at += framed->size;
  }
  ++statistics.chunk_count;
  contents_.chunks.push_back({chunk.start_time,
                              chunk.end_time,
                              offset,
                              0,
                              {},
                              0,
                              chunk.compression,
                              chunk.records.size(),
                              chunk.uncompressed_size});
}

void Reader::end_of_scan(std::uint64_t end, bool ended) {
  contents_.statistics.schema_count = static_cast<std::uint16_t>(contents_.schemas.size());
  contents_.statistics.channel_count = static_cast<std::uint32_t>(contents_.channels.size());
  if (ended) {
    missing_ = "the summary at its end is missing: all messages are there";
    return;
  }
  missing_ = "it was cut: it ends after " + std::to_string(contents_.chunks.size()) + " whole chunks with " +
             std::to_string(contents_.statistics.message_count) + " messages, without summary; " +
             std::to_string(file_.size() - end) + " bytes after the last whole record are left out";
}

}  // namespace skein::mcap
