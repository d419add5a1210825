// Distances and overlaps of spheres, terrain and meshes by hand; of motions to obstacles of every shape.
#include "simworld/collision/obstacle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein {
namespace {

Motion straight(const Vec3& from, const Vec3& to) {
  Motion motion;
  for (std::size_t i = 0; i < kMotionPoints; ++i)
    motion.points_m[i] = from + (to - from) * (0.25 * static_cast<double>(i));
  motion.length_m = (to - from).norm();
  return motion;
}

/// A wall of two triangles in the plane x = 10, y and z from 0 to 4.
Mesh wall() {
  return Mesh({Vec3(10, 0, 0), Vec3(10, 4, 0), Vec3(10, 4, 4), Vec3(10, 0, 4)}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(Mesh, IsAsFarFromASegmentAsItsSurface) {
  EXPECT_NEAR(wall().distance_m(Vec3(0, 2, 2), Vec3(7, 2, 2)), 3.0, 1e-3);
  EXPECT_NEAR(wall().distance_m(Vec3(10, 7, 2), Vec3(20, 7, 2)), 3.0, 1e-3);
  EXPECT_NEAR(wall().distance_m(Vec3(6, -3, 2), Vec3(6, -3, 2)), 5.0, 1e-3) << "a vehicle that stands";
  EXPECT_EQ(wall().distance_m(Vec3(0, 2, 2), Vec3(20, 2, 2)), 0.0);
}

TEST(Mesh, OverlapsTheBoxesThatItsSurfaceEnters) {
  EXPECT_TRUE(wall().overlaps({Vec3(9, 1, 1), Vec3(11, 2, 2)}));
  EXPECT_FALSE(wall().overlaps({Vec3(6, 1, 1), Vec3(10, 2, 2)})) << "it only touches";
  EXPECT_FALSE(wall().overlaps({Vec3(9, 5, 1), Vec3(11, 6, 2)}));
}

TEST(Mesh, WithoutATriangleOrACornerIsRefused) {
  EXPECT_THROW(Mesh({Vec3::Zero()}, {}), std::invalid_argument);
  EXPECT_THROW(Mesh({Vec3::Zero(), Vec3::UnitX()}, {{0, 1, 2}}), std::invalid_argument);
}

TEST(Mesh, IsReadScaledAndMoved) {
  const MeshResult result = read_mesh(SKEIN_SOURCE_DIR "/tests/data/pyramid.obj", Vec3(10, 20, 30), 2.0);
  ASSERT_TRUE(std::holds_alternative<Mesh>(result));
  const Mesh& mesh = std::get<Mesh>(result);
  EXPECT_EQ(mesh.triangles(), 6U);
  EXPECT_EQ(mesh.bounds(), (Box{Vec3(6, 16, 30), Vec3(14, 24, 36)}));
  EXPECT_EQ(mesh, std::get<Mesh>(read_mesh(SKEIN_SOURCE_DIR "/tests/data/pyramid.obj", Vec3(10, 20, 30), 2.0)));
  EXPECT_TRUE(std::holds_alternative<std::string>(read_mesh("/no/such/file.obj", Vec3::Zero(), 1.0)));
}

TEST(Obstacle, AMotionKeepsItsDistanceFromEveryShape) {
  const Motion motion = straight(Vec3(0, 2, 2), Vec3(8, 2, 2));
  EXPECT_NEAR(clearance_m(motion, {Sphere{Vec3(4, 7, 2), 2.0}, ""}), 3.0, 1e-12);
  EXPECT_NEAR(clearance_m(motion, {Sphere{Vec3(4, 3, 2), 2.0}, ""}), -1.0, 1e-12);
  EXPECT_NEAR(clearance_m(motion, {Cylinder{Vec2(4, 7), 2.0}, ""}), 3.0, 1e-12);
  EXPECT_NEAR(clearance_m(motion, {Box{Vec3(9, 0, 0), Vec3(12, 4, 4)}, ""}), 1.0, 1e-12);
  EXPECT_NEAR(clearance_m(motion, {wall(), ""}), 2.0, 1e-3);
  EXPECT_NEAR(clearance_m(motion, {Terrain{.e = 1.0}, ""}), 1.0, 1e-12);
}

TEST(Obstacle, BoundsHoldTheShapeAndTellAtMostItsDistance) {
  const Motion motion = straight(Vec3(0, 2, 2), Vec3(8, 2, 2));
  for (const Obstacle& obstacle : {Obstacle{Sphere{Vec3(4, 7, 2), 2.0}, ""}, Obstacle{Cylinder{Vec2(14, 7), 2.0}, ""},
                                   Obstacle{Box{Vec3(9, 0, 5), Vec3(12, 4, 9)}, ""}, Obstacle{wall(), ""}}) {
    EXPECT_LE(least_clearance_m(motion, bounds_of(obstacle)), clearance_m(motion, obstacle) + 1e-9);
  }
  EXPECT_EQ(bounds_of({Sphere{Vec3(4, 7, 2), 2.0}, ""}), (Box{Vec3(2, 5, 0), Vec3(6, 9, 4)}));
}

TEST(Obstacle, ATerrainIsNeverFoundTooLate) {
  const Obstacle hills{Terrain{.a = 2.0}, ""};  // 2 sin x
  EXPECT_TRUE(overlaps(hills, {Vec3(1, 0, 1.9), Vec3(2, 1, 3)}));
  EXPECT_FALSE(overlaps(hills, {Vec3(1, 0, 5), Vec3(2, 1, 6)}));
}

}  // namespace
}  // namespace skein
