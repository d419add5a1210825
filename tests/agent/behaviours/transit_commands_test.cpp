// A transit by cells that obeys the operator: what it says and flies in the rounds after an order.
#include <gtest/gtest.h>

#include <stdexcept>

#include "planner/core/lockstep/names.hpp"
#include "tests/agent/behaviours/crossing.hpp"

namespace skein::test {
namespace {

Order order(OrderKind kind, const Vec3& to_m = Vec3::Zero(), double speed_mps = 0.0) {
  return {1, 1, kind, to_m, speed_mps};
}

/// Tells it, and flies the round in which that takes effect.
const RoundOutput& told(Crossing& crossing, const Order& order, const std::vector<HeardPeer>& heard = {}) {
  EXPECT_TRUE(crossing.behaviour.obey(order));
  return crossing.step(heard);
}

void fly(Crossing& crossing, int steps) {
  for (int step = 0; step < steps; ++step) crossing.step();
}

class CommandedTransit : public testing::Test {
 protected:
  CommandedTransit() { fly(crossing, 6); }
  Crossing crossing{test::crossing(0.5)};  // two steps a decision: the seventh step begins one
};

TEST_F(CommandedTransit, HoldsWhereItIsAtTheNextDecision) {
  fly(crossing, 1);
  const Vec3 velocity_mps = crossing.last.commanded_velocity_mps;
  ASSERT_GT(velocity_mps.x(), 1.0);
  EXPECT_EQ(told(crossing, order(OrderKind::Hold)).mode, AgentMode::Holding) << "at once";
  EXPECT_NEAR((crossing.last.commanded_velocity_mps - velocity_mps).norm(), 0.0, 1e-9) << "to the end of its motion";
  EXPECT_EQ(crossing.last.safety_mode, SafetyMode::Hold);
  const Vec3 place_m = crossing.position_m;
  fly(crossing, 10);
  EXPECT_EQ(crossing.position_m, place_m);
  EXPECT_EQ(crossing.last.mode, AgentMode::Holding);
}

TEST_F(CommandedTransit, HoldsAtOnceWhereADecisionBegins) {
  const Vec3 place_m = crossing.position_m;
  EXPECT_EQ(told(crossing, order(OrderKind::Hold)).commanded_velocity_mps, Vec3::Zero());
  fly(crossing, 3);
  EXPECT_EQ(crossing.position_m, place_m);
}

TEST_F(CommandedTransit, GoesOnWithItsMission) {
  told(crossing, order(OrderKind::Hold));
  fly(crossing, 5);
  EXPECT_EQ(told(crossing, order(OrderKind::Resume)).mode, AgentMode::Flying);
  EXPECT_EQ(crossing.last.safety_mode, SafetyMode::Autonomous);
  while (crossing.steps < 80 && crossing.last.mode != AgentMode::Arrived) crossing.step();
  EXPECT_EQ(crossing.last.mode, AgentMode::Arrived);
}

TEST_F(CommandedTransit, TheLastOrderOfARoundStands) {
  EXPECT_TRUE(crossing.behaviour.obey(order(OrderKind::Hold)));
  EXPECT_EQ(told(crossing, order(OrderKind::Resume)).mode, AgentMode::Flying);
}

TEST_F(CommandedTransit, FliesToThePointAndHoldsThere) {
  const Vec3 point_m(41, 30, 6);
  EXPECT_EQ(told(crossing, order(OrderKind::Goto, point_m, 5.0)).mode, AgentMode::GoingTo);
  double fastest_mps = 0.0;
  fly(crossing, 1);
  for (int step = 0; step < 40; ++step)
    fastest_mps = std::max(fastest_mps, crossing.step().commanded_velocity_mps.norm());
  EXPECT_EQ(crossing.last.mode, AgentMode::Holding);
  EXPECT_EQ(crossing.last.safety_reason, SafetyReason::None);
  EXPECT_NEAR((crossing.position_m - point_m).norm(), 0.0, 1e-6);
  EXPECT_LE(fastest_mps, 5.0 + 1e-9);
}

TEST_F(CommandedTransit, HoldsShortOfWhatItCannotReachAndSaysWhy) {
  const std::vector<Cell> wall = wall_at(15);
  EXPECT_TRUE(crossing.behaviour.obey(order(OrderKind::Goto, Vec3(77, 18, 6))));
  for (int step = 0; step < 40; ++step) crossing.step({}, sight_of(wall));
  EXPECT_EQ(crossing.last.mode, AgentMode::Holding);
  EXPECT_EQ(crossing.last.safety_reason, SafetyReason::Blocked);
  EXPECT_NEAR((crossing.position_m - Vec3(58, 18, 6)).norm(), 0.0, 1e-6);
}

TEST_F(CommandedTransit, LandsWhereItsMotionEnds) {
  fly(crossing, 1);
  EXPECT_EQ(told(crossing, order(OrderKind::Land)).mode, AgentMode::Landing);
  const Vec3 place_m = crossing.position_m;
  fly(crossing, 1);
  EXPECT_EQ(crossing.last.mode, AgentMode::Landed);
  EXPECT_TRUE(crossing.behaviour.obey(order(OrderKind::Resume)));
  fly(crossing, 4);
  EXPECT_EQ(crossing.last.mode, AgentMode::Landed) << "its mission is over";
  EXPECT_EQ(crossing.position_m, place_m);
}

TEST_F(CommandedTransit, WhoLandedSaysNoIntent) {
  const HeardPeer near = peer_at(crossing.position_m + Vec3(0, 6, 0));
  told(crossing, order(OrderKind::Hold), {near});
  ASSERT_TRUE(crossing.last.obstacle_map.has_value());
  EXPECT_EQ(crossing.last.obstacle_map->intent.status, NavStatus::Held);
  EXPECT_EQ(crossing.last.obstacle_map->intent.to_m, crossing.position_m);
  crossing.step({near});
  told(crossing, order(OrderKind::Land), {near});
  EXPECT_EQ(crossing.last.mode, AgentMode::Landed);
  for (int step = 0; step < 20; ++step) crossing.step({near});
  EXPECT_FALSE(crossing.last.obstacle_map.has_value());
}

TEST_F(CommandedTransit, WhoArrivedIsToldInVain) {
  while (crossing.steps < 80 && crossing.last.mode != AgentMode::Arrived) crossing.step();
  for (const OrderKind kind : {OrderKind::Hold, OrderKind::Land, OrderKind::Resume}) {
    EXPECT_EQ(told(crossing, order(kind)).mode, AgentMode::Arrived) << name_of(kind);
  }
  EXPECT_EQ(told(crossing, order(OrderKind::Goto, kWest)).mode, AgentMode::Arrived);
}

TEST_F(CommandedTransit, WhoCameBackIsToldInVain) {
  const Mission mission = test::crossing();
  TransitBehaviour rejoined(mission, 1, true);
  EXPECT_TRUE(rejoined.obey(order(OrderKind::Hold)));
  Sense sense;
  sense.agent = 1;
  sense.pose.position_m = kWest;
  sense.velocity_mps = Vec3(3, 0, 0);
  const RoundOutput out = rejoined.on_round({crossing.tick(Phase::Flying), &sense});
  EXPECT_EQ(out.mode, AgentMode::Rejoined);
  EXPECT_EQ(out.commanded_velocity_mps, sense.velocity_mps);
}

TEST_F(CommandedTransit, ItsOrderIsInItsHash) {
  Crossing other(test::crossing(0.5));
  fly(other, 6);
  ASSERT_EQ(other.hash(), crossing.hash());
  told(crossing, order(OrderKind::Hold));
  other.step();
  EXPECT_NE(other.hash(), crossing.hash());
}

}  // namespace
}  // namespace skein::test
