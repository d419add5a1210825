// What is written is what is read: random files, looks by time and channel, and the bytes of a file by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "groundstation/mcap/archive.hpp"
#include "groundstation/mcap/codec.hpp"
#include "groundstation/mcap/file.hpp"
#include "tests/groundstation/mcap/files.hpp"

namespace skein::mcap::tests {
namespace {

TEST(Mcap, ARecordIsItsOpcodeItsLengthAndItsFields) {
  Bytes bytes;
  append(bytes, Channel{2, 1, "ab", "", {{"k", "v"}}});
  const Bytes expected{0x04, 28, 0, 0, 0,  0, 0, 0, 0, 2, 0, 1, 0,   2, 0, 0, 0, 'a', 'b',
                       0,    0,  0, 0, 10, 0, 0, 0, 1, 0, 0, 0, 'k', 1, 0, 0, 0, 'v'};
  EXPECT_EQ(bytes, expected);
  EXPECT_EQ(decode<Channel>(ByteView(bytes).subspan(kRecordHead)), (Channel{2, 1, "ab", "", {{"k", "v"}}}));
}

TEST(Mcap, AnEmptyFileIsHeaderDataEndStatisticsAndFooter) {
  Bytes file;
  Writer writer([&](ByteView bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); }, {"me"});
  writer.finish();
  const Reader reader(file);
  reader.check();
  EXPECT_EQ(reader.contents().header, (Header{"", "me"}));
  EXPECT_EQ(reader.contents().statistics, Statistics{});
  EXPECT_EQ(reader.missing(), "");
  EXPECT_EQ(crc_of(Bytes{'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0xCBF43926U);  // the check value of CRC-32
}

TEST(Mcap, RandomFilesComeBackWhole) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Written written = random_file(seed, 3 * seed, seed % 2 == 0);
    const Reader reader(written.file);
    reader.check();
    EXPECT_EQ(reader.missing(), "");
    EXPECT_EQ(messages_of(reader), written.messages);
    const Contents& contents = reader.contents();
    EXPECT_EQ(contents.statistics.message_count, written.messages.size());
    EXPECT_EQ(contents.statistics.chunk_count, contents.chunks.size());
    const auto attachment = reader.attachment("scenario.yaml");
    ASSERT_TRUE(attachment);
    EXPECT_EQ(attachment->data, written.attachment.data);
    EXPECT_EQ(reader.metadata("run"), written.metadata);
    EXPECT_EQ(reader.attachment("else"), std::nullopt);
    EXPECT_EQ(random_file(seed, 3 * seed, seed % 2 == 0).file, written.file);
    for (const auto& [id, channel] : contents.channels) {
      EXPECT_EQ(channel.metadata.at("agent"), std::to_string(id - 1));
      EXPECT_EQ(contents.schemas.at(channel.schema_id).name, "type" + std::to_string(id - 1));
    }
  }
}

TEST(Mcap, ALookByTimeAndChannelFindsWhatGoingThroughAllFinds) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Written written = random_file(seed, 200);
    for (const std::size_t cut : {written.file.size(), written.file.size() - 20}) {  // by index, and without summary
      const ByteView file = ByteView(written.file).first(cut);
      const Reader reader(file);
      const std::vector<std::uint16_t> channels{1, 2};
      std::vector<Held> expected;
      std::ranges::copy_if(written.messages, std::back_inserter(expected), [](const Held& message) {
        return message.channel <= 2 && message.log_time >= 1100 && message.log_time < 1400;
      });
      std::ranges::stable_sort(expected, {}, &Held::log_time);
      std::vector<Held> found;
      reader.for_each(channels, 1100, 1400, [&](const Message& message) {
        found.push_back({message.channel_id, message.sequence, message.log_time, message.publish_time,
                         Bytes(message.data.begin(), message.data.end())});
      });
      EXPECT_EQ(found, expected);
      EXPECT_FALSE(found.empty());
    }
  }
}

TEST(Mcap, GoesThroughAFile) {
  const std::string path = std::filesystem::temp_directory_path() / ("skein-mcap-" + std::to_string(::getpid()));
  const Written written = random_file(3, 100);
  {
    OutputFile out(path);
    out.write(written.file);
  }
  {
    const MappedFile mapped(path);
    EXPECT_EQ(messages_of(Reader(mapped.bytes())), written.messages);
  }
  std::filesystem::remove(path);
  EXPECT_THROW(MappedFile{path}, std::runtime_error);
  EXPECT_THROW(OutputFile("/nowhere/at/all"), std::runtime_error);
}

}  // namespace
}  // namespace skein::mcap::tests
