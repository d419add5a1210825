#include "planner/rendezvous/ph/joined_hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/ph/preimage_spline.hpp"

namespace skein::rendezvous::ph {
namespace {

PlanarPose pose(double x, double y, double heading_rad) {
  return {Vec2(x, y), heading_rad};
}

Controls with_interior(double m0, double m1, const std::vector<double>& values) {
  Interior interior;
  for (const double value : values) interior.values[interior.size++] = value;
  return {m0, m1, interior};
}

TEST(PreimageSpline, GramMatrixOfOnePieceIsThatOfTheBernsteinPolynomials) {
  constexpr auto kGram = gram_matrix(1);
  EXPECT_DOUBLE_EQ(kGram[0][0], 1.0 / 5.0);
  EXPECT_DOUBLE_EQ(kGram[0][1], 1.0 / 10.0);
  EXPECT_DOUBLE_EQ(kGram[0][2], 1.0 / 30.0);
  EXPECT_DOUBLE_EQ(kGram[1][1], 2.0 / 15.0);
}

TEST(PreimageSpline, BSplinesSumToOneSoTheGramMatrixSumsToOne) {
  for (std::size_t n = 1; n <= kMaxSegments; ++n) {
    const auto gram = gram_matrix(n);
    double sum = 0.0;
    for (const auto& row : gram) {
      for (const double value : row) sum += value;
    }
    EXPECT_NEAR(sum, 1.0, 1e-15) << n;
  }
}

TEST(PreimageSpline, OneSegmentIsTheFormulaOfHermite) {
  const Hermite hermite(pose(0.0, 0.0, 0.5), pose(10.0, 0.0, -0.3));
  for (const double m0 : {0.5, 3.0, 12.0, 40.0}) {
    const Preimage w = hermite.path({m0, 9.0}).preimage();
    const SplineCoefficients<Complex> c =
        closed(SplineCoefficients<Complex>{w.w0, Complex{}, w.w2}, 1, Complex{10.0, 0.0}, 1.0);
    EXPECT_NEAR(c[1].re, w.w1.re, 1e-13) << m0;
    EXPECT_NEAR(c[1].im, w.w1.im, 1e-13) << m0;
  }
}

TEST(PreimageSpline, OneSegmentInSpaceIsTheFormulaOfSpatialHermite) {
  const SpatialHermite hermite({Vec3(0.0, 0.0, 0.0), 0.5, 0.2}, {Vec3(10.0, 0.0, 0.0), -0.3, -0.4});
  const SpatialPreimage a = hermite.path({12.0, 9.0}).preimage();
  SplineCoefficients<Vec3> c;
  c.fill(Vec3::Zero());
  c[0] = a.a0;
  c[2] = a.a2;
  c = closed(c, 1, Vec3(10.0, 0.0, 0.0), 1.0);
  EXPECT_NEAR((c[1] - a.a1).norm(), 0.0, 1e-13);
}

TEST(JoinedHermite, WithoutInteriorThePathIsTheSingleSegmentBitForBit) {
  const JoinedHermite joined(pose(1.0, 2.0, 0.5), pose(11.0, -3.0, -0.3));
  const Hermite single(pose(1.0, 2.0, 0.5), pose(11.0, -3.0, -0.3));
  const Controls m{8.0, 12.0};
  const JoinedPlanarPath path = joined.path(m);
  const PlanarPath expected = single.path(m);
  ASSERT_EQ(path.pieces().size(), 1U);
  EXPECT_EQ(joined.length_m(m), single.length_m(m));
  EXPECT_EQ(path.length_m(), expected.length_m());
  EXPECT_EQ(path.elastic_energy_per_m(), expected.elastic_energy_per_m());
  EXPECT_EQ(max_curvature_per_m(path), max_curvature_per_m(expected));
  for (const double q : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(path.position(q), expected.position(q));
    EXPECT_EQ(path.heading(q), expected.heading(q));
    EXPECT_EQ(path.curvature(q), expected.curvature(q));
    EXPECT_EQ(path.speed(q), expected.speed(q));
    EXPECT_EQ(path.parameter_at(q * path.length_m(), 0.5), expected.parameter_at(q * path.length_m(), 0.5));
  }
  std::vector<Vec2> points(7);
  std::vector<Vec2> expected_points(7);
  equidistant_points(path, points);
  equidistant_points(expected, expected_points);
  EXPECT_EQ(points, expected_points);
}

TEST(JoinedHermite, AStraightLineOfUniformSpeedStaysOne) {
  const JoinedHermite hermite(pose(0.0, 0.0, 0.0), pose(10.0, 0.0, 0.0));
  const JoinedPlanarPath path = hermite.path(with_interior(10.0, 10.0, {10.0, 0.0, 10.0, 0.0}));
  ASSERT_EQ(path.pieces().size(), 3U);
  EXPECT_NEAR(path.length_m(), 10.0, 1e-13);
  for (const double q : {0.0, 0.2, 1.0 / 3.0, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(path.position(q).x(), 10.0 * q, 1e-13);
    EXPECT_NEAR(path.speed(q), 10.0, 1e-13);
    EXPECT_NEAR(path.arc_length(q), 10.0 * q, 1e-13);
  }
}

TEST(JoinedHermite, PlanarDataInSpaceGiveThePlanarPath) {
  const JoinedHermite plane(pose(0.0, 0.0, 0.5), pose(10.0, 0.0, -0.3));
  const SpatialJoinedHermite space({Vec3(0.0, 0.0, 0.0), 0.5, 0.0}, {Vec3(10.0, 0.0, 0.0), -0.3, 0.0});
  const JoinedPlanarPath a = plane.path(with_interior(8.0, 12.0, {7.0, 0.6, 15.0, -0.9}));
  const JoinedSpatialPath b = space.path(with_interior(8.0, 12.0, {7.0, 0.6, 0.0, 15.0, -0.9, 0.0}));
  EXPECT_NEAR(a.length_m(), b.length_m(), 1e-12);
  EXPECT_NEAR(a.elastic_energy_per_m(), b.elastic_energy_per_m(), 1e-12);
  for (const double q : {0.1, 0.4, 0.7, 0.95}) {
    EXPECT_NEAR((Vec3(a.position(q).x(), a.position(q).y(), 0.0) - b.position(q)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(std::fabs(a.curvature(q)), b.curvature(q), 1e-12);
    EXPECT_EQ(b.torsion(q), 0.0);
  }
}

TEST(JoinedHermite, BackwardHeadingsTakeTheLeastEnergyOfFour) {
  const JoinedHermite hermite(pose(0.0, 0.0, 2.6), pose(10.0, 0.0, 2.6));
  const JoinedPlanarPath path = hermite.path(with_interior(15.0, 15.0, {10.0, 0.4}));
  EXPECT_NEAR((path.position(1.0) - Vec2(10.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(math::wrap_angle(path.heading(1.0) - 2.6), 0.0, 1e-12);
  SplineCoefficients<Complex> c{};
  c[0] = std::sqrt(15.0) * Complex{math::cos(1.3), math::sin(1.3)};
  c[2] = std::sqrt(10.0) * Complex{math::cos(0.2), math::sin(0.2)};
  c[3] = c[0];
  for (const double end_sign : {1.0, -1.0}) {
    for (const double root_sign : {1.0, -1.0}) {
      SplineCoefficients<Complex> one = c;
      one[3] = end_sign * c[3];
      one = closed(one, 2, Complex{10.0, 0.0}, root_sign);
      double energy = 0.0;
      for (std::size_t i = 0; i < 2; ++i) {
        const auto w = piece_of(one, 2, i);
        const double part = std::sqrt(0.5);
        energy += PlanarPath(Vec2::Zero(), {part * w[0], part * w[1], part * w[2]}).elastic_energy_per_m();
      }
      EXPECT_LE(path.elastic_energy_per_m(), energy * (1.0 + 1e-12));
    }
  }
}

TEST(JoinedHermite, CoincidingPositionsAreRefused) {
  EXPECT_THROW(JoinedHermite(pose(1.0, 1.0, 0.0), pose(1.0, 1.0, 1.0)), std::invalid_argument);
  EXPECT_THROW(SpatialJoinedHermite(Pose{}, Pose{}), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous::ph
