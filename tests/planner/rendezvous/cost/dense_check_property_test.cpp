#include <gtest/gtest.h>

#include <algorithm>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

ph::Controls random_controls(const Participant& uav, RandomStream& stream) {
  return {stream.uniform(uav.range_m.min, uav.range_m.max), stream.uniform(uav.range_m.min, uav.range_m.max)};
}

double sampled_clearance_m(const Problem& problem, const Planar::Path& path) {
  double least = 1e9;
  for (int i = 0; i <= 20000; ++i) {
    for (const PlanarZone& zone : problem.zones) least = std::min(least, distance_m(zone, path.position(i / 20000.0)));
  }
  return least;
}

TEST(DenseCheckProperty, WhatPassesKeepsClearAndWhatFailsIsNear) {
  int passed = 0;
  int failed = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 30);
    Mission mission = test::layout_b(seed);
    mission.vehicles[0].max_curvature_per_m = 1.0;
    mission.planner.dense_points = stream.below(2) == 0 ? 1000 : 120;
    const Problem problem = make_problem(mission, 1 + static_cast<AgentId>(stream.below(3)));
    const DensePath dense = sample_densely(problem, problem.own().hermite.path(random_controls(problem.own(), stream)));
    const Constraint verdict = check_alone(problem, dense);
    if (verdict == Constraint::Curvature) continue;
    const double clearance = sampled_clearance_m(problem, dense.path);
    (verdict == Constraint::None ? passed : failed)++;
    if (verdict == Constraint::None) {
      EXPECT_GE(clearance, problem.keep_out_m) << "seed " << seed;
    } else {
      EXPECT_LE(clearance, problem.keep_out_m + 2.0 * dense.sag_m + 1.0) << "seed " << seed;
    }
    if (refute(problem, dense.path) != Constraint::None) {
      EXPECT_NE(verdict, Constraint::None) << "seed " << seed;
    }
  }
  EXPECT_GT(passed, 20);
  EXPECT_GT(failed, 20);
}

TEST(DenseCheckProperty, PathsThatKeepApartDoSoAtEveryMoment) {
  int apart = 0;
  int close = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 31);
    const Problem problem = make_problem(test::open_field(seed), 1);
    const Participant& other = problem.participants[1 + stream.below(2)];
    const DensePath a = sample_densely(problem, problem.own().hermite.path(random_controls(problem.own(), stream)));
    const DensePath b = sample_densely(problem, other.hermite.path(random_controls(other, stream)));
    double least = 1e9;
    for (int i = 0; i <= 4000; ++i) {
      const double part = i / 4000.0;
      least = std::min(
          least, (a.path.position_at(part * a.path.length_m()) - b.path.position_at(part * b.path.length_m())).norm());
    }
    // Against a distance just below, just above, and far below what they keep.
    EXPECT_FALSE(keeps_apart(a, b, least + 1e-6)) << "seed " << seed;
    const double slack = 2.0 * (a.sag_m + b.sag_m) + 1.0;
    EXPECT_TRUE(keeps_apart(a, b, least - slack)) << "seed " << seed;
    EXPECT_EQ(keeps_apart(a, b, 200.0), keeps_apart(b, a, 200.0)) << "seed " << seed;
    (keeps_apart(a, b, 800.0) ? apart : close)++;
  }
  EXPECT_GT(apart, 10);
  EXPECT_GT(close, 10);
}

TEST(DenseCheck, NoRequiredDistanceIsAlwaysKept) {
  const Problem problem = make_problem(test::open_field(1), 1);
  const DensePath a = sample_densely(problem, problem.own().hermite.path({37333.0, 7879.0}));
  EXPECT_TRUE(keeps_apart(a, a, 0.0));
  EXPECT_FALSE(keeps_apart(a, a, 1.0));
}

}  // namespace
}  // namespace skein::rendezvous
