// One round's answers: what completes it and what does not belong to it.
#include "simworld/lockstep/barrier.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

using test::closing;
using test::representative;

Barrier open_round(std::uint32_t round) {
  Barrier barrier;
  barrier.open(test::tick_of(round, 2), 3.5);
  return barrier;
}

TEST(Barrier, IsCompleteWhenEverybodyHasClosed) {
  Barrier barrier = open_round(4);
  EXPECT_EQ(barrier.opened_s(), 3.5);
  EXPECT_FALSE(barrier.complete());
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1, 2}));
  EXPECT_TRUE(barrier.accept(closing(2, 4)));
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1}));
  EXPECT_TRUE(barrier.accept(closing(1, 4)));
  EXPECT_TRUE(barrier.complete());
}

TEST(Barrier, WaitsForTheSampleThatABeaconCounts) {
  Barrier barrier = open_round(4);
  barrier.accept(closing(2, 4));
  Beacon beacon = closing(1, 4);
  beacon.representative = true;
  EXPECT_TRUE(barrier.accept(beacon));
  EXPECT_FALSE(barrier.complete());
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1}));
  EXPECT_TRUE(barrier.accept(representative(1, 4)));
  EXPECT_TRUE(barrier.complete());
  EXPECT_EQ(barrier.answer_of(1)->representative, representative(1, 4));
}

TEST(Barrier, WaitsForTheObstacleMapThatABeaconCounts) {
  Barrier barrier = open_round(4);
  barrier.accept(closing(2, 4));
  Beacon beacon = closing(1, 4);
  beacon.representative = true;
  beacon.obstacle_map = true;
  EXPECT_TRUE(barrier.accept(beacon));
  EXPECT_TRUE(barrier.accept(representative(1, 4)));
  EXPECT_FALSE(barrier.complete());
  EXPECT_FALSE(barrier.accept(test::map_sample(1, 3)));
  EXPECT_FALSE(barrier.accept(test::map_sample(3, 4)));
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1}));
  EXPECT_EQ(barrier.lacking_beacons(), 0U);
  EXPECT_TRUE(barrier.accept(test::map_sample(1, 4)));
  EXPECT_TRUE(barrier.complete());
  EXPECT_FALSE(barrier.accept(test::map_sample(1, 4, 2))) << "a copy changes nothing";
  EXPECT_EQ(barrier.answer_of(1)->obstacle_map, test::map_sample(1, 4));
  EXPECT_FALSE(barrier.answer_of(2)->obstacle_map.has_value());
}

TEST(Barrier, CountsTheBeaconsThatItLacks) {
  Barrier barrier = open_round(4);
  EXPECT_EQ(barrier.lacking_beacons(), 2U);
  barrier.accept(representative(1, 4));
  EXPECT_EQ(barrier.lacking_beacons(), 2U);
  barrier.accept(closing(1, 4));
  EXPECT_EQ(barrier.lacking_beacons(), 1U);
  barrier.excuse(2);
  EXPECT_EQ(barrier.lacking_beacons(), 0U);
}

TEST(Barrier, TakesASampleBeforeItsBeacon) {
  Barrier barrier = open_round(4);
  EXPECT_TRUE(barrier.accept(representative(1, 4)));
  EXPECT_FALSE(barrier.complete());
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1, 2}));
}

TEST(Barrier, CopiesChangeNothing) {
  Barrier barrier = open_round(4);
  barrier.accept(closing(1, 4));
  Beacon other = closing(1, 4, AgentMode::Failed);
  EXPECT_FALSE(barrier.accept(other));
  EXPECT_EQ(barrier.answer_of(1)->beacon->mode, AgentMode::Planning);
  barrier.accept(representative(1, 4));
  Representative changed = representative(1, 4);
  changed.cost = 99.0;
  EXPECT_FALSE(barrier.accept(changed));
  EXPECT_EQ(barrier.answer_of(1)->representative->cost, 0.0);
}

TEST(Barrier, OtherRoundsIncarnationsAndAgentsAreNotOfThisRound) {
  Barrier barrier = open_round(4);
  EXPECT_FALSE(barrier.accept(closing(1, 3)));
  EXPECT_FALSE(barrier.accept(closing(1, 5)));
  EXPECT_FALSE(barrier.accept(representative(1, 3)));
  Beacon reborn = closing(1, 4);
  reborn.incarnation = 2;
  EXPECT_FALSE(barrier.accept(reborn));
  EXPECT_FALSE(barrier.accept(closing(3, 4)));
  Beacon open = closing(1, 4);
  open.closes_round = false;
  EXPECT_FALSE(barrier.accept(open));
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1, 2}));
  EXPECT_EQ(barrier.answer_of(3), nullptr);
}

TEST(Barrier, ExcusedAgentsNeedNotAnswer) {
  Barrier barrier = open_round(4);
  barrier.accept(closing(1, 4));
  barrier.excuse(2);
  barrier.excuse(9);
  EXPECT_TRUE(barrier.complete());
  EXPECT_TRUE(barrier.waiting_for().empty());
}

TEST(Barrier, OpeningForgetsTheRoundBefore) {
  Barrier barrier = open_round(4);
  barrier.accept(closing(1, 4));
  barrier.excuse(2);
  barrier.open(test::tick_of(5, 2), 4.0);
  EXPECT_EQ(barrier.waiting_for(), (std::vector<AgentId>{1, 2}));
  EXPECT_FALSE(barrier.answer_of(1)->beacon.has_value());
}

}  // namespace
}  // namespace skein
