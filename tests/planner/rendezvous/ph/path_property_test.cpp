#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/ph/curvature_bound.hpp"
#include "planner/rendezvous/ph/hermite.hpp"

namespace skein::rendezvous::ph {
namespace {

struct Sample {
  PlanarPose start;
  PlanarPose end;
  PlanarPath path;
};

/// Any poses, controls of 0.2 to 4 chords; `forward` keeps headings within 80 degrees of the chord.
Sample draw(std::uint64_t seed, bool forward) {
  RandomStream stream(seed, 0, Purpose::Test, 20);
  Sample s;
  s.start.position_m = Vec2(stream.uniform(-1e4, 1e4), stream.uniform(-1e4, 1e4));
  s.end.position_m = Vec2(stream.uniform(-1e4, 1e4), stream.uniform(-1e4, 1e4));
  const double chord = heading_of(s.end.position_m - s.start.position_m);
  const double spread = forward ? 1.4 : math::kPi;
  s.start.heading_rad = math::wrap_angle(chord + stream.uniform(-spread, spread));
  s.end.heading_rad = math::wrap_angle(chord + stream.uniform(-spread, spread));
  const Hermite hermite(s.start, s.end);
  s.path = hermite.path({hermite.chord_m() * stream.uniform(0.2, 4.0), hermite.chord_m() * stream.uniform(0.2, 4.0)});
  return s;
}

TEST(PathProperty, BothPosesAreMet) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Sample s = draw(seed, false);
    const double scale = s.path.length_m() + s.path.speed(0.0) + s.path.speed(1.0);
    EXPECT_EQ(s.path.position(0.0), s.start.position_m);
    EXPECT_NEAR((s.path.position(1.0) - s.end.position_m).norm(), 0.0, 1e-12 * scale) << "seed " << seed;
    EXPECT_NEAR(math::wrap_angle(s.path.heading(0.0) - s.start.heading_rad), 0.0, 1e-12) << "seed " << seed;
    EXPECT_NEAR(math::wrap_angle(s.path.heading(1.0) - s.end.heading_rad), 0.0, 1e-12) << "seed " << seed;
  }
}

TEST(PathProperty, LengthIsTheIntegralOfSpeed) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const PlanarPath path = draw(seed, false).path;
    constexpr int kIntervals = 400;  // Simpson's rule is exact up to cubics; the quartic's error falls as n^-4
    double sum = 0.0;
    for (int i = 0; i <= kIntervals; ++i) {
      const double q = static_cast<double>(i) / kIntervals;
      sum += (i == 0 || i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) * path.speed(q);
    }
    const double quadrature = sum / (3.0 * kIntervals);
    EXPECT_NEAR(path.length_m(), quadrature, 1e-8 * path.length_m()) << "seed " << seed;
    EXPECT_NEAR(path.arc_length(1.0), path.length_m(), 1e-12 * path.length_m());
  }
}

TEST(PathProperty, SpeedAndCurvatureAreThoseOfThePositions) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const PlanarPath path = draw(seed, true).path;
    for (const double q : {0.1, 0.35, 0.5, 0.8}) {
      constexpr double kStep = 1e-4;
      const Vec2 before = path.position(q - kStep);
      const Vec2 here = path.position(q);
      const Vec2 after = path.position(q + kStep);
      const Vec2 first = (after - before) / (2.0 * kStep);
      const Vec2 second = (after - 2.0 * here + before) / (kStep * kStep);
      const double speed = first.norm();
      const double curvature = (first.x() * second.y() - first.y() * second.x()) / (speed * speed * speed);
      EXPECT_NEAR(path.speed(q), speed, 1e-5 * path.length_m()) << "seed " << seed << " q " << q;
      EXPECT_NEAR(path.curvature(q), curvature, 1e-3 * std::fabs(curvature) + 1e-3 / path.length_m())
          << "seed " << seed << " q " << q;
    }
  }
}

TEST(PathProperty, ParameterAtIsTheInverseOfArcLength) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const PlanarPath path = draw(seed, false).path;
    RandomStream stream(seed, 0, Purpose::Test, 21);
    const double s = path.length_m() * stream.uniform();
    EXPECT_NEAR(path.arc_length(path.parameter_at(s)), s, 1e-9 * path.length_m()) << "seed " << seed;
    EXPECT_NEAR(path.arc_length(path.parameter_at(s, stream.uniform())), s, 1e-9 * path.length_m());
  }
}

TEST(PathProperty, EquidistantPointsDivideTheLength) {
  std::vector<Vec2> points(50);
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Sample s = draw(seed, false);
    equidistant_points(s.path, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double at = s.path.length_m() * static_cast<double>(k) / 49.0;
      EXPECT_NEAR((points[k] - s.path.position_at(at)).norm(), 0.0, 1e-8 * s.path.length_m()) << "seed " << seed;
    }
  }
}

TEST(PathProperty, CurvatureBoundHoldsAndIsTight) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const PlanarPath path = draw(seed, true).path;
    double largest = 0.0;
    for (int i = 0; i <= 20000; ++i) largest = std::max(largest, std::fabs(path.curvature(i / 20000.0)));
    const double bound = max_curvature_per_m(path);
    EXPECT_GE(bound, largest * (1.0 - 1e-12)) << "seed " << seed;
    EXPECT_LE(bound, largest * 1.01 + 2e-6 / path.length_m()) << "seed " << seed;
    EXPECT_TRUE(curvature_within(path, bound)) << "seed " << seed;
    EXPECT_FALSE(curvature_within(path, 0.999 * largest)) << "seed " << seed;
    EXPECT_GE(max_curvature_per_m(path, 0.05), bound * (1.0 - 1e-6));
  }
}

}  // namespace
}  // namespace skein::rendezvous::ph
