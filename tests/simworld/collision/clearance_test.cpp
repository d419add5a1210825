// Separation and clearance of motions that can be worked out by hand.
#include "simworld/collision/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein {
namespace {

/// Straight and even from a to b.
Motion straight(const Vec3& a, const Vec3& b) {
  Motion motion;
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    motion.points_m[i] = a + static_cast<double>(i) / static_cast<double>(kMotionPoints - 1) * (b - a);
  }
  motion.length_m = (b - a).norm();
  return motion;
}

Zone cylinder(double x_m, double y_m, double radius_m, double z_min_m, double z_max_m) {
  return {Cylinder{Vec2(x_m, y_m), radius_m, z_min_m, z_max_m}, false};
}

TEST(Separation, OfParallelMotionsIsTheirOffset) {
  const Motion a = straight({0.0, 0.0, 0.0}, {10.0, 0.0, 0.0});
  const Motion b = straight({0.0, 3.0, 4.0}, {10.0, 3.0, 4.0});
  EXPECT_DOUBLE_EQ(separation_m(a, b), 5.0);
}

TEST(Separation, OfCrossingMotionsIsLeastBetweenTheEnds) {
  // both are at the origin halfway
  EXPECT_NEAR(separation_m(straight({-8.0, 0.0, 0.0}, {8.0, 0.0, 0.0}), straight({0.0, -8.0, 0.0}, {0.0, 8.0, 0.0})),
              0.0, 1e-12);
  // the second one is late by 4 m: relative position (x, 4 - x), least at x = 2
  EXPECT_NEAR(separation_m(straight({-8.0, 0.0, 0.0}, {8.0, 0.0, 0.0}), straight({0.0, -12.0, 0.0}, {0.0, 4.0, 0.0})),
              std::sqrt(8.0), 1e-12);
}

TEST(Separation, CountsTimeNotPlaceAlone) {
  // the paths cross, but the vehicles are there at different times
  const Motion a = straight({-2.0, 0.0, 0.0}, {14.0, 0.0, 0.0});
  const Motion b = straight({0.0, -14.0, 0.0}, {0.0, 2.0, 0.0});
  EXPECT_NEAR(separation_m(a, b), 12.0 / std::sqrt(2.0), 1e-12);
}

TEST(Separation, IsSymmetric) {
  const Motion a = straight({-7.0, 1.0, 2.0}, {8.0, 3.0, -1.0});
  const Motion b = straight({5.0, -6.0, 0.0}, {-4.0, 9.0, 1.0});
  EXPECT_EQ(separation_m(a, b), separation_m(b, a));
}

TEST(Clearance, OfAnUnboundedCylinderIsBesideIt) {
  const Zone zone = cylinder(0.0, 0.0, 3.0, -kUnboundedZ_m, kUnboundedZ_m);
  EXPECT_NEAR(clearance_m(straight({-8.0, 5.0, 0.0}, {8.0, 5.0, 0.0}), zone), 2.0, 1e-12);
  EXPECT_NEAR(clearance_m(straight({-8.0, 1.0, 0.0}, {8.0, 1.0, 0.0}), zone), -2.0, 1e-9);
  EXPECT_NEAR(clearance_m(straight({3.0, 4.0, 0.0}, {6.0, 8.0, 0.0}), zone), 2.0, 1e-12);
}

TEST(Clearance, OfALowCylinderIsAboveIt) {
  const Zone zone = cylinder(0.0, 0.0, 3.0, 0.0, 10.0);
  EXPECT_NEAR(clearance_m(straight({-8.0, 0.0, 12.0}, {8.0, 0.0, 12.0}), zone), 2.0, 1e-9);
  // past the upper rim: 3 beside, 4 above
  EXPECT_NEAR(clearance_m(straight({-8.0, 6.0, 14.0}, {8.0, 6.0, 14.0}), zone), 5.0, 1e-9);
  // inside, 1 m under the top and 2 m from the side
  EXPECT_NEAR(clearance_m(straight({1.0, 0.0, 9.0}, {1.0, 0.0, 9.5}), zone), -1.0, 1e-9);
}

TEST(Clearance, OfABox) {
  const Zone zone{Box{Vec3(-1.0, -2.0, 0.0), Vec3(1.0, 2.0, 10.0)}, true};
  EXPECT_NEAR(clearance_m(straight({-8.0, 5.0, 5.0}, {8.0, 5.0, 5.0}), zone), 3.0, 1e-12);
  EXPECT_NEAR(clearance_m(straight({4.0, 6.0, 5.0}, {4.0, 16.0, 5.0}), zone), 5.0, 1e-12);
  EXPECT_NEAR(clearance_m(straight({3.0, 4.0, 11.0}, {9.0, 4.0, 20.0}), zone), 3.0, 1e-12);
  EXPECT_NEAR(clearance_m(straight({-8.0, 0.0, 5.0}, {8.0, 0.0, 5.0}), zone), -1.0, 1e-12);
  EXPECT_NEAR(clearance_m(straight({-8.0, 0.0, 9.5}, {8.0, 0.0, 9.5}), zone), -0.5, 1e-12);
}

TEST(Clearance, IsContinuousBetweenThePointsOfTheMotion) {
  // a thin pillar midway between two of the five points
  const Zone zone = cylinder(6.0, 0.0, 0.1, -100.0, 100.0);
  EXPECT_NEAR(clearance_m(straight({0.0, 1.0, 0.0}, {16.0, 1.0, 0.0}), zone), 0.9, 1e-12);
}

}  // namespace
}  // namespace skein
