#include "planner/core/geometry/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

Cylinder cylinder(double x, double y, double radius, double z_min, double z_max) {
  return {Vec2(x, y), radius, z_min, z_max};
}

TEST(Distance, PointsByHand) {
  const Cylinder c = cylinder(0.0, 0.0, 2.0, 0.0, 10.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(5.0, 0.0), c), 3.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(0.5, 0.0), c), -1.5);
  EXPECT_DOUBLE_EQ(signed_distance(Vec3(5.0, 0.0, 14.0), c), 5.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec3(0.0, 0.0, 9.0), c), -1.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec3(1.0, 0.0, -4.0), c), 4.0);
  const Box box{Vec3(0.0, 0.0, 0.0), Vec3(4.0, 2.0, 10.0)};
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(7.0, 6.0), box), 5.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(1.0, 1.5), box), -0.5);
  EXPECT_DOUBLE_EQ(signed_distance(Vec3(4.0, 5.0, 14.0), box), 5.0);
}

TEST(Distance, SegmentsByHand) {
  const Box box{Vec3(0.0, 0.0, 0.0), Vec3(4.0, 4.0, 4.0)};
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(-3.0, 7.0), Vec2(7.0, 7.0), box), 3.0);
  // Straight through the middle: 2 deep. Across a corner: the deepest point of x + y = 7 is 0.5 inside.
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(-5.0, 2.0), Vec2(9.0, 2.0), box), -2.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(1.0, 6.0), Vec2(6.0, 1.0), box), -0.5);
  // A segment of one point.
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(5.0, 1.0), Vec2(5.0, 1.0), box), 1.0);
  const Cylinder c = cylinder(0.0, 0.0, 2.0, 0.0, 10.0);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(-9.0, 3.0), Vec2(9.0, 3.0), c), 1.0);
  EXPECT_NEAR(signed_distance(Vec3(-9.0, 0.0, 12.0), Vec3(9.0, 0.0, 12.0), c), 2.0, 1e-12);
  EXPECT_NEAR(signed_distance(Vec3(0.0, 0.0, 20.0), Vec3(0.0, 0.0, 5.0), c), -2.0, 1e-9);
}

TEST(Distance, PointToSegment) {
  EXPECT_DOUBLE_EQ(point_to_segment(Vec2(1.0, 2.0), Vec2(0.0, 0.0), Vec2(5.0, 0.0)), 2.0);
  EXPECT_DOUBLE_EQ(point_to_segment(Vec3(8.0, 4.0, 0.0), Vec3(0.0, 0.0, 0.0), Vec3(5.0, 0.0, 0.0)), 5.0);
  EXPECT_DOUBLE_EQ(point_to_segment(Vec2(3.0, 4.0), Vec2(0.0, 0.0), Vec2(0.0, 0.0)), 5.0);
}

/// Least signed distance over many points of the segment, itself held against the nearest of many shape points.
template <typename Vec, typename Shape>
double sampled(const Vec& a, const Vec& b, const Shape& shape) {
  double least = 1e9;
  for (int i = 0; i <= 1000; ++i) least = std::min(least, signed_distance(Vec(a + i / 1000.0 * (b - a)), shape));
  return least;
}

TEST(Distance, SegmentsAgreeWithTheirPoints) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 11);
    const auto place = [&] { return stream.uniform(-10.0, 10.0); };
    const Vec3 a(place(), place(), place());
    const Vec3 b = stream.below(8) == 0 ? Vec3(place(), a.y(), a.z()) : Vec3(place(), place(), place());
    const Cylinder c = cylinder(place(), place(), stream.uniform(0.5, 6.0), -stream.uniform(0.0, 8.0), 4.0);
    const Vec3 low(place(), place(), place());
    const Box box{low, low + Vec3(stream.uniform(0.1, 9.0), stream.uniform(0.1, 9.0), stream.uniform(0.1, 9.0))};
    const double step = (b - a).norm() / 1000.0;
    const Vec2 a2 = a.head<2>();
    const Vec2 b2 = b.head<2>();
    const auto expect_least = [&](double closed, double brute) {
      EXPECT_LE(closed, brute + 1e-9) << "seed " << seed;
      EXPECT_GE(closed, brute - step) << "seed " << seed;
    };
    expect_least(signed_distance(a, b, box), sampled(a, b, box));
    expect_least(signed_distance(a2, b2, box), sampled(a2, b2, box));
    expect_least(signed_distance(a, b, c), sampled(a, b, c));
    expect_least(signed_distance(a2, b2, c), sampled(a2, b2, c));
  }
}

TEST(Distance, PointsAgreeWithTheNearestPointOfTheBoundary) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 12);
    const Vec2 p(stream.uniform(-6.0, 6.0), stream.uniform(-6.0, 6.0));
    const Box box{Vec3(-3.0, -1.0, 0.0), Vec3(2.0, 4.0, 0.0)};
    double nearest = 1e9;
    for (int i = 0; i <= 1000; ++i) {
      const double x = -3.0 + 5.0 * i / 1000.0;
      const double y = -1.0 + 5.0 * i / 1000.0;
      for (const Vec2& q : {Vec2(x, -1.0), Vec2(x, 4.0), Vec2(-3.0, y), Vec2(2.0, y)}) {
        nearest = std::min(nearest, (p - q).norm());
      }
    }
    const bool inside = p.x() > -3.0 && p.x() < 2.0 && p.y() > -1.0 && p.y() < 4.0;
    EXPECT_NEAR(signed_distance(p, box), inside ? -nearest : nearest, 3e-3) << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein
