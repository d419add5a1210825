#include "agent/controller/safety_filter.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planner/core/geometry/distance.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

ControllerOptions sensing(double range_m, double u_mps) {
  ControllerOptions options;
  options.sensor_range_m = range_m;
  options.obstacle_speed_mps = u_mps;
  return options;
}

SafetyFilter filter_of(const ControllerOptions& options, double radius_m = 0.5) {
  return {options, test::multirotor_spec(1, radius_m), 0.1, kFar};
}

Track fixed_at(const Vec3& place_m, double radius_m = 1.0) {
  Track t;
  t.id = 1;
  t.position_m = place_m;
  t.radius_m = radius_m;
  t.fixed = true;
  return t;
}

/// Where a wish that never changes ends, and the least distance to a track's centre on the way.
struct Flight {
  VehicleState state;
  double least_m = kFar;
};
Flight fly(const SafetyFilter& filter, VehicleState state, const Track& track, const Vec3& wish_mps, int steps) {
  Flight f{state, kFar};
  for (int n = 0; n < steps; ++n) {
    const Scene scene{f.state.position_m, f.state.velocity_mps, {}, {&track, 1}, {}};
    const Steering s = filter.pass(scene, wish_mps);
    f.state = advance_multirotor(test::multirotor_spec(1), f.state, s.velocity_mps, 0.1).after;
    f.least_m = std::min(f.least_m, (f.state.position_m - track.position_m).norm());
  }
  return f;
}

TEST(SafetyFilter, LeavesAWishAloneWithNothingNear) {
  const Vec3 wish_mps(9.123456789, -3.3, 0.7);
  const Steering s = filter_of({}).pass({Vec3(1, 2, 3), Vec3(4, 5, 6), {}, {}, {}}, wish_mps);
  EXPECT_EQ(s.velocity_mps, wish_mps);
  EXPECT_FALSE(s.overruled || s.braking || s.repelled);
}

TEST(SafetyFilter, CarriesTheSpeedOfTheInequality) {
  // radius 0.5, margin 0.25: S(v) + 5 m/s T(v) <= r - 0.75. 9.1 m/s brake in 23 steps, so 23.25 - 12 m are left for S
  const double cap_mps = filter_of(sensing(24, 5)).speed_cap_mps();
  EXPECT_NEAR(cap_mps, 9.094, 0.001);
  EXPECT_NEAR(stopping_distance_m({4.0, 0.1}, cap_mps), 11.25, 1e-6);
  EXPECT_NEAR(filter_of(sensing(24, 0)).speed_cap_mps(), 10.0, 1e-12);
  EXPECT_NEAR(filter_of(sensing(12, 5)).speed_cap_mps(), 5.2, 1e-6);  // 13 whole steps; a 14th costs 0.5 m
  EXPECT_EQ(filter_of({}).speed_cap_mps(), 10.0);
  const SafetyFilter by_radio(ControllerOptions{}, test::multirotor_spec(1), 0.1, 11.25);
  EXPECT_NEAR(stopping_distance_m({4.0, 0.1}, by_radio.speed_cap_mps()), 5.0, 1e-6);
}

TEST(SafetyFilter, StopsBeforeWhatIsFixed) {
  const SafetyFilter filter = filter_of({});
  for (const double off_m : {0.0, 0.3, 1.0}) {
    const Flight f = fly(filter, {Vec3::Zero(), Vec3(10, 0, 0)}, fixed_at(Vec3(30, off_m, 0)), Vec3(10, 0, 0), 300);
    EXPECT_GE(f.least_m, 1.75 - 1e-9);
    EXPECT_LE(f.least_m, 2.0);  // it goes as near as it may, and round
    EXPECT_GT(f.state.position_m.x(), 40.0);
  }
}

TEST(SafetyFilter, WhoIsTooNearMayLeaveButComeNoNearer) {
  const SafetyFilter filter = filter_of({});
  const Track track = fixed_at(Vec3::Zero());
  const VehicleState inside{Vec3(1.6, 0, 0), Vec3::Zero()};  // 1.75 m is the least
  const Flight out = fly(filter, inside, track, Vec3(10, 0, 0), 30);
  EXPECT_GT(out.state.position_m.x(), 10.0);
  EXPECT_GE(out.least_m, 1.6);
  const Flight in = fly(filter, inside, track, Vec3(-10, 0, 0), 100);
  EXPECT_GE(in.least_m, 1.6 - 1e-9);
  const Flight past = fly(filter, inside, track, Vec3(0, 10, 0), 50);
  EXPECT_GT(past.state.position_m.y(), 10.0);
  EXPECT_GE(past.least_m, 1.6 - 1e-9);
}

