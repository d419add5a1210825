// What of a recording is played, in which order, and what cannot be.
#include "groundstation/replay/score.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/record/sample_head.hpp"
#include "idl/convert/cdr.hpp"
#include "tests/groundstation/record/recorded.hpp"

namespace skein::replay {
namespace {

using bus::TopicId;
using ::testing::HasSubstr;
using tests::record;
using tests::small_scenario;

struct Held {
  bus::ReplayWriter writer;
  std::uint64_t log_time = 0;
  mcap::Bytes payload;
};

std::vector<Held> played(const Score& score, std::uint64_t from, std::size_t at_most = SIZE_MAX) {
  std::vector<Held> notes;
  score.play(from, [&](const Note& note) {
    notes.push_back({note.writer, note.log_time, {note.payload.begin(), note.payload.end()}});
    return notes.size() < at_most;
  });
  return notes;
}

const mcap::Bytes& small_file() {
  static const mcap::Bytes file = record(small_scenario("small", 7), {}).file;
  return file;
}

TEST(Score, PlaysEverySampleOfTheRunInItsOrder) {
  const mcap::Reader reader(small_file());
  const Score score(reader);
  const std::vector<Held> notes = played(score, 0);
  EXPECT_EQ(notes.size() + 1, reader.contents().statistics.message_count);  // but the mission
  EXPECT_TRUE(std::ranges::is_sorted(notes, {}, &Held::log_time));
  EXPECT_EQ(notes.back().log_time, score.end());
  EXPECT_EQ(score.left_out(), 0U);
  const auto mission = from_cdr<wire::Mission>(score.mission());
  ASSERT_TRUE(mission);
  EXPECT_EQ(mission->seed(), 7U);
  for (const Held& note : notes) {
    const bool is_worlds = note.writer.topic == TopicId::Tick || note.writer.topic == TopicId::Sense;
    EXPECT_EQ(note.writer.from_world, is_worlds);
    const AgentId agent = head_of(note.writer.topic, note.payload).value().agent;
    EXPECT_EQ(note.writer.agent, note.writer.topic == TopicId::Sense ? agent : kWorldId);
    EXPECT_THAT(score.writers(), ::testing::Contains(note.writer));
  }
}

TEST(Score, BeginsWhereItIsToldAndStopsWhenNobodyWantsMore) {
  const mcap::Reader reader(small_file());
  const Score score(reader);
  const std::uint64_t from = 100'000'000'000;
  const std::vector<Held> notes = played(score, from);
  ASSERT_FALSE(notes.empty());
  EXPECT_GE(notes.front().log_time, from);
  EXPECT_LT(notes.size(), played(score, 0).size());
  EXPECT_EQ(played(score, 0, 3).size(), 3U);
}

TEST(Score, OfACutFileItPlaysWhatIsThere) {
  const auto& whole = small_file();
  const mcap::Reader uncut(whole);
  const mcap::ChunkIndex& last = uncut.contents().chunks.back();
  const mcap::ByteView cut =
      mcap::ByteView(whole).first(static_cast<std::size_t>(last.chunk_offset + last.chunk_length));
  const mcap::Reader reader(cut);
  EXPECT_THAT(reader.missing(), HasSubstr("it was cut"));
  EXPECT_EQ(played(Score(reader), 0).size() + 1, reader.contents().statistics.message_count);
}

/// A file with the samples that `keep` wants, of types named as `rename` says.
mcap::Bytes rewritten(const std::function<bool(std::string_view topic)>& keep, const std::string& version = "") {
  const mcap::Reader reader(small_file());
  mcap::Bytes out;
  mcap::Writer writer([&](mcap::ByteView bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); });
  for (const auto& [id, schema] : reader.contents().schemas) {
    (void)writer.add_schema(version.empty() ? schema.name : version, "omgidl", schema.data);
  }
  for (const auto& [id, channel] : reader.contents().channels) {
    (void)writer.add_channel(channel.schema_id, channel.topic, "cdr", channel.metadata);
  }
  reader.for_each([&](const mcap::Message& message) {
    if (keep(reader.contents().channels.at(message.channel_id).topic)) writer.write(message);
  });
  writer.finish();
  return out;
}

std::string refusal(const mcap::Bytes& file) {
  try {
    const mcap::Reader reader(file);
    const Score score(reader);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Score, SaysWhyAFileCannotBePlayed) {
  EXPECT_EQ(refusal(rewritten([](auto) { return true; })), "");
  EXPECT_THAT(refusal(rewritten([](auto topic) { return topic != "skein/mission"; })), HasSubstr("lacks the mission"));
  EXPECT_THAT(refusal(rewritten([](auto topic) { return topic != "skein/tick"; })), HasSubstr("no round of a run"));
  EXPECT_THAT(refusal(rewritten([](auto) { return true; }, "skein::v1::Tick")),
              HasSubstr("its samples are skein::v1::Tick; this version plays skein::v"));
}

TEST(Score, TakesThePaceOfPlanningFromItsScenario) {
  EXPECT_EQ(Score(mcap::Reader(small_file())).round_s(), LockstepOptions().round_s);
  Scenario slow = small_scenario("small", 7);
  slow.overrides.push_back({"planner.round_s", "0.5"});
  const mcap::Bytes file = record(slow, {}).file;
  EXPECT_EQ(Score(mcap::Reader(file)).round_s(), 0.5);
  EXPECT_EQ(Score(mcap::Reader(rewritten([](auto) { return true; }))).round_s(), LockstepOptions().round_s);
}

}  // namespace
}  // namespace skein::replay
