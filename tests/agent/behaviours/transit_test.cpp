// The behaviour of a transit, round by round: phases, motion between decisions, statuses, state hash.
#include "agent/behaviours/transit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/agent/behaviours/crossing.hpp"

namespace skein::test {
namespace {

TEST(TransitBehaviour, IsReadyAtOnce) {
  Crossing crossing(test::crossing());
  const RoundOutput out = crossing.behaviour.on_round({crossing.tick(Phase::Planning)});
  EXPECT_EQ(out.mode, AgentMode::Ready);
  EXPECT_EQ(out.commanded_velocity_mps, Vec3::Zero());
  EXPECT_EQ(out.planned_length_m, 68.0);
  EXPECT_FALSE(out.representative.has_value());
  EXPECT_FALSE(out.obstacle_map.has_value());
  EXPECT_FALSE(crossing.behaviour.can_use(Representative{}));
}

TEST(TransitBehaviour, RefusesWhatItCannotFly) {
  EXPECT_THROW(TransitBehaviour(abreast(1), 1), std::invalid_argument);
  EXPECT_THROW(TransitBehaviour(test::crossing(), 3), std::invalid_argument);
  Crossing crossing(test::crossing());
  EXPECT_THROW((void)crossing.behaviour.on_round({crossing.tick(Phase::Flying)}), std::invalid_argument);
}

TEST(TransitBehaviour, StaysUntilItsFirstIntentStands) {
  Crossing crossing(test::crossing());
  EXPECT_EQ(crossing.step().commanded_velocity_mps, Vec3::Zero());
  EXPECT_EQ(crossing.last.mode, AgentMode::Flying);
  EXPECT_EQ(crossing.last.generation, 1U);
  EXPECT_NEAR(crossing.last.cost, 68.0, 4.0);
  EXPECT_GT(crossing.step().commanded_velocity_mps.x(), 1.0);
}

class StepsOfADecision : public testing::TestWithParam<std::uint32_t> {};

TEST_P(StepsOfADecision, AreFlownStraightAtOneVelocity) {
  Crossing crossing(test::crossing(1.0 / GetParam()));
  for (std::uint32_t decision = 1; decision <= 6; ++decision) {
    const Vec3 from_m = crossing.position_m;
    const Vec3 velocity_mps = crossing.step().commanded_velocity_mps;
    EXPECT_LE(velocity_mps.norm(), 10.0 + 1e-9);
    for (std::uint32_t step = 1; step < GetParam(); ++step) {
      EXPECT_NEAR((crossing.step().commanded_velocity_mps - velocity_mps).norm(), 0.0, 1e-9);
      EXPECT_FALSE(crossing.last.obstacle_map.has_value());
    }
    EXPECT_EQ(crossing.last.generation, decision);
    EXPECT_NEAR((crossing.position_m - from_m - velocity_mps).norm(), 0.0, 1e-9) << "after a second";
  }
  EXPECT_GT(crossing.position_m.x(), kWest.x() + 25.0);
}

INSTANTIATE_TEST_SUITE_P(One, StepsOfADecision, testing::Values(1U, 2U, 5U),
                         [](const auto& steps) { return "Has" + std::to_string(steps.param); });

TEST(TransitBehaviour, ArrivesWithinTheGoalRadiusAndStaysThere) {
  Crossing crossing(test::crossing(0.5));
  while (crossing.steps < 60 && crossing.last.mode != AgentMode::Arrived) crossing.step();
  ASSERT_EQ(crossing.last.mode, AgentMode::Arrived);
  EXPECT_LE((crossing.position_m - kEast).norm(), 2.0);
  const Vec3 there_m = crossing.position_m;
  for (int step = 0; step < 4; ++step) crossing.step({peer_at(there_m + Vec3(0, 6, 0))});
  EXPECT_EQ(crossing.last.mode, AgentMode::Arrived);
  EXPECT_NEAR((crossing.position_m - there_m).norm(), 0.0, 1e-9);
  const RoundOutput last = crossing.behaviour.on_round({crossing.tick(Phase::Finished)});
  EXPECT_EQ(last.mode, AgentMode::Arrived);
  EXPECT_FALSE(last.obstacle_map.has_value());
}

TEST(TransitBehaviour, SaysUnreachableAndFliesAgainWhenThereIsAWay) {
  Crossing crossing(test::crossing());
  crossing.step({}, sight_of(wall_at(10)));
  EXPECT_EQ(crossing.last.mode, AgentMode::Unreachable);
  EXPECT_EQ(crossing.last.commanded_velocity_mps, Vec3::Zero());
  EXPECT_EQ(crossing.last.cost, 0.0);
  crossing.step({}, sight_of(wall_at(10)));
  EXPECT_EQ(crossing.position_m, kWest);
  crossing.step({}, sight_of(wall_at(10, 5)));
  EXPECT_EQ(crossing.last.mode, AgentMode::Flying);
  while (crossing.steps < 60 && crossing.last.mode != AgentMode::Arrived) crossing.step({}, sight_of(wall_at(10, 5)));
  EXPECT_EQ(crossing.last.mode, AgentMode::Arrived);
}

TEST(TransitBehaviour, ItsMapTakesInWhatItSees) {
  Crossing crossing(test::crossing());
  crossing.step({}, CellWindow{});
  const std::uint64_t nothing = crossing.last.map_hash;
  crossing.step({}, sight_of());
  const std::uint64_t free = crossing.last.map_hash;
  EXPECT_NE(free, nothing);
  crossing.step({}, sight_of());
  EXPECT_EQ(crossing.last.map_hash, free);
  crossing.step({}, sight_of({{19, 9, 0}}));
  EXPECT_NE(crossing.last.map_hash, free);
}

TEST(TransitBehaviour, LeavesOutWhatItSeesBeyondTheArea) {
  Crossing plain(test::crossing());
  Crossing wide(test::crossing());
  plain.step({}, sight_of());
  wide.step({}, free_block({-1, -1, 0}, 22, 12));
  EXPECT_EQ(wide.last.map_hash, plain.last.map_hash);
}

TEST(TransitBehaviour, TheSameRoundsGiveTheSameHashAndOthersAnother) {
  Crossing first(test::crossing(0.5));
  Crossing again(test::crossing(0.5));
  Crossing other(test::crossing(0.5));
  std::uint64_t before = 0;
  for (int step = 0; step < 12; ++step) {
    const std::vector<HeardPeer> heard{peer_at(Vec3(30, 18, 6))};
    const std::vector<ObstacleMapSample> maps{told(first.round())};
    first.step(heard, sight_of(), maps);
    again.step(heard, sight_of(), maps);
    other.step(heard, sight_of({{19, 9, 0}}), maps);
    EXPECT_EQ(first.hash(), again.hash()) << step;
    EXPECT_NE(first.hash(), other.hash()) << step;
    EXPECT_NE(first.hash(), before) << step;
    before = first.hash();
  }
}

}  // namespace
}  // namespace skein::test
