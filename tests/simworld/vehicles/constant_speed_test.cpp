// The constant-speed vehicle against arcs worked out by hand.
#include "simworld/vehicles/constant_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

const VehicleSpec kSpec = test::vehicle(1, Vec3(3.0, 4.0, 5.0), 0.0, Vec3::Zero());
const VehicleState kEastward{Vec3(3.0, 4.0, 5.0), Vec3(10.0, 0.0, 0.0)};

void expect_near(const Vec3& actual, const Vec3& expected, double tolerance) {
  EXPECT_LE((actual - expected).norm(), tolerance) << actual.transpose() << " instead of " << expected.transpose();
}

TEST(ConstantSpeed, StartsAtItsStartPoseAtItsSpeed) {
  VehicleSpec spec = kSpec;
  spec.start.heading_rad = math::kPi / 2.0;
  spec.start.climb_rad = math::kPi / 6.0;
  const VehicleState state = initial_state(spec);
  EXPECT_EQ(state.position_m, Vec3(3.0, 4.0, 5.0));
  expect_near(state.velocity_mps, Vec3(0.0, 10.0 * std::sqrt(3.0) / 2.0, 5.0), 1e-12);
}

TEST(ConstantSpeed, PoseSaysWhereAndWhichWay) {
  const Pose pose = pose_of({Vec3(1.0, 2.0, 3.0), Vec3(-5.0, 5.0, -std::sqrt(50.0))});
  EXPECT_EQ(pose.position_m, Vec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(pose.heading_rad, 0.75 * math::kPi, 1e-15);
  EXPECT_NEAR(pose.climb_rad, -0.25 * math::kPi, 1e-15);
}

TEST(ConstantSpeed, StraightOnInFiveEqualParts) {
  const VehicleStep step = advance_constant_speed(kSpec, kEastward, Vec3(2.0, 0.0, 0.0), 2.0);
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    expect_near(step.motion.points_m[i], Vec3(3.0 + 5.0 * static_cast<double>(i), 4.0, 5.0), 1e-12);
  }
  EXPECT_EQ(step.motion.curvature_per_m, 0.0);
  EXPECT_DOUBLE_EQ(step.motion.length_m, 20.0);
  expect_near(step.after.position_m, Vec3(23.0, 4.0, 5.0), 1e-12);
  EXPECT_EQ(step.after.velocity_mps, Vec3(10.0, 0.0, 0.0));
}

TEST(ConstantSpeed, ZeroAndOppositeCommandsKeepTheDirection) {
  for (const Vec3& command : {Vec3(0.0, 0.0, 0.0), Vec3(1e-200, 1e-200, 0.0), Vec3(-10.0, 0.0, 0.0)}) {
    const VehicleStep step = advance_constant_speed(kSpec, kEastward, command, 1.0);
    expect_near(step.after.position_m, Vec3(13.0, 4.0, 5.0), 1e-12);
    EXPECT_EQ(step.after.velocity_mps, Vec3(10.0, 0.0, 0.0));
  }
}

/// A quarter circle of the tightest radius, 10 m, is 5 pi metres long; `side` +1 to the left, -1 to the right.
void expect_quarter_circle(double side) {
  const double dt_s = 0.5 * math::kPi;
  const VehicleStep step = advance_constant_speed(kSpec, kEastward, Vec3(0.0, side * 3.0, 0.0), dt_s);
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    const double angle = math::kPi / 8.0 * static_cast<double>(i);
    const Vec3 on_arc(3.0 + 10.0 * math::sin(angle), 4.0 + side * 10.0 * (1.0 - math::cos(angle)), 5.0);
    expect_near(step.motion.points_m[i], on_arc, 1e-12);
  }
  EXPECT_NEAR(step.motion.curvature_per_m, 0.1, 1e-15);
  EXPECT_NEAR(step.motion.length_m, 5.0 * math::kPi, 1e-12);
  expect_near(step.after.position_m, Vec3(13.0, 4.0 + side * 10.0, 5.0), 1e-12);
  expect_near(step.after.velocity_mps, Vec3(0.0, side * 10.0, 0.0), 1e-12);
}

