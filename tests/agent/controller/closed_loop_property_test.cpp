// Only this proves that UAVs under the whole controller arrive, touch nothing while they move, and are seldom run over.
// tests/controller_scenes flies as many scenes as one likes (docs/safety.md has the figures).
#include <gtest/gtest.h>

#include "tests/agent/controller/scenes.hpp"

namespace skein::test {
namespace {

TEST(ClosedLoop, RandomScenesInsideTheGuarantee) {
  int rammed = 0;
  int incomplete = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Loop loop = random_scene(seed);
    const Tally tally = loop.run(180.0);
    ASSERT_EQ(tally.collisions + tally.peer_collisions, 0) << "seed " << seed;
    rammed += tally.rammed_at_rest > 0 ? 1 : 0;
    incomplete += tally.arrived < static_cast<int>(loop.flyers.size()) ? 1 : 0;
  }
  EXPECT_LE(rammed, 2);
  EXPECT_LE(incomplete, 1);
}

TEST(ClosedLoop, WhatNeverMovesIsNeverTouched) {
  int incomplete = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Loop loop = static_scene(seed);
    if (seed % 3 == 0) loop.options.name = "orca";
    const Tally tally = loop.run(120.0);
    ASSERT_EQ(tally.collisions + tally.peer_collisions + tally.rammed_at_rest, 0) << "seed " << seed;
    incomplete += tally.arrived < 6 ? 1 : 0;
  }
  EXPECT_LE(incomplete, 6);  // a field has its local minima: to find a way is the plan's part
}

TEST(ClosedLoop, TheSameSeedFliesTheSame) {
  Loop first = random_scene(12);
  Loop second = random_scene(12);
  EXPECT_EQ(first.run(180.0).steps, second.run(180.0).steps);
  for (std::size_t n = 0; n < first.flyers.size(); ++n) EXPECT_EQ(first.flyers[n].state, second.flyers[n].state);
}

TEST(ClosedLoop, SwarmsSwapPlacesOnASphere) {
  for (const char* name : {"apf", "orca"}) {
    for (const std::size_t uavs : {4U, 8U, 16U, 32U, 64U}) {
      Loop loop = sphere_swap(1, uavs);
      loop.options.name = name;
      const Tally tally = loop.run(180.0);
      EXPECT_EQ(tally.arrived, static_cast<int>(uavs)) << name;
      EXPECT_EQ(tally.collisions + tally.peer_collisions, 0) << name << " " << uavs;
    }
  }
}

TEST(ClosedLoop, WhoIsHeardLateIsNotTouched) {
  for (const double range_m : {24.0, 12.0, 6.0}) {
    Loop loop = sphere_swap(2, 32);
    loop.peer_range_m = range_m;
    const Tally tally = loop.run(180.0);
    EXPECT_EQ(tally.arrived, 32) << range_m;
    EXPECT_EQ(tally.collisions + tally.peer_collisions, 0) << range_m;
    EXPECT_GE(tally.least_peer_m, loop.options.margin_m - 1e-6) << range_m;
  }
}

TEST(ClosedLoop, TwoFaceToFaceAndOnOneHeightPass) {
  for (const char* name : {"apf", "orca"}) {
    Loop loop;
    loop.options.name = name;
    for (const double sign : {-1.0, 1.0}) {
      Flyer f;
      f.spec = multirotor_spec(static_cast<AgentId>(loop.flyers.size() + 1));
      f.state.position_m = Vec3(30.0 * sign, 0, 0);
      f.goal_m = -f.state.position_m;
      loop.flyers.push_back(f);
    }
    const Tally tally = loop.run(60.0);
    EXPECT_EQ(tally.arrived, 2) << name;
    EXPECT_EQ(tally.peer_collisions, 0) << name;
    EXPECT_LT(loop.flyers[0].way_m, 66.0) << name;
  }
}

TEST(ClosedLoop, AtTheGoalNobodyShakes) {
  Loop loop = random_scene(4);
  loop.obstacles.clear();
  loop.arrival_m = -1.0;
  loop.run(90.0);
  for (Flyer& f : loop.flyers) {
    EXPECT_LT((f.state.position_m - f.goal_m).norm(), 0.01);
    EXPECT_LT(f.state.velocity_mps.norm(), 0.01);
  }
}

}  // namespace
}  // namespace skein::test
