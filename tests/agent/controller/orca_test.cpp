#include "agent/controller/orca.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/core/random/random_stream.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

/// Least distance of the straight relative motion -apart + t w within the horizon.
double nearest_m(const Vec3& apart_m, const Vec3& w_mps, double horizon_s) {
  const double squared = w_mps.squaredNorm();
  const double at_s = squared > 0.0 ? std::clamp(apart_m.dot(w_mps) / squared, 0.0, horizon_s) : 0.0;
  return (apart_m - at_s * w_mps).norm();
}

TEST(Orca, ByHand) {
  // both at 1 m/s head on, 10 m apart, to keep 5 m: the cone's half angle is 30 degrees
  const HalfSpace half = reciprocal(Vec3(10, 0, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), 5.0, 0.5, 1e6, 0.1);
  EXPECT_NEAR(half.normal.x(), -0.5, 1e-12);
  // u = 2 sin 30 = 1 along the normal, half of it own: n . v >= -0.5 + 0.5
  EXPECT_NEAR(half.least_mps, 0.0, 1e-12);
}

TEST(Orca, ItsBoundaryIsThatOfTheCollisionsWithinTheHorizon) {
  int nearing = 0;
  for (std::uint64_t n = 0; n < 20000; ++n) {
    RandomStream random(9, 0, Purpose::Test, n);
    const auto any = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
    };
    const Vec3 apart_m = any(20);
    const double touch_m = random.uniform(0.1, 0.99) * apart_m.norm();
    const Vec3 own_mps = any(5);
    const Vec3 its_mps = any(5);
    const HalfSpace half = reciprocal(apart_m, own_mps, its_mps, touch_m, 1.0, 4.0, 0.1);
    ASSERT_NEAR(half.normal.norm(), 1.0, 1e-9);
    const double change = half.least_mps - half.normal.dot(own_mps);
    const bool hits = nearest_m(apart_m, own_mps - its_mps, 4.0) < touch_m;
    nearing += hits ? 1 : 0;
    ASSERT_EQ(change > 0.0, hits) << n;
    const Vec3 after_mps = own_mps + change * half.normal;  // on the boundary it just touches
    ASSERT_NEAR(nearest_m(apart_m, after_mps - its_mps, 4.0), touch_m, 1e-6) << n;
  }
  EXPECT_GT(nearing, 1000);
}

TEST(Orca, BothGiveHalf) {
  const Vec3 apart_m(12, 0.2, 0);
  const Vec3 a_mps(3, 0, 0);
  const Vec3 b_mps(-3, 0, 0);
  const HalfSpace a = reciprocal(apart_m, a_mps, b_mps, 2.0, 0.5, 6.0, 0.1);
  const HalfSpace b = reciprocal(-apart_m, b_mps, a_mps, 2.0, 0.5, 6.0, 0.1);
  EXPECT_NEAR((a.normal + b.normal).norm(), 0.0, 1e-12);
  const Vec3 after_mps =
      a_mps + (a.least_mps - a.normal.dot(a_mps)) * a.normal - b_mps - (b.least_mps - b.normal.dot(b_mps)) * b.normal;
  EXPECT_NEAR(nearest_m(apart_m, after_mps, 6.0), 2.0, 1e-9);
}

TEST(Orca, LeavesAWishThatKeepsClearAlone) {
  const VehicleSpec spec = test::multirotor_spec(1);
  const Neighbour other{2, Vec3(0, 30, 0), Vec3(5, 0, 0), 0.5, 4.0};
  const Vec3 wish_mps(9.1234, 0, 0.321);
  EXPECT_EQ(orca_velocity({}, spec, 0.1, {Vec3::Zero(), Vec3(9, 0, 0), {&other, 1}, {}, {}}, wish_mps), wish_mps);
}

TEST(Orca, StaysLevelInAPlanarScene) {
  const VehicleSpec spec = test::multirotor_spec(1);
  const Neighbour other{2, Vec3(20, 0.1, 0), Vec3(-9, 0, 0), 0.5, 4.0};
  Track track;
  track.position_m = Vec3(15, -3, 40);
  track.radius_m = 1.0;
  track.column = true;
  const std::vector<ZoneShape> zones{Cylinder{Vec2(20, 6), 2.0}};
  const Vec3 v =
      orca_velocity({}, spec, 0.1, {Vec3::Zero(), Vec3(9, 0, 0), {&other, 1}, {&track, 1}, zones}, Vec3(10, 0, 0));
  EXPECT_EQ(v.z(), 0.0);
  EXPECT_LE(v.norm(), 10.0 + 1e-9);
  EXPECT_GT((v - Vec3(10, 0, 0)).norm(), 0.1);
}

}  // namespace
}  // namespace skein
