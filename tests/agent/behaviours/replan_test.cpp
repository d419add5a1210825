// A rendezvous under way, all of it but the world: what each agent does when the plan no longer holds.
#include <gtest/gtest.h>

#include <set>

#include "tests/agent/behaviours/surprise_run.hpp"
#include "tests/agent/behaviours/swarm_flight.hpp"

namespace skein::test {
namespace {

constexpr std::uint32_t kMaxStep = 3000;

Vec3 ahead_of(SwarmFlight& flight, AgentId id, double ahead_m) {
  const VehicleState& state = flight.flyer(id).state;
  return state.position_m + ahead_m * state.velocity_mps.normalized();
}

/// Flies to the end, and counts how often the swarm as a whole went from Replanning to something else.
int attempts_until_the_end(SwarmFlight& flight, std::uint32_t max_step = kMaxStep) {
  int attempts = 0;
  bool before = flight.anyone(AgentMode::Replanning);
  flight.fly_until(max_step, [&] {
    const bool now = flight.anyone(AgentMode::Replanning);
    if (before && !now) ++attempts;
    before = now;
    return flight.all_arrived();
  });
  return attempts;
}

TEST(Replan, WithoutASurpriseAllArriveTogether) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  const std::uint32_t planned = flight.rounds();
  EXPECT_EQ(attempts_until_the_end(flight), 0);
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_EQ(flight.rounds() - planned, flight.step() - 1) << "no planning under way";
}

TEST(Replan, AnObstacleOnAPathIsFlownAroundByAllTogether) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 2, 24.0), 2.0);
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_GT(flight.least_clearance_m(), 1.5);
  EXPECT_GT(flight.least_separation_m(), 4.0);
}

TEST(Replan, AllTurnToTheNewPlanInOneStepAndToOneLength) {
  SwarmFlight flight(surprise_mission(2));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 2, 24.0), 2.0);
  std::map<AgentId, std::uint32_t> turned;
  std::map<AgentId, AgentMode> before;
  flight.on_step = [&] {
    for (const auto& [id, flyer] : flight.flyers()) {
      if (before[id] == AgentMode::Replanning && flyer.out.mode == AgentMode::Flying) turned[id] = flight.step();
      before[id] = flyer.out.mode;
    }
  };
  flight.fly_until(kMaxStep, [&] { return flight.all_arrived(); });
  ASSERT_EQ(turned.size(), 3U);
  EXPECT_EQ(turned[1], turned[2]);
  EXPECT_EQ(turned[1], turned[3]);
  const double length_m = flight.flyer(1).out.planned_length_m;
  EXPECT_NEAR(flight.flyer(2).out.planned_length_m, length_m, 1e-8 * length_m);
  EXPECT_NEAR(flight.flyer(3).out.planned_length_m, length_m, 1e-8 * length_m);
}

TEST(Replan, WhileTheSwarmPlansTheMonitorSaysHold) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 2, 24.0), 2.0);
  flight.fly_until(kMaxStep, [&] { return flight.anyone(AgentMode::Replanning); });
  flight.fly_until(kMaxStep, [] { return true; });
  for (const auto& [id, flyer] : flight.flyers()) {
    EXPECT_EQ(flyer.out.mode, AgentMode::Replanning) << id;
    EXPECT_EQ(flyer.out.safety_mode, SafetyMode::Hold) << id;
    EXPECT_EQ(flyer.out.safety_reason, SafetyReason::Replanning) << id;
  }
}

TEST(Replan, ASlowVehicleIsNoticedAndThePlanFollowsItsSpeed) {
  SwarmFlight flight(surprise_mission(3));
  ASSERT_TRUE(flight.plan());
  flight.flyer(2).speed_factor = 0.8;
  bool noticed = false;
  flight.on_step = [&] { noticed = noticed || flight.flyer(2).out.safety_reason == SafetyReason::Deviation; };
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(noticed);
  EXPECT_TRUE(flight.arrived_together());
}

TEST(Replan, TwoWhoCallAtOnceMakeOneAttempt) {
  SwarmFlight flight(surprise_mission(4));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 1, 22.0), 1.0);
  flight.put_obstacle(ahead_of(flight, 3, 25.0), 2.0);
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_GT(flight.least_clearance_m(), 0.65) << "the radius, and the controller's margin";
}

TEST(Replan, WhoIsLostDuringAnAttemptIsGoneOnWithout) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 2, 24.0), 2.0);
  flight.fly_until(kMaxStep, [&] { return flight.anyone(AgentMode::Replanning); });
  for (int k = 0; k < 25; ++k) flight.round();
  flight.lose(2);
  flight.fly_until(kMaxStep, [&] { return flight.flyer(1).arrival_step > 0 && flight.flyer(3).arrival_step > 0; });
  EXPECT_GT(flight.flyer(1).arrival_step, 0U);
  EXPECT_EQ(flight.flyer(1).arrival_step, flight.flyer(3).arrival_step);
}

