#include "planner/rendezvous/ph/planar_path.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "planner/rendezvous/ph/curvature_bound.hpp"

namespace skein::rendezvous::ph {
namespace {

/// w = 2 throughout: a straight line of length 4 to the east.
const PlanarPath kLine(Vec2(1.0, 2.0), {{2.0, 0.0}, {2.0, 0.0}, {2.0, 0.0}});

TEST(PlanarPath, ALineByHand) {
  EXPECT_DOUBLE_EQ(kLine.length_m(), 4.0);
  EXPECT_DOUBLE_EQ(kLine.parameter_at(1.0), 0.25);
  EXPECT_TRUE(kLine.position_at(3.0).isApprox(Vec2(4.0, 2.0)));
  EXPECT_EQ(kLine.heading_at(1.0), 0.0);
  EXPECT_EQ(kLine.curvature_at(1.0), 0.0);
  EXPECT_EQ(kLine.elastic_energy_per_m(), 0.0);
  EXPECT_LE(max_curvature_per_m(kLine), 1e-6);
}

/// w = 1 + i q: r' = 1 - q^2 + 2 i q, hence x = q - q^3/3, y = q^2, speed 1 + q^2, length 4/3, curvature 2/(1+q^2)^2.
const PlanarPath kTschirnhausen(Vec2::Zero(), {{1.0, 0.0}, {1.0, 0.5}, {1.0, 1.0}});

TEST(PlanarPath, ACubicByHand) {
  EXPECT_DOUBLE_EQ(kTschirnhausen.length_m(), 4.0 / 3.0);
  EXPECT_NEAR((kTschirnhausen.position(1.0) - Vec2(2.0 / 3.0, 1.0)).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(kTschirnhausen.speed(0.5), 1.25);
  EXPECT_DOUBLE_EQ(kTschirnhausen.arc_length(0.5), 0.5 + 0.125 / 3.0);
  EXPECT_DOUBLE_EQ(kTschirnhausen.curvature(0.0), 2.0);
  EXPECT_DOUBLE_EQ(kTschirnhausen.curvature(1.0), 0.5);
  EXPECT_DOUBLE_EQ(kTschirnhausen.heading(1.0), 1.5707963267948966);
  // Integral of 4 / (1 + q^2)^3 from 0 to 1 = 3 pi / 8 + 1.
  EXPECT_NEAR(kTschirnhausen.elastic_energy_per_m(), 3.0 * 3.141592653589793 / 8.0 + 1.0, 1e-12);
}

TEST(PlanarPath, ArcLengthIsClampedToThePath) {
  EXPECT_EQ(kTschirnhausen.parameter_at(-1.0), 0.0);
  EXPECT_EQ(kTschirnhausen.parameter_at(99.0), 1.0);
  EXPECT_EQ(kTschirnhausen.position_at(99.0), kTschirnhausen.position(1.0));
}

TEST(PlanarPath, EquidistantPointsIncludeBothEnds) {
  std::vector<Vec2> points(5);
  equidistant_points(kLine, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR((points[k] - Vec2(1.0 + static_cast<double>(k), 2.0)).norm(), 0.0, 1e-15);
  }
}

TEST(PlanarPath, ThePathThatIsAPoint) {
  const PlanarPath nowhere;
  EXPECT_EQ(nowhere.length_m(), 0.0);
  EXPECT_EQ(nowhere.parameter_at(0.0), 0.0);
  EXPECT_EQ(nowhere.position_at(0.0), Vec2(0.0, 0.0));
}

TEST(CurvatureBound, OfTheCubic) {
  const double bound = max_curvature_per_m(kTschirnhausen);
  EXPECT_GE(bound, 2.0);
  EXPECT_LE(bound, 2.0 + 4e-6);
  EXPECT_TRUE(curvature_within(kTschirnhausen, 2.0001));
  EXPECT_FALSE(curvature_within(kTschirnhausen, 1.9999));
}

TEST(CurvatureBound, ACuspIsInfinite) {
  // w = 2 q - 1 vanishes at q = 1/2 with a turn of w by half a circle: the curve reverses.
  const PlanarPath cusp(Vec2::Zero(), {{-1.0, 0.1}, {0.0, -0.1}, {1.0, 0.1}});
  EXPECT_GT(max_curvature_per_m(PlanarPath(Vec2::Zero(), {{-1.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}})), 1e6);
  EXPECT_FALSE(curvature_within(cusp, 0.01));
}

}  // namespace
}  // namespace skein::rendezvous::ph
