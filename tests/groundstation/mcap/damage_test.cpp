// A file cut anywhere opens up to its last whole chunk; a byte changed anywhere is found, or changes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "groundstation/mcap/archive.hpp"
#include "groundstation/mcap/codec.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/groundstation/mcap/files.hpp"

namespace skein::mcap::tests {
namespace {

using ::testing::HasSubstr;

/// Chunks that are whole in the first `size` bytes: a chunk is, before its indexes are.
std::size_t whole_chunks(const Contents& contents, std::size_t size) {
  return static_cast<std::size_t>(std::ranges::count_if(
      contents.chunks, [&](const ChunkIndex& chunk) { return chunk.chunk_offset + chunk.chunk_length <= size; }));
}

void expect_damaged(const Bytes& file) {
  try {
    const Reader reader(file);
    reader.check();
    ADD_FAILURE() << "not found; missing: " << reader.missing();
  } catch (const Damaged& damaged) {
    EXPECT_LE(damaged.offset, file.size());
  }
}

TEST(Damage, AFileCutAtAnyByteOpensUpToItsLastWholeChunk) {
  const Written written = random_file(5, 60);
  const Reader whole(written.file);
  ASSERT_GE(whole.contents().chunks.size(), 4U);
  std::vector<std::size_t> up_to{0};  // messages in the first i chunks
  std::size_t counted = 0;
  for (const ChunkIndex& index : whole.contents().chunks) {
    const Bytes records = whole.chunk(index);
    for (std::size_t at = 0; at < records.size(); at += record_at(records, at)->size) {
      if (record_at(records, at)->opcode == Opcode::Message) ++counted;
    }
    up_to.push_back(counted);
  }
  const std::size_t header_end = kMagic.size() + record_at(written.file, kMagic.size())->size;
  for (std::size_t size = 0; size < written.file.size(); ++size) {
    SCOPED_TRACE(size);
    const ByteView file = ByteView(written.file).first(size);
    if (size < header_end) {
      EXPECT_THROW(Reader{file}, Damaged);
      continue;
    }
    const Reader reader(file);
    reader.check();
    EXPECT_NE(reader.missing(), "");
    const std::size_t chunks = whole_chunks(whole.contents(), size);
    ASSERT_EQ(reader.contents().chunks.size(), chunks);
    const std::vector<Held> expected(written.messages.begin(),
                                     written.messages.begin() + static_cast<std::ptrdiff_t>(up_to[chunks]));
    ASSERT_EQ(messages_of(reader), expected);
    ASSERT_EQ(reader.contents().statistics.message_count, expected.size());
  }
}

TEST(Damage, EveryChangedByteIsFound) {
  const Written written = random_file(6, 40);
  RandomStream random(6, 0, Purpose::Test, 1);
  Bytes file = written.file;
  for (std::size_t at = 0; at < file.size(); ++at) {
    SCOPED_TRACE(at);
    const auto flip = static_cast<std::uint8_t>(1 + random.below(255));
    file[at] ^= flip;
    expect_damaged(file);
    file[at] ^= flip;
  }
}

TEST(Damage, EveryChangedBitOfTheLastRecordsIsFound) {
  const Written written = random_file(8, 20);
  Bytes file = written.file;
  for (std::size_t bit = 8 * (file.size() - 100); bit < 8 * file.size(); ++bit) {
    SCOPED_TRACE(bit);
    file[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    expect_damaged(file);
    file[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
}

TEST(Damage, WhatIsAppendedIsFound) {
  const Written written = random_file(9, 20);
  for (const Bytes& more : {Bytes{0}, Bytes{0x89}, Bytes(kMagic.begin(), kMagic.end()), Bytes(500, 7), written.file}) {
    Bytes file = written.file;
    file.insert(file.end(), more.begin(), more.end());
    SCOPED_TRACE(more.size());
    expect_damaged(file);
  }
}

TEST(Damage, WhatCannotBeginARecordIsNoCut) {
  const Written written = random_file(9, 60);
  const ChunkIndex last = Reader(written.file).contents().chunks.back();
  Bytes file(written.file.begin(), written.file.begin() + static_cast<std::ptrdiff_t>(last.chunk_offset + 20));
  EXPECT_NE(Reader(file).missing(), "");
  file[last.chunk_offset] = 0x40;
  expect_damaged(file);
}

TEST(Damage, AChangedChunkIsNamedWithItsOffset) {
  Written written = random_file(7, 60);
  const Reader before(written.file);
  const std::vector<ChunkIndex> chunks = before.contents().chunks;
  for (const ChunkIndex& index : chunks) {
    const auto middle = static_cast<std::size_t>(index.chunk_offset + index.chunk_length / 2);
    written.file[middle] ^= 0x10;
    const Reader reader(written.file);  // the summary does not tell
    try {
      reader.check();
      ADD_FAILURE() << "not found";
    } catch (const Damaged& damaged) {
      EXPECT_EQ(damaged.offset, index.chunk_offset);
      EXPECT_THAT(damaged.what(), HasSubstr("a chunk"));
    }
    written.file[middle] ^= 0x10;
  }
}

TEST(Damage, WhatIsNoMcapFileIsRefused) {
  EXPECT_THROW(Reader{Bytes{}}, Damaged);
  EXPECT_THROW((Reader{Bytes{'h', 'e', 'l', 'l', 'o', ' ', 'y', 'o', 'u', '!'}}), Damaged);
  EXPECT_EQ(expand("lz4", Bytes{1, 2, 3}, 3), std::nullopt);
  EXPECT_EQ(expand("", Bytes{1, 2, 3}, 4), std::nullopt);
  EXPECT_EQ(expand("zstd", compress(Bytes{1, 2, 3}), 4), std::nullopt);
  EXPECT_EQ(expand("zstd", compress(Bytes{1, 2, 3}), kMostInChunk + 1), std::nullopt);
  EXPECT_EQ(expand("zstd", compress(Bytes{1, 2, 3}), 3), (Bytes{1, 2, 3}));
}

}  // namespace
}  // namespace skein::mcap::tests
