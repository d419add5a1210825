#include "groundstation/monitor/camera.hpp"

#include <gtest/gtest.h>

#include "tests/groundstation/monitor/views.hpp"

namespace skein::monitor {
namespace {

TEST(Camera, PlanesHaveTheirAxes) {
  const Vec3 place_m(1.0, 2.0, 3.0);
  EXPECT_EQ(on_plane(Plane::XY, place_m), Vec2(1.0, 2.0));
  EXPECT_EQ(on_plane(Plane::XZ, place_m), Vec2(1.0, 3.0));
  EXPECT_EQ(on_plane(Plane::YZ, place_m), Vec2(2.0, 3.0));
}

TEST(Camera, BoundsHoldStartsAndGoals) {
  const auto bounds = bounds_of(row_of(3));
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->min_m, Vec3(200.0, 0.0, 100.0));
  EXPECT_EQ(bounds->max_m, Vec3(600.0, 2000.0, 100.0));
  EXPECT_FALSE(bounds_of(watch::SwarmView{}));
}

TEST(Camera, EverythingIsInThePictureAndDotsAreSquare) {
  const Box bounds{{-500.0, 0.0, 0.0}, {500.0, 2000.0, 0.0}};
  const Camera camera(Plane::XY, bounds, std::nullopt, 1.0, 80, 64);
  for (const Vec3& corner : {bounds.min_m, bounds.max_m}) {
    const Dot dot = camera.dot_of(corner);
    EXPECT_GE(dot.x, 0.0);
    EXPECT_LT(dot.x, 80.0);
    EXPECT_GE(dot.y, 0.0);
    EXPECT_LT(dot.y, 64.0);
  }
  const Dot middle = camera.dot_of(Vec3(0.0, 1000.0, 0.0));
  EXPECT_NEAR(middle.x, 40.0, 1e-9);
  EXPECT_NEAR(middle.y, 32.0, 1e-9);
  EXPECT_NEAR(camera.dot_of(Vec3(100.0, 1000.0, 0.0)).x - middle.x, middle.y - camera.dot_of(Vec3(0.0, 1100.0, 0.0)).y,
              1e-9);
}

TEST(Camera, NorthIsUpAndZoomIsNear) {
  const Box bounds{{0.0, 0.0, 0.0}, {100.0, 100.0, 0.0}};
  const Camera far(Plane::XY, bounds, std::nullopt, 1.0, 40, 40);
  const Camera near(Plane::XY, bounds, Vec3(10.0, 20.0, 0.0), 4.0, 40, 40);
  EXPECT_LT(far.dot_of(Vec3(50.0, 90.0, 0.0)).y, far.dot_of(Vec3(50.0, 10.0, 0.0)).y);
  EXPECT_NEAR(near.dot_m() * 4.0, far.dot_m(), 1e-12);
  EXPECT_NEAR(near.dot_of(Vec3(10.0, 20.0, 0.0)).x, 20.0, 1e-9);
}

TEST(Camera, APlaceWithoutWidthHasAPicture) {
  const Camera camera(Plane::XZ, Box{Vec3::Zero(), Vec3::Zero()}, std::nullopt, 1.0, 40, 40);
  EXPECT_GT(camera.dot_m(), 0.0);
}

}  // namespace
}  // namespace skein::monitor
