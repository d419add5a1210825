// Flight over terrain: clearance from the ground, contacts with it, and the torsion that was flown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "simworld/collision/clearance.hpp"
#include "simworld/world/world.hpp"

namespace skein {
namespace {

/// One vehicle of radius 1 m that flies east at 10 m/s, 100 m up, over hills of 90 m every 628 m.
Mission over_hills(double height_m) {
  VehicleSpec spec;
  spec.id = 1;
  spec.start = {Vec3(0.0, 0.0, height_m), 0.0, 0.0};
  spec.slot_offset_m = Vec3(5000.0, 0.0, height_m);
  spec.speed_mps = 10.0;
  spec.max_curvature_per_m = 0.1;
  spec.radius_m = 1.0;
  spec.safety_radius_m = 5.0;
  Mission mission;
  mission.step_s = 1.0;
  mission.arrival_radius_m = 1.0;
  mission.vehicles = {spec};
  mission.terrain = Terrain{.a = 0.9, .unit_m = 100.0};
  return mission;
}

void fly(World& world, std::uint32_t steps, const Vec3& velocity_mps) {
  const VehicleCommand command{1, velocity_mps, false};
  for (std::uint32_t step = 1; step <= steps; ++step) world.advance(step, {&command, 1});
}

TEST(Terrain, ClearanceIsMeasuredFromTheGround) {
  const Mission mission = over_hills(100.0);
  World world(mission, OnAgentLoss::Remove);
  fly(world, 40, Vec3(10.0, 0.0, 0.0));
  // Over the top 10 m remain, 10 / sqrt(1 + 0.9^2) of which are the distance from the slopes at least.
  ASSERT_TRUE(world.min_clearance_m().has_value());
  EXPECT_NEAR(*world.min_clearance_m(), 10.0 / std::sqrt(1.81) - 1.0, 0.05);
  EXPECT_EQ(world.count(ContactKind::Terrain), 0U);
}

TEST(Terrain, TouchingIsCountedOnceAStretch) {
  World world(over_hills(50.0), OnAgentLoss::Remove);
  fly(world, 120, Vec3(10.0, 0.0, 0.0));  // 1200 m: two hills
  EXPECT_EQ(world.count(ContactKind::Terrain), 2U);
  EXPECT_EQ(world.contacts().front().vehicle, 1U);
  EXPECT_LT(*world.min_clearance_m(), 0.0);
}

TEST(Terrain, ClearanceOfAMotionIsNeverMoreThanBruteForceFinds) {
  const Mission mission = over_hills(100.0);
  VehicleState state = initial_state(mission.vehicles[0]);
  for (int k = 0; k < 60; ++k) {
    const Vec3 wanted(1.0, 0.3 * (k % 5 - 2), 0.2 * (k % 3 - 1));
    const VehicleStep step = advance_constant_speed(mission.vehicles[0], state, wanted, 1.0);
    double least_m = 1e9;
    for (std::size_t p = 1; p < kMotionPoints; ++p) {
      for (int i = 0; i <= 50; ++i) {
        const Vec3 here =
            step.motion.points_m[p - 1] + i / 50.0 * (step.motion.points_m[p] - step.motion.points_m[p - 1]);
        least_m = std::min(least_m, height_above_m(*mission.terrain, here));
      }
    }
    const double clearance = clearance_m(step.motion, *mission.terrain);
    const double found = least_m / tilt_of(*mission.terrain);
    EXPECT_LE(clearance, found + 1e-9) << "step " << k;
    EXPECT_GE(clearance, found - 0.02) << "step " << k;
    state = step.after;
  }
}

TEST(Torsion, OfAHelixIsFlown) {
  // Radius 100 m, rising 1 for each 2 m of circle: kappa = r / (r^2 + c^2), tau = c / (r^2 + c^2), c = 50 m.
  constexpr double kRadius_m = 100.0;
  constexpr double kRise_m = 50.0;
  const double span_m = std::sqrt(kRadius_m * kRadius_m + kRise_m * kRise_m);
  Mission mission = over_hills(0.0);
  mission.terrain.reset();
  mission.vehicles[0].start.climb_rad = std::asin(kRise_m / span_m);
  World world(mission, OnAgentLoss::Remove);
  for (std::uint32_t step = 1; step <= 100; ++step) {
    const double turned_rad = 10.0 * step / span_m;
    const VehicleCommand command{1, Vec3(kRadius_m * std::cos(turned_rad), kRadius_m * std::sin(turned_rad), kRise_m),
                                 false};
    world.advance(step, {&command, 1});
  }
  const double squared = span_m * span_m;
  EXPECT_NEAR(world.vehicle(1).max_curvature_per_m, kRadius_m / squared, 1e-4);
  EXPECT_NEAR(world.vehicle(1).max_torsion_per_m, kRise_m / squared, 1e-4);
}

TEST(Torsion, OfLevelFlightIsZero) {
  Mission mission = over_hills(0.0);
  mission.terrain.reset();
  World world(mission, OnAgentLoss::Remove);
  for (std::uint32_t step = 1; step <= 60; ++step) {
    const double heading_rad = 0.3 * std::sin(0.2 * step);
    const VehicleCommand command{1, Vec3(std::cos(heading_rad), std::sin(heading_rad), 0.0), false};
    world.advance(step, {&command, 1});
  }
  EXPECT_GT(world.vehicle(1).max_curvature_per_m, 1e-3);
  EXPECT_EQ(world.vehicle(1).max_torsion_per_m, 0.0);
}

}  // namespace
}  // namespace skein