TEST(Replan, WhoComesBackCallsAndArrivesWithTheOthers) {
  SwarmFlight flight(surprise_mission(5));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(100);
  flight.lose(3);
  flight.fly_until(130);
  flight.bring_back(3);
  flight.fly_until(131);
  EXPECT_EQ(flight.flyer(3).out.mode, AgentMode::Replanning);
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(flight.arrived_together());
}

TEST(Replan, WhoComesBackDuringAnAttemptOpensANewOne) {
  SwarmFlight flight(surprise_mission(5));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(100);
  flight.lose(3);
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 1, 24.0), 2.0);
  flight.fly_until(130);
  EXPECT_EQ(flight.flyer(1).out.mode, AgentMode::Replanning);
  flight.bring_back(3);
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(flight.arrived_together());
}

TEST(Replan, WhoseVehicleIsNotItsOwnTakesNoPart) {
  SwarmFlight flight(surprise_mission(5));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(100);
  flight.lose(3);
  flight.bring_back(3);
  flight.flyer(3).obeyed = false;
  flight.fly_until(kMaxStep, [&] { return flight.flyer(1).arrival_step > 0 && flight.flyer(2).arrival_step > 0; });
  EXPECT_EQ(flight.flyer(3).out.mode, AgentMode::Rejoined);
  EXPECT_EQ(flight.flyer(1).arrival_step, flight.flyer(2).arrival_step);
}

TEST(Replan, WithoutAnySolutionAllStandAndSayWhy) {
  const Mission mission = surprise_mission(6);
  SwarmFlight flight(mission);
  ASSERT_TRUE(flight.plan());
  flight.put_obstacle(slot_pose(mission, mission.vehicles[0]).position_m, 3.0);
  flight.fly_until(1600);
  EXPECT_FALSE(flight.all_arrived());
  for (const auto& [id, flyer] : flight.flyers()) {
    EXPECT_EQ(flyer.out.safety_mode, SafetyMode::Hold) << id;
    EXPECT_EQ(flyer.out.safety_reason, SafetyReason::NoPlan) << id;
    EXPECT_LT(flyer.state.velocity_mps.norm(), 0.1) << id;
  }
  EXPECT_GT(flight.least_clearance_m(), 0.0);
  EXPECT_GT(flight.least_separation_m(), 4.0);
}

/// The same swarm that cannot stand still, and looks far ahead.
Mission winged_mission(std::uint64_t seed) {
  Mission mission = surprise_mission(seed);
  mission.controller.sensor_range_m = 150.0;
  for (VehicleSpec& vehicle : mission.vehicles) {
    vehicle.type = VehicleType::ConstantSpeed;
    vehicle.max_acceleration_mps2 = 0.0;
  }
  return mission;
}

/// Where an agent would be in a step if nothing came in between.
Vec3 place_on_way(const Mission& mission, AgentId id, std::uint32_t step) {
  SwarmFlight twin(mission);
  EXPECT_TRUE(twin.plan());
  twin.fly_until(step);
  return twin.flyer(id).state.position_m;
}

TEST(Replan, ConstantSpeedVehiclesFlyOnUntilTheSwitchAndArriveTogether) {
  SwarmFlight flight(winged_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(80);
  flight.put_obstacle(place_on_way(winged_mission(1), 2, 190), 2.0);
  EXPECT_EQ(attempts_until_the_end(flight), 1);
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_GT(flight.least_clearance_m(), 1.5);
  EXPECT_GT(flight.least_separation_m(), 4.0);
}

TEST(Replan, AConstantSpeedVehicleThatCannotFlyOnCircles) {
  SwarmFlight flight(winged_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(80);
  flight.put_obstacle(place_on_way(winged_mission(1), 2, 108), 2.0);
  bool circled = false;
  flight.on_step = [&] { circled = circled || flight.flyer(2).out.safety_reason == SafetyReason::NoPlan; };
  flight.fly_until(1500, [&] { return flight.all_arrived(); });
  EXPECT_TRUE(circled);
  EXPECT_GT(flight.least_clearance_m(), 1.0);
  EXPECT_TRUE(flight.all_arrived());
}

TEST(Replan, TheSameSeedGivesTheSameFlight) {
  EXPECT_EQ(run_surprise(3).hash, run_surprise(3).hash);
  EXPECT_NE(run_surprise(3).hash, run_surprise(4).hash);
}

}  // namespace
}  // namespace skein::test