TEST(ConstantSpeed, QuarterCircleToTheLeft) {
  expect_quarter_circle(1.0);
}

TEST(ConstantSpeed, QuarterCircleToTheRight) {
  expect_quarter_circle(-1.0);
}

TEST(ConstantSpeed, TurnIsClampedToTheCurvatureLimit) {
  // half a radian in 5 m at most, although the command is to the left and back
  const VehicleStep step = advance_constant_speed(kSpec, kEastward, Vec3(-1.0, 1.0, 0.0), 0.5);
  EXPECT_NEAR(step.motion.curvature_per_m, 0.1, 1e-15);
  EXPECT_NEAR(pose_of(step.after).heading_rad, 0.5, 1e-14);
  expect_near(step.after.position_m, Vec3(3.0 + 10.0 * math::sin(0.5), 4.0 + 10.0 * (1.0 - math::cos(0.5)), 5.0),
              1e-12);
}

TEST(ConstantSpeed, TurnWithinTheLimitEndsInTheCommandedDirection) {
  const VehicleStep step = advance_constant_speed(kSpec, kEastward, Vec3(math::cos(0.2), math::sin(0.2), 0.0), 1.0);
  EXPECT_NEAR(step.motion.curvature_per_m, 0.02, 1e-15);
  expect_near(step.after.velocity_mps, Vec3(10.0 * math::cos(0.2), 10.0 * math::sin(0.2), 0.0), 1e-12);
  const double radius_m = 50.0;
  expect_near(step.after.position_m,
              Vec3(3.0 + radius_m * math::sin(0.2), 4.0 + radius_m * (1.0 - math::cos(0.2)), 5.0), 1e-12);
}

TEST(ConstantSpeed, TurnsInAnyPlaneOfSpace) {
  // straight up from eastward flight: the quarter circle stands upright
  const VehicleStep step = advance_constant_speed(kSpec, kEastward, Vec3(0.0, 0.0, 1.0), 0.5 * math::kPi);
  expect_near(step.after.position_m, Vec3(13.0, 4.0, 15.0), 1e-12);
  expect_near(step.after.velocity_mps, Vec3(0.0, 0.0, 10.0), 1e-12);
  const double part = math::kPi / 4.0;
  expect_near(step.motion.points_m[2], Vec3(3.0 + 10.0 * math::sin(part), 4.0, 5.0 + 10.0 * (1.0 - math::cos(part))),
              1e-12);
}

TEST(ConstantSpeed, ThousandsOfRandomStepsKeepSpeedAndLimit) {
  RandomStream random(11, 1, Purpose::Test, 0);
  VehicleState state = kEastward;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 command(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0));
    const VehicleStep step = advance_constant_speed(kSpec, state, command, 0.7);
    ASSERT_NEAR(step.after.velocity_mps.norm(), 10.0, 1e-12);
    ASSERT_LE(step.motion.curvature_per_m, 0.1 + 1e-15);
    ASSERT_EQ(step.motion.points_m.front(), state.position_m);
    ASSERT_EQ(step.motion.points_m.back(), step.after.position_m);
    // equal parts of an arc have equal chords, a little shorter than the arc
    const double chord_m = (step.motion.points_m[1] - step.motion.points_m[0]).norm();
    ASSERT_NEAR((step.motion.points_m[4] - step.motion.points_m[3]).norm(), chord_m, 1e-10);
    ASSERT_LE(chord_m, 7.0 / 4.0 + 1e-12);
    ASSERT_GE(chord_m, 7.0 / 4.0 * (1.0 - 0.175 * 0.175 / 24.0) - 1e-10);
    state = step.after;
  }
}

}  // namespace
}  // namespace skein
