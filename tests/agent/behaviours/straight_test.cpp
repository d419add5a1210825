// A straight transit round by round: attraction, patience, announced zones, what the monitor says.
#include "agent/behaviours/straight.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/agent/behaviours/swarm_of.hpp"

namespace skein::test {
namespace {

const Vec3 kWest(-100.0, 0.0, 20.0);
const Vec3 kEast(100.0, 0.0, 20.0);
/// A take-off strip across the way, 20 m wide.
const Box kStrip{Vec3(-10.0, -200.0, -100.0), Vec3(10.0, 200.0, 100.0)};

Mission alone() {
  return straight_mission({kWest}, {kEast});
}

/// The strip is announced for 30 s to 40 s, may come 5 s early, and takes 8 s to leave.
Mission at_the_strip() {
  Mission mission = alone();
  mission.announced = {{kStrip, 30.0, 40.0, 5.0, 8.0}};
  return mission;
}

bool is_in_strip(const VehicleState& state) {
  return std::fabs(state.position_m.x()) < 10.5 && std::fabs(state.position_m.y()) < 200.5;
}

TEST(StraightBehaviour, IsReadyAtOnceAndRefusesWhatItCannotFly) {
  StraightBehaviour behaviour(alone(), 1);
  Tick tick;
  tick.phase = Phase::Planning;
  const RoundOutput out = behaviour.on_round({tick});
  EXPECT_EQ(out.mode, AgentMode::Ready);
  EXPECT_EQ(out.planned_length_m, 200.0);
  EXPECT_FALSE(behaviour.can_use(Representative{}));
  tick.phase = Phase::Flying;
  EXPECT_THROW((void)behaviour.on_round({tick}), std::invalid_argument);

  Mission other = alone();
  other.transit->planner.name = "peach3d";
  EXPECT_THROW(StraightBehaviour(other, 1), std::invalid_argument);
  other = alone();
  other.vehicles[0].type = VehicleType::Holonomic;
  EXPECT_THROW(StraightBehaviour(other, 1), std::invalid_argument);
  EXPECT_THROW(StraightBehaviour(alone(), 2), std::invalid_argument);
}

TEST(StraightBehaviour, FliesTheLineAtItsSpeedAndComesToRestAtTheGoal) {
  SwarmOf swarm(alone());
  double fastest_mps = 0.0;
  while (swarm.outputs[0].mode != AgentMode::Arrived && swarm.steps < 400) {
    swarm.step();
    EXPECT_EQ(swarm.states[0].position_m.y(), 0.0);
    EXPECT_EQ(swarm.outputs[0].safety_mode, SafetyMode::Autonomous);
    fastest_mps = std::max(fastest_mps, swarm.states[0].velocity_mps.norm());
  }
  EXPECT_NEAR(fastest_mps, 10.0, 1e-9);
  // at full speed 20 s, half of the acceleration to brake
  EXPECT_LT(swarm.steps, 275U);
  for (int k = 0; k < 100; ++k) {
    const double before_m = (kEast - swarm.states[0].position_m).norm();
    swarm.step();
    EXPECT_LE((kEast - swarm.states[0].position_m).norm(), before_m) << "no overshoot, no jitter";
  }
  EXPECT_NEAR((kEast - swarm.states[0].position_m).norm(), 0.0, 0.05);
}

TEST(StraightBehaviour, TwoFaceToFacePassEachOther) {
  SwarmOf swarm(straight_mission({kWest, kEast}, {kEast, kWest}));
  EXPECT_TRUE(swarm.arrive_within(600));
  EXPECT_GT(swarm.least_m, 1.0);
}

TEST(StraightBehaviour, WaitsBeforeAZoneUntilItIsConfirmedToBeClear) {
  SwarmOf swarm(at_the_strip());
  swarm.zones = {ZoneState::Unconfirmed};
  bool said = false;
  for (int k = 0; k < 600; ++k) {
    swarm.step();
    ASSERT_FALSE(is_in_strip(swarm.states[0]));
    said = said || (swarm.outputs[0].safety_mode == SafetyMode::Controlled &&
                    swarm.outputs[0].safety_reason == SafetyReason::Unconfirmed);
    ASSERT_EQ(swarm.outputs[0].mode, AgentMode::Flying) << "who waits loses no patience";
  }
  EXPECT_TRUE(said);
  EXPECT_GT(swarm.states[0].position_m.x(), -14.0) << "near the zone";
  swarm.zones = {ZoneState::Clear};
  EXPECT_TRUE(swarm.arrive_within(300));
}

TEST(StraightBehaviour, GoesThroughAZoneWhileItsTimeIsFarAway) {
  Mission mission = at_the_strip();
  mission.announced[0].from_s = 60.0;
  mission.announced[0].to_s = 80.0;
  SwarmOf swarm(mission);
  EXPECT_TRUE(swarm.arrive_within(300));
}

/// Over all times of announcement: nobody is in the zone from its earliest time on, whoever went in before is out.
TEST(StraightBehaviour, IsNeverInAZoneOnceItMayBeOccupied) {
  int passed = 0;
  int waited = 0;
  for (int tenths = 50; tenths < 400; tenths += 3) {
    Mission mission = at_the_strip();
    mission.announced[0].from_s = 0.1 * tenths + 5.0;
    mission.announced[0].to_s = mission.announced[0].from_s + 10.0;
    SwarmOf swarm(mission);
    for (int k = 0; k < 350; ++k) {
      const double time_s = 0.1 * swarm.steps;  // as the step opens
      if (time_s >= 0.1 * tenths) swarm.zones = {ZoneState::Unconfirmed};
      swarm.step();
      if (time_s + 0.1 >= 0.1 * tenths) {
        ASSERT_FALSE(is_in_strip(swarm.states[0])) << tenths;
      }
    }
    ++(swarm.outputs[0].mode == AgentMode::Arrived ? passed : waited);
  }
  EXPECT_GT(passed, 10);
  EXPECT_GT(waited, 10);
}

TEST(StraightBehaviour, GivesUpWhenNothingLeadsOn) {
  Mission mission = alone();
  mission.zones = {{kStrip, false}};
  mission.transit->planner.patience = 20.0;  // decisions of a second
  SwarmOf swarm(mission);
  for (int k = 0; k < 800 && swarm.outputs[0].mode != AgentMode::Deadlock; ++k) swarm.step();
  EXPECT_EQ(swarm.outputs[0].mode, AgentMode::Deadlock);
  EXPECT_FALSE(is_in_strip(swarm.states[0]));
}

TEST(StraightBehaviour, APeerThatIsNoLongerHeardIsStaleForTheHorizon) {
  Mission mission = straight_mission({kWest, kWest + Vec3(0.0, 60.0, 0.0)}, {kEast, kEast + Vec3(0.0, 60.0, 0.0)});
  mission.controller.horizon_s = 1.0;
  SwarmOf swarm(mission);
  for (int k = 0; k < 30; ++k) swarm.step();
  EXPECT_EQ(swarm.outputs[0].safety_mode, SafetyMode::Autonomous);
  swarm.silent = 2;
  for (int k = 0; k < 10; ++k) {
    swarm.step();
    EXPECT_EQ(swarm.outputs[0].safety_reason, SafetyReason::StalePeer) << k;
  }
  swarm.step();
  EXPECT_EQ(swarm.outputs[0].safety_reason, SafetyReason::None);
}

TEST(StraightBehaviour, TheSameFlightHasTheSameHash) {
  SwarmOf a(straight_mission({kWest, kEast}, {kEast, kWest}));
  SwarmOf b(straight_mission({kWest, kEast}, {kEast, kWest}));
  for (int k = 0; k < 150; ++k) {
    const std::uint64_t before = a.hash();
    a.step();
    b.step();
    ASSERT_EQ(a.hash(), b.hash());
    EXPECT_NE(a.hash(), before);
  }
}

}  // namespace
}  // namespace skein::test
