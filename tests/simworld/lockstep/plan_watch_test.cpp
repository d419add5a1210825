// Whose plan was not accepted: three agents that publish a set of representatives in round 8, and fly from round 10 on.
#include "simworld/lockstep/plan_watch.hpp"

#include <gtest/gtest.h>

#include "planner/core/lockstep/plan_view.hpp"
#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

using test::closing;
using test::representative;
using test::roster_of;
using test::tick_of;

constexpr std::uint32_t kPublished = 8;

std::uint64_t view_of(const std::vector<AgentId>& ids, std::uint32_t round = kPublished) {
  std::vector<Representative> samples;
  samples.reserve(ids.size());
  for (const AgentId id : ids) samples.push_back(representative(id, round));
  return plan_view_of(samples, std::nullopt);
}

/// Representatives of the agents, each longer by `longer_m` than in the plan of round 8.
void publish(PlanWatch& watch, std::uint32_t round, AgentId count, double longer_m = 0.0) {
  Barrier barrier;
  barrier.open(tick_of(round, count), 0.0);
  for (AgentId id = 1; id <= count; ++id) {
    Beacon beacon = closing(id, round);
    beacon.representative = true;
    barrier.accept(beacon);
    Representative sample = representative(id, round);
    sample.path_length_m += longer_m;
    barrier.accept(sample);
  }
  watch.add({Phase::Planning, 0, round}, barrier, roster_of(count));
}

/// A flight round in which agent k says the k-th view.
void fly(PlanWatch& watch, std::uint32_t step, const std::vector<std::uint64_t>& views,
         AgentMode last_mode = AgentMode::Flying) {
  const auto count = static_cast<AgentId>(views.size());
  Barrier barrier;
  barrier.open(tick_of(step + 9, count, Phase::Flying), 0.0);
  for (AgentId id = 1; id <= count; ++id) {
    Beacon beacon = closing(id, step + 9, id == count ? last_mode : AgentMode::Flying);
    beacon.plan_view = views[id - 1];
    barrier.accept(beacon);
  }
  watch.add({Phase::Flying, step, step + 9}, barrier, roster_of(count));
}

TEST(PlanWatch, WhatAllPublishedIsWhatAllMayFly) {
  PlanWatch watch;
  publish(watch, kPublished, 3);
  const std::uint64_t view = view_of({1, 2, 3});
  fly(watch, 1, {view, view, view});
  fly(watch, 2, {view, 0, view});  // one that flies no plan of the swarm
  EXPECT_EQ(watch.unaccepted(), 0U);
  EXPECT_FALSE(watch.first().has_value());
}

TEST(PlanWatch, AViewThatNobodyElseHasIsNamedInEachRound) {
  PlanWatch watch;
  publish(watch, kPublished, 3);
  const std::uint64_t view = view_of({1, 2, 3});
  fly(watch, 1, {view, view, view});
  fly(watch, 2, {view, view_of({1, 2}), view});
  fly(watch, 3, {view, 77, 78});
  EXPECT_EQ(watch.unaccepted(), 3U);
  ASSERT_TRUE(watch.first().has_value());
  EXPECT_EQ(watch.first()->agent, 2U);
  EXPECT_EQ(watch.first()->step, 2U);
}

TEST(PlanWatch, APlanIsOnlyThatOfThoseWhoMadeIt) {
  PlanWatch watch;
  publish(watch, kPublished, 2);  // agent 3 came back since
  const std::uint64_t view = view_of({1, 2});
  fly(watch, 4, {view, view, view});
  EXPECT_EQ(watch.unaccepted(), 1U);
  EXPECT_EQ(watch.first()->agent, 3U);
}

TEST(PlanWatch, WhoseLossIsDecidedWithTheRoundHasNoPartInThePlan) {
  PlanWatch watch;
  Barrier barrier;
  barrier.open(tick_of(kPublished, 3), 0.0);
  for (AgentId id = 1; id <= 3; ++id) {
    Beacon beacon = closing(id, kPublished);
    beacon.representative = true;
    barrier.accept(beacon);
    barrier.accept(representative(id, kPublished));
  }
  watch.add({Phase::Planning, 0, kPublished}, barrier, roster_of(2));
  fly(watch, 1, {view_of({1, 2}), view_of({1, 2})});
  EXPECT_EQ(watch.unaccepted(), 0U);
  fly(watch, 2, {view_of({1, 2, 3}), view_of({1, 2})});
  EXPECT_EQ(watch.unaccepted(), 1U);
}

TEST(PlanWatch, AnOldPlanIsForThoseWhoArrivedByIt) {
  PlanWatch watch;
  publish(watch, kPublished, 3);
  const std::uint64_t before = view_of({1, 2, 3});
  publish(watch, kPublished + 1, 3, 5.0);
  std::vector<Representative> samples;
  for (const AgentId id : {1U, 2U, 3U}) {
    samples.push_back(representative(id, kPublished));
    samples.back().path_length_m += 5.0;
  }
  const std::uint64_t after = plan_view_of(samples, std::nullopt);
  fly(watch, 1, {after, after, before}, AgentMode::Arrived);
  EXPECT_EQ(watch.unaccepted(), 0U);
  fly(watch, 2, {after, after, before});
  EXPECT_EQ(watch.unaccepted(), 1U);
  EXPECT_EQ(watch.first()->agent, 3U);
}

TEST(PlanView, IsOfWhatWasSaidAndHeardInAnyOrder) {
  const std::vector<Representative> heard{representative(1, 4), representative(3, 4)};
  const Representative said = representative(2, 4);
  EXPECT_EQ(plan_view_of(heard, said), view_of({3, 2, 1}));
  EXPECT_NE(plan_view_of(heard, std::nullopt), view_of({3, 2, 1}));
  std::vector<Representative> altered = heard;
  altered[1].particle[1] += 1e-9;
  EXPECT_NE(plan_view_of(altered, said), plan_view_of(heard, said));
  EXPECT_EQ(plan_view_of({}, std::nullopt), 0U);
}

}  // namespace
}  // namespace skein
