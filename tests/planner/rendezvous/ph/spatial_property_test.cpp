#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/ph/curvature_bound.hpp"
#include "planner/rendezvous/ph/spatial_hermite.hpp"
#include "planner/rendezvous/ph/torsion_bound.hpp"

namespace skein::rendezvous::ph {
namespace {

struct Sample {
  Pose start;
  Pose end;
  Controls controls;
  SpatialPath path;
};

/// Any poses, climbing up to 1.2 rad, controls of 0.2 to 4 chords; `forward` keeps directions near the chord's.
Sample draw(std::uint64_t seed, bool forward) {
  RandomStream stream(seed, 0, Purpose::Test, 24);
  Sample s;
  for (Pose* pose : {&s.start, &s.end}) {
    pose->position_m = Vec3(stream.uniform(-1e4, 1e4), stream.uniform(-1e4, 1e4), stream.uniform(0.0, 3e3));
    pose->heading_rad = stream.uniform(-math::kPi, math::kPi);
    pose->climb_rad = stream.uniform(-1.2, 1.2);
  }
  if (forward) {
    const double chord = heading_of((s.end.position_m - s.start.position_m).head<2>());
    for (Pose* pose : {&s.start, &s.end}) {
      pose->heading_rad = chord + stream.uniform(-1.0, 1.0);
      pose->climb_rad = stream.uniform(-0.5, 0.5);
    }
  }
  const SpatialHermite hermite(s.start, s.end);
  s.controls = {hermite.chord_m() * stream.uniform(0.2, 4.0), hermite.chord_m() * stream.uniform(0.2, 4.0)};
  s.path = hermite.path(s.controls);
  return s;
}

TEST(SpatialProperty, BothPosesAreMetWithTheGivenSpeeds) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Sample s = draw(seed, false);
    const double scale = s.path.length_m() + s.controls.m0_m + s.controls.m1_m;
    EXPECT_EQ(s.path.position(0.0), s.start.position_m);
    EXPECT_NEAR((s.path.position(1.0) - s.end.position_m).norm(), 0.0, 1e-12 * scale) << "seed " << seed;
    EXPECT_NEAR((s.path.direction(0.0) - direction_of(s.start)).norm(), 0.0, 1e-12) << "seed " << seed;
    EXPECT_NEAR((s.path.direction(1.0) - direction_of(s.end)).norm(), 0.0, 1e-12) << "seed " << seed;
    EXPECT_NEAR(s.path.speed(0.0), s.controls.m0_m, 1e-12 * scale);
    EXPECT_NEAR(s.path.speed(1.0), s.controls.m1_m, 1e-11 * scale);
  }
}

TEST(SpatialProperty, PlanarDataGiveThePlanarPath) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Sample s = draw(seed, seed % 2 == 0);
    const double z_m = s.start.position_m.z();
    s.end.position_m.z() = z_m;
    s.start.climb_rad = s.end.climb_rad = 0.0;
    const PlanarPath flat =
        Hermite({s.start.position_m.head<2>(), s.start.heading_rad}, {s.end.position_m.head<2>(), s.end.heading_rad})
            .path(s.controls);
    const SpatialPath path = SpatialHermite(s.start, s.end).path(s.controls);
    const double length_m = flat.length_m();
    EXPECT_NEAR(path.length_m(), length_m, 1e-12 * length_m) << "seed " << seed;
    for (const double q : {0.0, 0.2, 0.5, 0.77, 1.0}) {
      const Vec2 there = flat.position(q);
      EXPECT_NEAR((path.position(q) - Vec3(there.x(), there.y(), z_m)).norm(), 0.0, 1e-12 * length_m)
          << "seed " << seed;
      EXPECT_EQ(path.torsion(q), 0.0);
      const double curvature = std::fabs(flat.curvature(q));
      EXPECT_NEAR(path.curvature(q), curvature, 1e-10 * curvature + 1e-12 / length_m) << "seed " << seed;
    }
    const double energy = flat.elastic_energy_per_m();
    EXPECT_NEAR(path.elastic_energy_per_m(), energy, 1e-9 * energy) << "seed " << seed;
  }
}

TEST(SpatialProperty, LengthIsTheIntegralOfSpeed) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const SpatialPath path = draw(seed, false).path;
    constexpr int kIntervals = 400;
    double sum = 0.0;
    for (int i = 0; i <= kIntervals; ++i) {
      const double q = static_cast<double>(i) / kIntervals;
      sum += (i == 0 || i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) * path.speed(q);
    }
    EXPECT_NEAR(path.length_m(), sum / (3.0 * kIntervals), 1e-8 * path.length_m()) << "seed " << seed;
    EXPECT_NEAR(path.arc_length(1.0), path.length_m(), 1e-12 * path.length_m());
  }
}

