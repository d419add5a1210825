// Rounds as bytes: what goes in comes out, and nothing else does.
#include "simworld/checkpoint/round_record.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

const std::vector<AgentId> kIds{1, 2, 3};

WireContext context() {
  WireContext context;
  context.run = test::kRun;
  context.known = kIds;
  return context;
}

RoundInputs full_round() {
  RoundInputs inputs;
  inputs.round = 9;
  inputs.world_hash = 0x0123456789abcdefULL;
  inputs.roster = test::roster_of(3);
  inputs.lost = {{2, LossReason::Deadline}, {3, LossReason::ProcessEnded}};
  inputs.back = {{2, 4, 777, false, false}};
  inputs.figures.now_s = 12.5;
  inputs.figures.times = {1.0, 2.0, -1.0, -1.0};
  inputs.figures.topics.sense = {5, 600};
  inputs.figures.late_steps = 3;
  Answer first;
  first.beacon = test::closing(1, 9);
  first.beacon->representative = true;
  first.representative = test::representative(1, 9);
  Answer second;
  second.beacon = test::closing(2, 9, AgentMode::Flying);
  second.obstacle_map = test::map_sample(2, 9, 3);
  inputs.answers = {first, second};
  return inputs;
}

TEST(RoundRecord, WhatGoesInComesOut) {
  const RoundInputs in = full_round();
  const RoundInputs out = round_inputs_from(to_bytes(in), context()).value();
  EXPECT_EQ(out.round, in.round);
  EXPECT_EQ(out.world_hash, in.world_hash);
  EXPECT_EQ(out.roster, in.roster);
  EXPECT_EQ(out.back, in.back);
  ASSERT_EQ(out.lost.size(), 2U);
  EXPECT_EQ(out.lost[1].agent, 3U);
  EXPECT_EQ(out.lost[1].reason, LossReason::ProcessEnded);
  EXPECT_EQ(out.figures.now_s, 12.5);
  EXPECT_EQ(out.figures.times.started_s, 2.0);
  EXPECT_EQ(out.figures.topics.sense.bytes, 600U);
  EXPECT_EQ(out.figures.late_steps, 3U);
  ASSERT_EQ(out.answers.size(), 2U);
  EXPECT_EQ(out.answers[0].beacon, in.answers[0].beacon);
  EXPECT_EQ(out.answers[0].representative, in.answers[0].representative);
  EXPECT_FALSE(out.answers[0].obstacle_map.has_value());
  EXPECT_EQ(out.answers[1].beacon, in.answers[1].beacon);
  EXPECT_EQ(out.answers[1].obstacle_map, in.answers[1].obstacle_map);
  EXPECT_EQ(to_bytes(out), to_bytes(in));
}

TEST(RoundRecord, LessOrMoreIsRefused) {
  Bytes bytes = to_bytes(full_round());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_FALSE(round_inputs_from(std::span(bytes).first(length), context()).has_value()) << length;
  }
  bytes.push_back(0);
  EXPECT_FALSE(round_inputs_from(bytes, context()).has_value());
}

TEST(RoundRecord, AnAnswerOfAnotherRunOrAStrangerIsRefused) {
  const Bytes bytes = to_bytes(full_round());
  WireContext other = context();
  other.run = test::kRun + 1;
  EXPECT_FALSE(round_inputs_from(bytes, other).has_value());
  const std::vector<AgentId> fewer{1, 3};
  other = context();
  other.known = fewer;
  EXPECT_FALSE(round_inputs_from(bytes, other).has_value());
}

}  // namespace
}  // namespace skein
