#include "groundstation/mcap/codec.hpp"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <stdexcept>

namespace skein::mcap {

std::uint32_t crc_of(ByteView bytes, std::uint32_t before) {
  uLong crc = before;
  while (!bytes.empty()) {
    const auto part = bytes.first(std::min<std::size_t>(bytes.size(), std::size_t{1} << 30));
    crc = ::crc32(crc, part.data(), static_cast<uInt>(part.size()));
    bytes = bytes.subspan(part.size());
  }
  return static_cast<std::uint32_t>(crc);
}

Bytes compress(ByteView bytes) {
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), ZSTD_CLEVEL_DEFAULT);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::optional<Bytes> expand(const std::string& compression, ByteView bytes, std::uint64_t size) {
  if (size > kMostInChunk) return std::nullopt;
  if (compression.empty()) {
    return bytes.size() == size ? std::optional(Bytes(bytes.begin(), bytes.end())) : std::nullopt;
  }
  if (compression != "zstd") return std::nullopt;
  Bytes expanded(static_cast<std::size_t>(size));
  const std::size_t got = ZSTD_decompress(expanded.data(), expanded.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0 || got != expanded.size()) return std::nullopt;
  return expanded;
}

}  // namespace skein::mcap
