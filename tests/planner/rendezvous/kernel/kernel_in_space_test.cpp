#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/rendezvous/kernel/kernel.hpp"
#include "tests/planner/rendezvous/kernel/random_batch.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

using kernel::SpatialPaths;

const kernel::Kernel& scalar() {
  return kernel::kernel_of(Isa::Scalar);
}

kernel::LaneTable paths_of(const test::RandomBatch<Spatial>& batch) {
  kernel::LaneTable paths(SpatialPaths::Count, batch.lanes);
  scalar().spatial.interpolate(batch.ends.view(), batch.m.row(0), batch.m.row(1), batch.lanes, paths.table());
  return paths;
}

void expect_equal(const kernel::LaneTable& paths, std::size_t lane, const ph::SpatialPath& path) {
  const auto row = [&](std::size_t r) { return paths.row(r)[lane]; };
  EXPECT_EQ(row(SpatialPaths::Length), path.length_m());
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(row(SpatialPaths::Speed + k), path.speed_powers()[k]);
    EXPECT_EQ(row(SpatialPaths::S + k), path.profile().arc_powers()[k]);
    EXPECT_EQ(row(SpatialPaths::BendSquared + k), path.bend_squared()[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(row(SpatialPaths::Place + 5 * axis + k), path.place_powers(axis)[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(row(SpatialPaths::Bend + k), path.bend()[k].x());
    EXPECT_EQ(row(SpatialPaths::Bend + 3 + k), path.bend()[k].y());
  }
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(row(SpatialPaths::Twist + k), path.twist()[k]);
}

TEST(KernelInSpace, PathsAreThoseOfHermiteBitForBit) {
  kernel::Rules nothing{};
  nothing.spatial.terrain_roof_m = -std::numeric_limits<double>::infinity();
  for (std::uint64_t index = 0; index < 400; ++index) {
    const auto batch = test::random_batch<Spatial>(1, index, 5);
    const kernel::LaneTable paths = paths_of(batch);
    kernel::LaneTable verdicts(kernel::Verdicts::Count, batch.lanes);
    kernel::LaneTable lengths(1, batch.lanes);
    scalar().spatial.judge(paths.view(), nothing, batch.lanes, verdicts.table());
    scalar().spatial.measure(batch.ends.view(), batch.m.row(0), batch.m.row(1), batch.lanes, lengths.row(0));
    for (std::size_t lane = 0; lane < batch.lanes; ++lane) {
      const ph::SpatialPath path = batch.hermites[lane].path(batch.controls[lane]).pieces()[0];
      expect_equal(paths, lane, path);
      EXPECT_EQ(verdicts.row(kernel::Verdicts::Energy)[lane], path.elastic_energy_per_m());
      EXPECT_EQ(lengths.row(0)[lane], batch.hermites[lane].length_m(batch.controls[lane]));
    }
  }
}

TEST(KernelInSpace, WalkedPointsAreThoseOfTheConvergedReference) {
  constexpr std::size_t kPoints = 50;
  double worst_m = 0.0;
  for (std::uint64_t index = 0; index < 1000; ++index) {
    const auto batch = test::random_batch<Spatial>(2, index, 8);
    PointTableIn<Spatial> walked(kPoints, batch.lanes);
    scalar().spatial.walk(paths_of(batch).view(), {kPoints - 1, kPoints}, batch.lanes, walked.table());
    for (std::size_t lane = 0; lane < batch.lanes; ++lane) {
      const ph::SpatialPath path = batch.hermites[lane].path(batch.controls[lane]).pieces()[0];
      for (std::size_t k = 0; k < kPoints; ++k) {
        const double at_m = path.length_m() * static_cast<double>(k) / static_cast<double>(kPoints - 1);
        worst_m = std::max(worst_m, (walked.at(lane, k) - path.position_at(at_m)).norm());
      }
    }
  }
  EXPECT_LT(worst_m, 1e-3);
}

/// Largest curvature and torsion, least distance to zones by kind, and least height, at the check points of a path.
struct Extremes {
  double curvature = 0.0;
  double torsion = 0.0;
  double obstacle_m = 1e9;
  double no_fly_m = 1e9;
  double height_m = 1e9;
};

Extremes extremes_of(const ProblemIn<Spatial>& problem, const ph::SpatialPath& path) {
  Extremes e;
  const std::int32_t last = problem.options.check_points - 1;
  for (std::int32_t k = 0; k <= last; ++k) {
    const double q = static_cast<double>(k) / last;
    const Vec3 here = path.position(q);
    e.curvature = std::max(e.curvature, path.curvature(q));
    e.torsion = std::max(e.torsion, std::fabs(path.torsion(q)));
    if (problem.terrain) e.height_m = std::min(e.height_m, height_above_m(*problem.terrain, here));
    if (k == 0) continue;
    const Vec3 before = path.position(static_cast<double>(k - 1) / last);
    for (const PlanarZone& zone : problem.zones) {
      double& least = zone.no_fly ? e.no_fly_m : e.obstacle_m;
      least = std::min(least, distance_m(zone, before, here));
    }
  }
  return e;
}

TEST(KernelInSpace, ConstraintsAreJudgedAsByTheClosedForms) {
  std::array<int, 5> violating{};
  std::array<int, 5> kept{};
  const auto expect = [&](std::size_t i, double term, bool violates, double margin, std::uint64_t seed) {
    if (std::fabs(margin) < 1e-9) return;  // a tie, decided by rounding
    EXPECT_EQ(term > 0.0, violates) << "constraint " << i << ", seed " << seed;
    (violates ? violating : kept)[i]++;
  };
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 44);
    const auto problem =
        make_problem<Spatial>(test::layout_space(seed), 1 + static_cast<AgentId>(stream.below(3)), scalar());
    const Interval& range = problem.own().range_m;
    EvaluationIn<Spatial> of;
    evaluate(problem, {stream.uniform(range.min, range.max), stream.uniform(range.min, range.max)}, of);
    const Extremes e = extremes_of(problem, problem.own().hermite.path(of.controls).pieces()[0]);
    const CostTerms& t = of.terms;
    const double keep_m = problem.keep_out_m;
    expect(0, t.unflyable, e.curvature > problem.max_curvature_per_m, e.curvature - problem.max_curvature_per_m, seed);
    expect(1, t.twisted, e.torsion > problem.max_torsion_per_m, e.torsion - problem.max_torsion_per_m, seed);
    expect(2, t.obstacle, e.obstacle_m < keep_m, e.obstacle_m - keep_m, seed);
    expect(3, t.no_fly, e.no_fly_m < keep_m, e.no_fly_m - keep_m, seed);
    expect(4, t.terrain, e.height_m < problem.terrain_height_m, e.height_m - problem.terrain_height_m, seed);
  }
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_GT(violating[i], 20) << "constraint " << i;
    EXPECT_GT(kept[i], 20) << "constraint " << i;
  }
}

}  // namespace
}  // namespace skein::rendezvous
