// What a recorder did not hear at the end of a run is counted where ticks tell of it, and said where they do not.
#include "groundstation/record/heard_ends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "groundstation/record/gaps.hpp"
#include "idl/convert/cdr.hpp"
#include "idl/convert/convert.hpp"

namespace skein {
namespace {

using bus::TopicId;

constexpr std::uint8_t kTicks = 1;
constexpr std::uint8_t kSenses = 2;
constexpr std::uint8_t kBeacons = 3;  // and one more for each agent

bus::WriterKey key(std::uint8_t writer) {
  return {writer};
}

class HeardEndsTest : public ::testing::Test {
 protected:
  template <typename Value>
  void note(TopicId topic, std::uint8_t writer, const Value& value, bool from_world = false) {
    bus::RawSample sample;
    sample.topic = topic;
    sample.writer = key(writer);
    sample.sequence = ++sent[writer];
    sample.payload = to_cdr(to_wire(value, {}));
    ends.note(sample, from_world);
    gaps.note(sample, from_world, kWorldId);
  }
  void tick(std::uint32_t round, Phase phase = Phase::Flying, bool sense = false, bool representative = false) {
    Tick value;
    value.run = 9;
    value.round = round;
    value.phase = phase;
    value.roster = {{1, 1, 11}, {2, 4, 12}};
    for (RosterEntry& entry : value.roster) {
      entry.sense = sense;
      entry.representative = representative;
    }
    note(TopicId::Tick, kTicks, value, true);
  }
  void beacon(AgentId agent, std::uint32_t round) {
    Beacon value;
    value.run = 9;
    value.agent = agent;
    value.incarnation = agent == 1 ? 1 : 4;
    value.round = round;
    value.closes_round = true;
    note(TopicId::Beacon, static_cast<std::uint8_t>(kBeacons + agent), value);
  }
  void sense(AgentId agent, std::uint32_t round) {
    Sense value;
    value.run = 9;
    value.agent = agent;
    value.incarnation = 1;
    value.round = round;
    note(TopicId::Sense, kSenses, value, true);
  }
  HeardEnds ends;
  Gaps gaps;
  std::map<std::uint8_t, std::uint64_t> sent;
};

TEST_F(HeardEndsTest, ARunThatWasHeardToItsLastTickLostNothingAtItsEnd) {
  for (std::uint32_t round = 5; round <= 8; ++round) {
    tick(round, round == 8 ? Phase::Finished : Phase::Flying);
    if (round == 8) break;
    beacon(1, round);
    beacon(2, round);
  }
  for (const std::uint8_t writer : {kTicks, std::uint8_t{kBeacons + 1}, std::uint8_t{kBeacons + 2}}) {
    EXPECT_EQ(ends.of(key(writer)).heard, true);
    EXPECT_EQ(ends.of(key(writer)).lost, 0U);
  }
  gaps.conclude(ends);
  EXPECT_TRUE(gaps.end_heard());
  EXPECT_EQ(gaps.texts().at("end_heard"), "true");
}

TEST_F(HeardEndsTest, WithoutALastTickNobodysEndIsKnown) {
  tick(5);
  beacon(1, 5);
  beacon(2, 5);
  gaps.conclude(ends);
  EXPECT_FALSE(gaps.end_heard());
  EXPECT_EQ(ends.of(key(kTicks)).heard, false);
  EXPECT_EQ(gaps.lost(), 0U);
  EXPECT_EQ(gaps.texts().at("end_heard"), "false");
  EXPECT_EQ(gaps.texts().at("skein/tick of world"), "kept 1 lost 0 from 1 to 1, end not heard");
}

TEST_F(HeardEndsTest, BeaconsThatTicksCountAndNobodyHeardAreLost) {
  tick(5);
  beacon(1, 5);
  beacon(2, 5);
  tick(6);
  beacon(2, 6);
  tick(7);
  beacon(2, 7);
  tick(8, Phase::Finished);
  EXPECT_EQ(ends.of(key(kBeacons + 1)).heard, false);
  EXPECT_EQ(ends.of(key(kBeacons + 1)).lost, 2U);  // of rounds 6 and 7
  EXPECT_EQ(ends.of(key(kBeacons + 2)).heard, true);
  gaps.conclude(ends);
  EXPECT_EQ(gaps.lost(), 2U);
  EXPECT_FALSE(gaps.end_heard());
}

TEST_F(HeardEndsTest, ATickAfterAGapTellsOfTheRoundsBetween) {
  tick(5);
  beacon(1, 5);
  beacon(2, 5);
  tick(105, Phase::Finished);
  EXPECT_EQ(ends.of(key(kTicks)).heard, true);  // its numbers tell what is missing
  EXPECT_EQ(ends.of(key(kBeacons + 1)).lost, 99U);
}

TEST_F(HeardEndsTest, ASenseSampleThatATickAnnouncesIsAwaited) {
  tick(5, Phase::Flying, true);
  sense(1, 5);
  EXPECT_EQ(ends.of(key(kSenses)).lost, 0U);
  tick(6, Phase::Flying, true);
  tick(7, Phase::Finished);
  EXPECT_EQ(ends.of(key(kSenses)).heard, false);
  EXPECT_EQ(ends.of(key(kSenses)).lost, 1U);
}

TEST_F(HeardEndsTest, WhatOneWriterSaysNowAndThenNeedsEveryTickSince) {
  Representative value;
  value.run = 9;
  value.agent = 1;
  value.incarnation = 1;
  value.round = 5;
  tick(5);
  note(TopicId::Representative, 9, value);
  tick(6, Phase::Flying, false, true);
  tick(7, Phase::Finished);
  EXPECT_EQ(ends.of(key(9)).heard, true);
  HeardEndsTest::tick(9, Phase::Finished);  // tick 8 might have counted another one
  EXPECT_EQ(ends.of(key(9)).heard, false);
  EXPECT_EQ(ends.of(key(9)).lost, 0U);
}

TEST_F(HeardEndsTest, OfWhatNoTickTellsNothingIsSaid) {
  Inject inject;
  inject.run = 9;
  inject.injection.id = 1;
  note(TopicId::Inject, 20, inject);
  beacon(1, 5);
  Beacon repeated;
  repeated.run = 9;
  repeated.agent = 1;
  repeated.incarnation = 1;
  repeated.round = 5;
  note(TopicId::Beacon, 21, repeated, true);
  EXPECT_EQ(ends.of(key(20)).heard, std::nullopt);
  EXPECT_EQ(ends.of(key(21)).heard, std::nullopt);
  EXPECT_EQ(ends.of(key(99)).heard, std::nullopt);
}

}  // namespace
}  // namespace skein