TEST(SafetyFilter, InsideAZoneTheWayOutIsOpen) {
  const SafetyFilter filter = filter_of({});
  const std::vector<ZoneShape> zones{Box{Vec3(-5, -5, -5), Vec3(5, 5, 5)}};
  const Scene scene{Vec3(4, 0, 0), Vec3::Zero(), {}, {}, zones};
  EXPECT_TRUE(filter.safe(scene, Vec3(1, 0, 0)));
  EXPECT_FALSE(filter.safe(scene, Vec3(-1, 0, 0)));
}

TEST(SafetyFilter, BesideAMoverAtRestNothingButRestIsSafe) {
  const SafetyFilter filter = filter_of(sensing(24, 5));
  Track track = fixed_at(Vec3(2.0, 0, 0));
  track.fixed = false;
  const Scene scene{Vec3::Zero(), Vec3::Zero(), {}, {&track, 1}, {}};
  const Steering s = filter.pass(scene, Vec3(-10, 0, 0));
  EXPECT_TRUE(s.overruled);
  EXPECT_EQ(s.velocity_mps.norm(), 0.0);
  track.position_m.x() = 1.75 + 1.1;  // 1 m is what it can do in the two steps of the least move
  EXPECT_TRUE(filter.safe(scene, Vec3(-10, 0, 0)));
}

TEST(SafetyFilter, AFasterMoverIsTakenAtItsSpeed) {
  const SafetyFilter filter = filter_of(sensing(24, 0));
  Track track = fixed_at(Vec3(4.0, 0, 0));
  track.fixed = false;
  const Scene scene{Vec3::Zero(), Vec3::Zero(), {}, {&track, 1}, {}};
  EXPECT_TRUE(filter.safe(scene, Vec3(0, 1, 0)));
  track.velocity_mps = Vec3(-15, 0, 0);
  EXPECT_FALSE(filter.safe(scene, Vec3(0, 1, 0)));
}

TEST(SafetyFilter, AColumnCountsByItsHorizontalDistance) {
  const SafetyFilter filter = filter_of({});
  Track track = fixed_at(Vec3(5, 0, 1000));
  const Scene scene{Vec3::Zero(), Vec3(5, 0, 0), {}, {&track, 1}, {}};
  EXPECT_TRUE(filter.safe(scene, Vec3(5, 0, 0)));
  track.column = true;
  EXPECT_FALSE(filter.safe(scene, Vec3(5, 0, 0)));
}

TEST(SafetyFilter, KeepsToTheOwnSideOfANeighbour) {
  const SafetyFilter filter = filter_of({});
  Neighbour other{2, Vec3(10, 0, 0), Vec3::Zero(), 0.5, 4.0};
  Scene scene{Vec3::Zero(), Vec3::Zero(), {&other, 1}, {}, {}};
  scene.velocity_mps = Vec3(5, 0, 0);  // own tail to x = 3.125: the plane is at 6.6 m, 0.6 from it is free
  EXPECT_TRUE(filter.safe(scene, Vec3(5, 0, 0)));
  scene.velocity_mps = Vec3(8, 0, 0);  // own tail to x = 8: nearer than 1.25 m to the other within braking
  EXPECT_TRUE(filter.safe(scene, Vec3(7.6, 0, 0)));
  EXPECT_FALSE(filter.safe(scene, Vec3(8.0, 0, 0)));
  other.position_m.x() = 4.0;  // tails touch: somebody has not kept to this
  EXPECT_TRUE(filter.pass(scene, Vec3(8, 0, 0)).braking);
}

TEST(SafetyFilter, AHolonomicVehicleMayFlyUpToTheMargin) {
  VehicleSpec spec = test::multirotor_spec(1);
  spec.type = VehicleType::Holonomic;
  spec.max_acceleration_mps2 = 0.0;
  const SafetyFilter filter({}, spec, 0.1, kFar);
  const Track track = fixed_at(Vec3(2.5, 0, 0));
  const Scene scene{Vec3::Zero(), Vec3(0, 10, 0), {}, {&track, 1}, {}};
  EXPECT_TRUE(filter.safe(scene, Vec3(7.4, 0, 0)));
  EXPECT_FALSE(filter.safe(scene, Vec3(7.6, 0, 0)));
  EXPECT_TRUE(filter.safe(scene, Vec3(-10, 0, 0)));
}

}  // namespace
}  // namespace skein
