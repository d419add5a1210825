// The records of an MCAP file as plain values, each with its fields in the order of the file.
//
// A file is magic, Header, data section (chunks with their message indexes, attachments, metadata), DataEnd, summary,
// summary offsets, Footer, magic. A record is its opcode, the length of its content (8 bytes) and the content;
// numbers are little endian, texts and lists stand after their length in bytes. fields() says the content of a record
// once, for writing and for reading (groundstation/mcap/archive.hpp).
//
// Source: the MCAP specification, https://mcap.dev/spec. Departs from source: none; messages stand in chunks alone.
// Complexity: linear in the record.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace skein::mcap {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;
using Texts = std::map<std::string, std::string>;

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead = 9;  ///< bytes of opcode and length

enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Attachment = 0x09,
  AttachmentIndex = 0x0A,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

struct Header {
  static constexpr Opcode kOpcode = Opcode::Header;
  std::string profile;  ///< empty: none
  std::string library;  ///< who wrote the file
  bool operator==(const Header&) const = default;
};

struct Footer {
  static constexpr Opcode kOpcode = Opcode::Footer;
  std::uint64_t summary_start = 0;         ///< 0: there is no summary
  std::uint64_t summary_offset_start = 0;  ///< 0: there are no summary offsets
  std::uint32_t summary_crc = 0;           ///< from the summary's first byte to this field; 0: not given
  bool operator==(const Footer&) const = default;
};

struct Schema {
  static constexpr Opcode kOpcode = Opcode::Schema;
  std::uint16_t id = 0;  ///< from 1
  std::string name;
  std::string encoding;
  Bytes data;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  static constexpr Opcode kOpcode = Opcode::Channel;
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string topic;
  std::string message_encoding;
  Texts metadata;
  bool operator==(const Channel&) const = default;
};

/// Its data is a view into what it was read from.
struct Message {
  static constexpr Opcode kOpcode = Opcode::Message;
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;      ///< ns
  std::uint64_t publish_time = 0;  ///< ns
  ByteView data;
};

struct Chunk {
  static constexpr Opcode kOpcode = Opcode::Chunk;
  std::uint64_t start_time = 0;  ///< least log_time of its messages; 0 without any
  std::uint64_t end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not given
  std::string compression;             ///< "zstd", or empty for none
  ByteView records;
};

struct MessageIndex {
  static constexpr Opcode kOpcode = Opcode::MessageIndex;
  std::uint16_t channel_id = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> entries;  ///< log_time, offset in the uncompressed chunk
  bool operator==(const MessageIndex&) const = default;
};

struct ChunkIndex {
  static constexpr Opcode kOpcode = Opcode::ChunkIndex;
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t chunk_offset = 0;                                ///< of the chunk record, from the start of the file
  std::uint64_t chunk_length = 0;                                ///< with opcode and length
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;  ///< by channel
  std::uint64_t message_index_length = 0;                        ///< of all message indexes of the chunk
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
  bool operator==(const ChunkIndex&) const = default;
};

struct Attachment {
  static constexpr Opcode kOpcode = Opcode::Attachment;
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  Bytes data;
  std::uint32_t crc = 0;  ///< of the fields before; 0: not given
  bool operator==(const Attachment&) const = default;
};

struct AttachmentIndex {
  static constexpr Opcode kOpcode = Opcode::AttachmentIndex;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with opcode and length
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
  bool operator==(const AttachmentIndex&) const = default;
};

struct Statistics {
  static constexpr Opcode kOpcode = Opcode::Statistics;
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t start_time = 0;  ///< least log_time; 0 without a message
  std::uint64_t end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
  bool operator==(const Statistics&) const = default;
};

struct Metadata {
  static constexpr Opcode kOpcode = Opcode::Metadata;
  std::string name;
  Texts texts;
  bool operator==(const Metadata&) const = default;
};

struct MetadataIndex {
  static constexpr Opcode kOpcode = Opcode::MetadataIndex;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< with opcode and length
  std::string name;
  bool operator==(const MetadataIndex&) const = default;
};

struct SummaryOffset {
  static constexpr Opcode kOpcode = Opcode::SummaryOffset;
  std::uint8_t group = 0;  ///< opcode of the group's records
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
  bool operator==(const SummaryOffset&) const = default;
};

struct DataEnd {
  static constexpr Opcode kOpcode = Opcode::DataEnd;
  std::uint32_t data_crc = 0;  ///< of all bytes of the file before this record; 0: not given
  bool operator==(const DataEnd&) const = default;
};

template <typename Held, typename Record>
concept Of = std::is_same_v<std::remove_const_t<Held>, Record>;

void fields(auto& archive, Of<Header> auto& r) {
  archive(r.profile, r.library);
}
void fields(auto& archive, Of<Footer> auto& r) {
  archive(r.summary_start, r.summary_offset_start, r.summary_crc);
}
void fields(auto& archive, Of<Schema> auto& r) {
  archive(r.id, r.name, r.encoding);
  archive.short_bytes(r.data);
}
void fields(auto& archive, Of<Channel> auto& r) {
  archive(r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
}
void fields(auto& archive, Of<Message> auto& r) {
  archive(r.channel_id, r.sequence, r.log_time, r.publish_time);
  archive.rest(r.data);
}
void fields(auto& archive, Of<Chunk> auto& r) {
  archive(r.start_time, r.end_time, r.uncompressed_size, r.uncompressed_crc, r.compression);
  archive.long_bytes(r.records);
}
void fields(auto& archive, Of<MessageIndex> auto& r) {
  archive(r.channel_id, r.entries);
}
void fields(auto& archive, Of<ChunkIndex> auto& r) {
  archive(r.start_time, r.end_time, r.chunk_offset, r.chunk_length, r.message_index_offsets, r.message_index_length,
          r.compression, r.compressed_size, r.uncompressed_size);
}
void fields(auto& archive, Of<Attachment> auto& r) {
  archive(r.log_time, r.create_time, r.name, r.media_type);
  archive.long_bytes(r.data);
  archive(r.crc);
}
void fields(auto& archive, Of<AttachmentIndex> auto& r) {
  archive(r.offset, r.length, r.log_time, r.create_time, r.data_size, r.name, r.media_type);
}
void fields(auto& archive, Of<Statistics> auto& r) {
  archive(r.message_count, r.schema_count, r.channel_count, r.attachment_count, r.metadata_count, r.chunk_count,
          r.start_time, r.end_time, r.channel_message_counts);
}
void fields(auto& archive, Of<Metadata> auto& r) {
  archive(r.name, r.texts);
}
void fields(auto& archive, Of<MetadataIndex> auto& r) {
  archive(r.offset, r.length, r.name);
}
void fields(auto& archive, Of<SummaryOffset> auto& r) {
  archive(r.group, r.group_start, r.group_length);
}
void fields(auto& archive, Of<DataEnd> auto& r) {
  archive(r.data_crc);
}

}  // namespace skein::mcap
