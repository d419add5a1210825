// Compression and checksums of an MCAP file: zstd (libzstd) and CRC-32 as zlib reckons it.
//
// Source: https://mcap.dev/spec/registry, https://mcap.dev/spec (CRC32). Departs from source: lz4 is not read.
#pragma once

#include <optional>

#include "groundstation/mcap/records.hpp"

namespace skein::mcap {

/// More in one chunk is taken for damage, before memory is asked for it. 1 GiB.
inline constexpr std::uint64_t kMostInChunk = std::uint64_t{1} << 30;

/// Of `bytes` behind those that gave `before`.
[[nodiscard]] std::uint32_t crc_of(ByteView bytes, std::uint32_t before = 0);

[[nodiscard]] Bytes compress(ByteView bytes);

/// Nothing if it is no such compression ("zstd", or empty for none), or not of this size.
[[nodiscard]] std::optional<Bytes> expand(const std::string& compression, ByteView bytes, std::uint64_t size);

}  // namespace skein::mcap
