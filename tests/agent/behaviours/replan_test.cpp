// A rendezvous under way, all of it but the world: what each agent does when the plan no longer holds.
#include <gtest/gtest.h>

#include <set>

#include "tests/agent/behaviours/swarm_flight.hpp"

namespace skein::test {
namespace {

constexpr std::uint32_t kMaxStep = 3000;

/// Where agent `id` will be along its straight way, roughly: a place ahead of it, `ahead_m` away.
Vec3 ahead_of(SwarmFlight& flight, AgentId id, double ahead_m) {
  const VehicleState& state = flight.flyer(id).state;
  return state.position_m + ahead_m * state.velocity_mps.normalized();
}

TEST(Replan, WithoutASurpriseAllArriveTogether) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  const std::uint32_t planned = flight.rounds();
  flight.fly_until(kMaxStep, [&] { return flight.all_arrived(); });
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_EQ(flight.rounds() - planned, flight.step() - 1) << "no planning under way";
}

TEST(Replan, AnObstacleOnAPathIsFlownAroundByAllTogether) {
  SwarmFlight flight(surprise_mission(1));
  ASSERT_TRUE(flight.plan());
  flight.fly_until(120);
  flight.put_obstacle(ahead_of(flight, 2, 24.0), 2.0);
  std::set<std::uint32_t> switched;
  bool replanning = false;
  flight.fly_until(kMaxStep, [&] {
    const bool now = flight.anyone(AgentMode::Replanning);
    if (replanning && !now) switched.insert(flight.step());
    replanning = now;
    return flight.all_arrived();
  });
  EXPECT_EQ(switched.size(), 1U);
  EXPECT_TRUE(flight.arrived_together());
  EXPECT_GT(flight.least_clearance_m(), 1.5);
  EXPECT_GT(flight.least_separation_m(), 3.5);
}

}  // namespace
}  // namespace skein::test
