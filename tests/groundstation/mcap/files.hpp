// MCAP files in memory for the tests: random ones by seed, and what a reader finds in one.
#pragma once

#include "groundstation/mcap/reader.hpp"
#include "groundstation/mcap/writer.hpp"

namespace skein::mcap::tests {

/// A message that owns its data.
struct Held {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  Bytes data;
  bool operator==(const Held&) const = default;
};

struct Written {
  Bytes file;
  std::vector<Held> messages;  ///< in the order of the file
  Attachment attachment;
  Metadata metadata;
};

/// Channels, messages and chunks drawn at random, an attachment at its beginning, metadata at its end.
[[nodiscard]] Written random_file(std::uint64_t seed, std::size_t messages, bool compressed = true);

[[nodiscard]] std::vector<Held> messages_of(const Reader& reader);

}  // namespace skein::mcap::tests