TEST(SpatialProperty, SpeedCurvatureAndTorsionAreThoseOfThePositions) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const SpatialPath path = draw(seed, true).path;
    for (const double q : {0.1, 0.35, 0.5, 0.8}) {
      constexpr double h = 2e-3;
      const auto at = [&](int k) { return path.position(q + k * h); };
      // Central differences of fourth order; the third derivative of a quintic.
      const Vec3 first = (at(-2) - 8.0 * at(-1) + 8.0 * at(1) - at(2)) / (12.0 * h);
      const Vec3 second = (-at(-2) + 16.0 * at(-1) - 30.0 * at(0) + 16.0 * at(1) - at(2)) / (12.0 * h * h);
      const Vec3 third =
          (at(-3) - 8.0 * at(-2) + 13.0 * at(-1) - 13.0 * at(1) + 8.0 * at(2) - at(3)) / (8.0 * h * h * h);
      const Vec3 normal = first.cross(second);
      const double curvature = normal.norm() / (first.norm() * first.squaredNorm());
      const double torsion = normal.dot(third) / normal.squaredNorm();
      EXPECT_NEAR(path.speed(q), first.norm(), 1e-6 * first.norm()) << "seed " << seed;
      EXPECT_NEAR((path.direction(q) - first.normalized()).norm(), 0.0, 1e-6) << "seed " << seed;
      EXPECT_NEAR(path.curvature(q), curvature, 1e-5 * curvature + 1e-6 / path.length_m()) << "seed " << seed;
      EXPECT_NEAR(path.torsion(q), torsion, 1e-3 * std::fabs(torsion) + 1e-3 / path.length_m()) << "seed " << seed;
    }
  }
}

TEST(SpatialProperty, EnergyIsTheIntegralOfSquaredCurvatureAndTorsion) {
  int smooth = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const SpatialPath path = draw(seed, true).path;
    if (max_torsion_per_m(path) * path.length_m() > 8.0) continue;  // spikes are beyond 16 points
    ++smooth;
    constexpr int kIntervals = 4000;
    double sum = 0.0;
    for (int i = 0; i < kIntervals; ++i) {
      const double q = (i + 0.5) / kIntervals;
      const double kappa = path.curvature(q);
      const double tau = path.torsion(q);
      sum += (kappa * kappa + tau * tau) * path.speed(q) / kIntervals;
    }
    EXPECT_NEAR(path.elastic_energy_per_m(), sum, 0.005 * sum) << "seed " << seed;
  }
  EXPECT_GT(smooth, 40);
}

TEST(SpatialProperty, EquidistantPointsDivideTheLength) {
  std::vector<Vec3> points(50);
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Sample s = draw(seed, false);
    equidistant_points(s.path, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double at = s.path.length_m() * static_cast<double>(k) / 49.0;
      EXPECT_NEAR((points[k] - s.path.position_at(at)).norm(), 0.0, 1e-8 * s.path.length_m()) << "seed " << seed;
    }
  }
}

TEST(SpatialProperty, BoundsHoldAndAreTight) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const SpatialPath path = draw(seed, true).path;
    double curvature = 0.0;
    double torsion = 0.0;
    for (int i = 0; i <= 20000; ++i) {
      curvature = std::max(curvature, path.curvature(i / 20000.0));
      torsion = std::max(torsion, std::fabs(path.torsion(i / 20000.0)));
    }
    const double bound = max_curvature_per_m(path);
    EXPECT_GE(bound, curvature * (1.0 - 1e-12)) << "seed " << seed;
    EXPECT_LE(bound, curvature * 1.01 + 2e-6 / path.length_m()) << "seed " << seed;
    EXPECT_TRUE(curvature_within(path, bound)) << "seed " << seed;
    EXPECT_FALSE(curvature_within(path, 0.999 * curvature)) << "seed " << seed;
    const double twist = max_torsion_per_m(path);
    EXPECT_GE(twist, torsion * (1.0 - 1e-9)) << "seed " << seed;
    EXPECT_LE(twist, torsion * 1.02 + 2e-6 / path.length_m()) << "seed " << seed;
    EXPECT_TRUE(torsion_within(path, twist)) << "seed " << seed;
    EXPECT_FALSE(torsion_within(path, 0.999 * torsion)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein::rendezvous::ph
