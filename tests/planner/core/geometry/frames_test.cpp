#include "planner/core/geometry/frames.hpp"

#include <gtest/gtest.h>

#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

TEST(Frames, DirectionsOfTheCompassAndUp) {
  Pose pose;
  EXPECT_TRUE(direction_of(pose).isApprox(Vec3(1.0, 0.0, 0.0)));
  pose.heading_rad = 0.5 * math::kPi;
  EXPECT_TRUE(direction_of(pose).isApprox(Vec3(0.0, 1.0, 0.0)));
  pose.climb_rad = 0.5 * math::kPi;
  EXPECT_TRUE(direction_of(pose).isApprox(Vec3(0.0, 0.0, 1.0)));
  pose = {Vec3::Zero(), math::kPi, math::kPi / 6.0};
  EXPECT_NEAR((direction_of(pose) - Vec3(-std::sqrt(0.75), 0.0, 0.5)).norm(), 0.0, 1e-15);
}

TEST(Frames, HeadingIsTheInverseOfDirection) {
  for (int k = -31; k <= 31; ++k) {
    const double heading = 0.1 * k;
    EXPECT_NEAR(heading_of(direction_of_heading(heading)), heading, 1e-14);
  }
  EXPECT_EQ(heading_of(Vec2::Zero()), 0.0);
}

TEST(Frames, RotationTurnsToTheLeft) {
  EXPECT_TRUE(rotated(Vec2(2.0, 0.0), 0.5 * math::kPi).isApprox(Vec2(0.0, 2.0)));
  EXPECT_TRUE(rotated(Vec2(1.0, 1.0), math::kPi).isApprox(Vec2(-1.0, -1.0)));
}

}  // namespace
}  // namespace skein
