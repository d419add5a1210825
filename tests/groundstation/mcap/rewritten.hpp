// A recording written anew with changed payloads, and checksums that match: what no checksum can find.
#pragma once

#include <functional>
#include <string>

#include "groundstation/mcap/reader.hpp"
#include "groundstation/mcap/writer.hpp"

namespace skein::mcap::tests {

/// A message of a file: its number from 0, in the order of the file, and its topic; the payload may be changed.
using Change = std::function<void(std::size_t number, const std::string& topic, Bytes& payload)>;

/// Schemas, channels, attachments, metadata and all messages as they were, but for what `change` changes.
[[nodiscard]] Bytes rewritten(ByteView file, const Change& change);

}  // namespace skein::mcap::tests
