// Writes an MCAP file: messages in zstd chunks with CRC and indexes, attachments, metadata, and at its end a summary.
//
// A chunk goes to the file at once when it is full, or when flush() is called: a process that is killed leaves a file
// that is readable up to its last whole chunk. A schema or channel is written in the chunk of its first message, and
// once more in the summary. The same calls give the same bytes.
//
// Source: https://mcap.dev/spec. Departs from source: none. Complexity: linear in what is written; memory for one
// chunk and the indexes of chunks.
#pragma once

#include <functional>
#include <set>

#include "groundstation/mcap/records.hpp"

namespace skein::mcap {

struct WriterOptions {
  std::string library = "skein";
  std::size_t chunk_bytes = std::size_t{1} << 20;  ///< of uncompressed records after which a chunk is full
  bool compressed = true;
};

class Writer {
 public:
  /// Where bytes go, in their order; what it throws, the Writer's functions throw.
  using Sink = std::function<void(ByteView)>;

  explicit Writer(Sink sink, WriterOptions options = {});

  /// @return its id, from 1. @throws std::length_error after 65535
  [[nodiscard]] std::uint16_t add_schema(std::string name, std::string encoding, Bytes data);
  [[nodiscard]] std::uint16_t add_channel(std::uint16_t schema_id, std::string topic, std::string message_encoding,
                                          Texts metadata);
  /// @pre its channel was added, and the file is not finished (all below)
  void write(const Message& message);
  /// Its crc is computed.
  void attach(Attachment attachment);
  void add_metadata(const Metadata& metadata);
  /// Ends the chunk, unless it is empty.
  void flush();
  /// Writes summary and footer; nothing may follow.
  void finish();

  [[nodiscard]] std::uint64_t messages() const { return statistics_.message_count; }

 private:
  void emit(ByteView bytes);
  template <typename Record>
  void emit_record(const Record& record);
  void introduce(std::uint16_t channel_id);
  void note_time(std::uint64_t log_time);
  template <typename Records>
  void summarise(const Records& records);

  Sink sink_;
  WriterOptions options_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;  ///< of the data section, later of the summary
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::set<std::uint16_t> schemas_told_;
  std::set<std::uint16_t> channels_told_;
  Bytes chunk_;
  std::uint64_t chunk_start_ = 0;
  std::uint64_t chunk_end_ = 0;
  std::map<std::uint16_t, MessageIndex> chunk_messages_;
  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
  std::vector<SummaryOffset> groups_;
  Statistics statistics_;
};

}  // namespace skein::mcap
