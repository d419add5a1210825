#include "planner/rendezvous/ph/spatial_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/ph/spatial_hermite.hpp"
#include "planner/rendezvous/ph/torsion_bound.hpp"

namespace skein::rendezvous::ph {
namespace {

Pose pose(double x, double y, double z, double heading_rad, double climb_rad) {
  return {Vec3(x, y, z), heading_rad, climb_rad};
}

TEST(SpatialPath, APointHasNoLength) {
  const SpatialPath path;
  EXPECT_EQ(path.length_m(), 0.0);
  EXPECT_EQ(path.position(0.5), Vec3(Vec3::Zero()));
}

TEST(SpatialPath, ByHand) {
  // a = (1, q, q^2): A0 = (1, 0, 0), A1 = (1, 1/2, 0), A2 = (1, 1, 1).
  const SpatialPath path(Vec3(1.0, 2.0, 3.0), {}, {Vec3(1, 0, 0), Vec3(1, 0.5, 0), Vec3(1, 1, 1)});
  // r' = (1 - q^2 - q^4, 2 q, 2 q^2), sigma = 1 + q^2 + q^4.
  EXPECT_DOUBLE_EQ(path.length_m(), 1.0 + 1.0 / 3.0 + 1.0 / 5.0);
  EXPECT_NEAR((path.position(1.0) - Vec3(1.0 + 1.0 - 1.0 / 3.0 - 1.0 / 5.0, 3.0, 3.0 + 2.0 / 3.0)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(path.speed(0.5), 1.0 + 0.25 + 0.0625);
  // At q = 0: r' = (1, 0, 0), r'' = (0, 2, 0), r''' = (-2, 0, 4): kappa = 2, tau = 8 / 4.
  EXPECT_DOUBLE_EQ(path.curvature(0.0), 2.0);
  EXPECT_DOUBLE_EQ(path.torsion(0.0), 2.0);
  EXPECT_NEAR((path.direction(0.0) - Vec3::UnitX()).norm(), 0.0, 1e-15);
}

TEST(SpatialHermite, AStraightClimb) {
  const double climb_rad = math::atan(1.0);
  const SpatialHermite hermite(pose(0, 0, 0, 0.0, climb_rad), pose(10, 0, 10, 0.0, climb_rad));
  const SpatialPath path = hermite.path({9.0, 12.0});
  EXPECT_NEAR(path.length_m(), 10.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(path.curvature(0.3), 0.0, 1e-12);
  EXPECT_EQ(path.torsion(0.3), 0.0);
  EXPECT_TRUE(torsion_within(path, 1e-9));
}

TEST(SpatialHermite, AVerticalChordIsTaken) {
  const SpatialHermite hermite(pose(0, 0, 0, 0.3, 1.0), pose(0, 0, 100, -2.0, 0.7));
  const SpatialPath path = hermite.path({110.0, 120.0});
  EXPECT_NEAR((path.position(1.0) - Vec3(0, 0, 100)).norm(), 0.0, 1e-12);
  EXPECT_GT(path.length_m(), 100.0);
}

TEST(SpatialHermite, ReversedDirectionsAreTaken) {
  const SpatialHermite hermite(pose(0, 0, 0, math::kPi, 0.0), pose(50, 0, 0, math::kPi, 0.0));
  const SpatialPath path = hermite.path({60.0, 70.0});
  EXPECT_NEAR((path.position(1.0) - Vec3(50, 0, 0)).norm(), 0.0, 1e-11);
  EXPECT_NEAR((path.direction(0.0) + Vec3::UnitX()).norm(), 0.0, 1e-12);
}

TEST(SpatialHermite, AVerticalPlaneHasNoTorsion) {
  const SpatialHermite hermite(pose(0, 0, 0, 0.7, 0.5), pose(70, 70 * math::tan(0.7), 20, 0.7, -0.4));
  const SpatialPath path = hermite.path({90.0, 150.0});
  for (const double q : {0.0, 0.3, 0.5, 0.9}) EXPECT_EQ(path.torsion(q), 0.0);
  EXPECT_TRUE(torsion_within(path, 1e-9));
}

TEST(SpatialHermite, CoincidingPositionsAreRefused) {
  EXPECT_THROW(SpatialHermite(pose(1, 1, 1, 0, 0), pose(1, 1, 1, 1, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous::ph
