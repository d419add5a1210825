#include "groundstation/mcap/writer.hpp"

#include <algorithm>
#include <stdexcept>

#include "groundstation/mcap/archive.hpp"
#include "groundstation/mcap/codec.hpp"

namespace skein::mcap {
namespace {

template <typename Items>
std::uint16_t next_id(const Items& items, const char* what) {
  if (items.size() == UINT16_MAX) throw std::length_error(std::string("more than 65535 ") + what);
  return static_cast<std::uint16_t>(items.size() + 1);
}

}  // namespace

Writer::Writer(Sink sink, WriterOptions options) : sink_(std::move(sink)), options_(std::move(options)) {
  emit(kMagic);
  emit_record(Header{"", options_.library});
}

void Writer::emit(ByteView bytes) {
  sink_(bytes);
  crc_ = crc_of(bytes, crc_);
  position_ += bytes.size();
}

template <typename Record>
void Writer::emit_record(const Record& record) {
  Bytes bytes;
  append(bytes, record);
  emit(bytes);
}

std::uint16_t Writer::add_schema(std::string name, std::string encoding, Bytes data) {
  const std::uint16_t id = next_id(schemas_, "schemas");
  schemas_.push_back({id, std::move(name), std::move(encoding), std::move(data)});
  return id;
}

std::uint16_t Writer::add_channel(std::uint16_t schema_id, std::string topic, std::string message_encoding,
                                  Texts metadata) {
  const std::uint16_t id = next_id(channels_, "channels");
  channels_.push_back({id, schema_id, std::move(topic), std::move(message_encoding), std::move(metadata)});
  return id;
}

void Writer::introduce(std::uint16_t channel_id) {
  if (!channels_told_.insert(channel_id).second) return;
  const Channel& channel = channels_.at(channel_id - std::size_t{1});
  if (channel.schema_id != 0 && schemas_told_.insert(channel.schema_id).second) {
    append(chunk_, schemas_.at(channel.schema_id - std::size_t{1}));
  }
  append(chunk_, channel);
}

void Writer::note_time(std::uint64_t log_time) {
  const bool first_in_chunk = chunk_messages_.empty();
  chunk_start_ = first_in_chunk ? log_time : std::min(chunk_start_, log_time);
  chunk_end_ = first_in_chunk ? log_time : std::max(chunk_end_, log_time);
  const bool first = statistics_.message_count == 0;
  statistics_.start_time = first ? log_time : std::min(statistics_.start_time, log_time);
  statistics_.end_time = first ? log_time : std::max(statistics_.end_time, log_time);
}

void Writer::write(const Message& message) {
  introduce(message.channel_id);
  note_time(message.log_time);
  MessageIndex& index = chunk_messages_[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.emplace_back(message.log_time, chunk_.size());
  append(chunk_, message);
  ++statistics_.message_count;
  ++statistics_.channel_message_counts[message.channel_id];
  if (chunk_.size() >= options_.chunk_bytes) flush();
}

void Writer::flush() {
  if (chunk_.empty()) return;
  const Bytes packed = options_.compressed ? compress(chunk_) : chunk_;
  const Chunk chunk{chunk_start_, chunk_end_, chunk_.size(), crc_of(chunk_), options_.compressed ? "zstd" : "", packed};
  ChunkIndex index{chunk.start_time, chunk.end_time,         position_, 0, {}, 0, chunk.compression,
                   packed.size(),    chunk.uncompressed_size};
  emit_record(chunk);
  index.chunk_length = position_ - index.chunk_offset;
  const std::uint64_t indexes_start = position_;
  for (auto& [channel, messages] : chunk_messages_) {
    std::ranges::stable_sort(messages.entries, {}, [](const auto& entry) { return entry.first; });
    index.message_index_offsets[channel] = position_;
    emit_record(messages);
  }
  index.message_index_length = position_ - indexes_start;
  chunks_.push_back(std::move(index));
  chunk_.clear();
  chunk_messages_.clear();
}

void Writer::attach(Attachment attachment) {
  flush();
  Bytes fields_before;
  Put archive(fields_before);
  attachment.crc = 0;
  fields(archive, std::as_const(attachment));
  attachment.crc = crc_of(ByteView(fields_before).first(fields_before.size() - sizeof(attachment.crc)));
  AttachmentIndex index{position_,
                        0,
                        attachment.log_time,
                        attachment.create_time,
                        attachment.data.size(),
                        attachment.name,
                        attachment.media_type};
  emit_record(attachment);
  index.length = position_ - index.offset;
  attachments_.push_back(std::move(index));
}

void Writer::add_metadata(const Metadata& metadata) {
  flush();
  MetadataIndex index{position_, 0, metadata.name};
  emit_record(metadata);
  index.length = position_ - index.offset;
  metadata_.push_back(std::move(index));
}

template <typename Records>
void Writer::summarise(const Records& records) {
  if (records.empty()) return;
  const std::uint64_t start = position_;
  for (const auto& record : records) emit_record(record);
  groups_.push_back({static_cast<std::uint8_t>(Records::value_type::kOpcode), start, position_ - start});
}

void Writer::finish() {
  flush();
  std::erase_if(schemas_, [this](const Schema& schema) { return !schemas_told_.contains(schema.id); });
  std::erase_if(channels_, [this](const Channel& channel) { return !channels_told_.contains(channel.id); });
  statistics_.schema_count = static_cast<std::uint16_t>(schemas_.size());
  statistics_.channel_count = static_cast<std::uint32_t>(channels_.size());
  statistics_.attachment_count = static_cast<std::uint32_t>(attachments_.size());
  statistics_.metadata_count = static_cast<std::uint32_t>(metadata_.size());
  statistics_.chunk_count = static_cast<std::uint32_t>(chunks_.size());
  emit_record(DataEnd{crc_});
  crc_ = 0;
  Footer footer{position_, 0, 0};
  summarise(schemas_);
  summarise(channels_);
  summarise(std::vector{statistics_});
  summarise(chunks_);
  summarise(attachments_);
  summarise(metadata_);
  footer.summary_offset_start = position_;
  for (const SummaryOffset& group : groups_) emit_record(group);
  Bytes end;
  append(end, footer);
  footer.summary_crc = crc_of(ByteView(end).first(end.size() - sizeof(footer.summary_crc)), crc_);
  emit_record(footer);
  emit(kMagic);
}

}  // namespace skein::mcap
