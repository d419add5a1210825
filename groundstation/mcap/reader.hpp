// Reads an MCAP file: by its summary if there is one, else by going through it, up to its last whole chunk.
//
// A file that was cut (a process was killed) opens, and missing() says in one line what is not there. Damage is another
// thing: what a checksum covers and does not match is a Damaged, which names the record and its place; and so is an end
// at which no cut can leave a file: another closing magic, something behind it, or what begins like no record. check()
// reads everything; after it, every byte of a whole file is known to be as it was written. Of a file that was cut, a
// record that claims more bytes than there are is the cut one, be it that or a changed length.
//
// Source: https://mcap.dev/spec. Departs from source: messages outside chunks and lz4 are refused.
// Complexity: opening a whole file O(summary), a cut one O(file); a look by time O(chunks + the chunks it meets).
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>

#include "groundstation/mcap/records.hpp"

namespace skein::mcap {

/// The bytes of a file are not what was written.
struct Damaged : std::runtime_error {
  Damaged(std::uint64_t at, const std::string& what)
      : std::runtime_error("byte " + std::to_string(at) + ": " + what), offset(at) {}
  std::uint64_t offset;  ///< of the record, from the start of the file
};

/// What a file holds, without its messages.
struct Contents {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::vector<ChunkIndex> chunks;  ///< in the order of the file
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  Statistics statistics;
};

class Reader {
 public:
  /// @param file outlives the reader. @throws Damaged
  explicit Reader(ByteView file);

  [[nodiscard]] const Contents& contents() const { return contents_; }
  /// What a file that was cut lacks, in one line; empty of a whole one.
  [[nodiscard]] const std::string& missing() const { return missing_; }

  /// The uncompressed records of a chunk. @throws Damaged
  [[nodiscard]] Bytes chunk(const ChunkIndex& index) const;
  /// All messages, in the order of the file; a message's data lives until `take` returns. @throws Damaged
  void for_each(const std::function<void(const Message&)>& take) const;
  /// Messages of some channels (empty: all) with from <= log_time < to, by log_time, those of equal time in the order
  /// of the file; finds them by the indexes. @throws Damaged
  void for_each(std::span<const std::uint16_t> channels, std::uint64_t from, std::uint64_t to,
                const std::function<void(const Message&)>& take) const;
  /// The last one of that name. @throws Damaged
  [[nodiscard]] std::optional<Attachment> attachment(const std::string& name) const;
  [[nodiscard]] std::optional<Metadata> metadata(const std::string& name) const;
  /// Reads everything. @throws Damaged for the first record whose bytes are not those that were written
  void check() const;

 private:
  /// Where a message is; in the order in which messages are given.
  struct Place {
    std::uint64_t time = 0;
    std::size_t chunk = 0;
    std::uint64_t offset = 0;
    std::uint16_t channel = 0;
    auto operator<=>(const Place&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm of clang-tidy 14
  };
  [[nodiscard]] std::vector<Place> places_of(std::size_t number) const;
  [[nodiscard]] bool open_by_summary();
  void take_summary(std::uint64_t from, std::uint64_t to);
  void scan();
  void scan_chunk(std::uint64_t offset, const Chunk& chunk);
  /// Of a file without summary: whether it ends within a record, or after one, and nothing else stands there.
  void check_tail(std::uint64_t at) const;
  void end_of_scan(std::uint64_t end, bool ended);
  template <typename Record>
  [[nodiscard]] Record record(std::uint64_t offset, std::uint64_t length) const;
  [[nodiscard]] Bytes expanded(std::uint64_t offset, const Chunk& chunk) const;
  [[nodiscard]] Attachment attachment(const AttachmentIndex& index) const;
  void check_statistics() const;

  ByteView file_;
  Contents contents_;
  std::string missing_;
};

}  // namespace skein::mcap
