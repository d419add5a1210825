// Rendezvous in space: the space that a mission asks for, its constraints, and a swarm that plans in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/align/alone.hpp"
#include "planner/rendezvous/cost/cost.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

using Path = Spatial::Path;

ph::Controls random_controls(const ParticipantIn<Spatial>& uav, RandomStream& stream) {
  return {stream.uniform(uav.range_m.min, uav.range_m.max), stream.uniform(uav.range_m.min, uav.range_m.max)};
}

ph::Controls best_controls(const Mission& mission, AgentId id) {
  const auto problem = make_problem<Spatial>(mission, id);
  return best_alone(problem, {0.2 * problem.own().hermite.chord_m(), 0.2 * problem.own().hermite.chord_m()}).controls;
}

/// Where a path, by brute force, is worst.
struct Worst {
  double curvature_per_m = 0.0;
  double torsion_per_m = 0.0;
  double clearance_m = 1e9;
  double height_m = 1e9;
};

Worst worst_of(const ProblemIn<Spatial>& problem, const Path& path) {
  Worst worst;
  for (int i = 0; i <= 20000; ++i) {
    const double q = i / 20000.0;
    const Vec3 here = path.position(q);
    worst.curvature_per_m = std::max(worst.curvature_per_m, path.curvature(q));
    worst.torsion_per_m = std::max(worst.torsion_per_m, std::fabs(path.torsion(q)));
    for (const PlanarZone& zone : problem.zones)
      worst.clearance_m = std::min(worst.clearance_m, distance_m(zone, here));
    if (problem.terrain) worst.height_m = std::min(worst.height_m, height_above_m(*problem.terrain, here));
  }
  return worst;
}

TEST(Space, IsChosenByTheMission) {
  Mission mission = test::layout_a(1);
  EXPECT_TRUE(is_planar(mission));
  for (VehicleSpec& vehicle : mission.vehicles) vehicle.start.position_m.z() = 500.0;
  mission.formation.position_m.z() = 500.0;
  EXPECT_TRUE(is_planar(mission));
  mission.vehicles[1].slot_offset_m.z() = 20.0;
  EXPECT_FALSE(is_planar(mission));
  mission = test::layout_a(1);
  mission.vehicles[2].start.climb_rad = 0.1;
  EXPECT_FALSE(is_planar(mission));
  mission = test::layout_a(1);
  mission.terrain = Terrain{};
  EXPECT_FALSE(is_planar(mission));
}

TEST(Space, APlanarMissionCostsTheSameInBoth) {
  const Mission mission = test::layout_a(3);
  for (const AgentId id : {1U, 2U, 3U}) {
    const auto flat = make_problem(mission, id);
    const auto space = make_problem<Spatial>(mission, id);
    RandomStream stream(id, 0, Purpose::Test, 50);
    for (int i = 0; i < 300; ++i) {
      const ph::Controls m = random_controls(space.own(), stream);
      Evaluation a;
      EvaluationIn<Spatial> b;
      evaluate(flat, m, a);
      evaluate(space, m, b);
      EXPECT_NEAR(a.own, b.own, 1e-9 * a.own) << "vehicle " << id << ", case " << i;
      EXPECT_EQ(first_violation(a.terms), first_violation(b.terms));
      for (std::size_t k = 0; k < a.points_m.size(); ++k) {
        EXPECT_NEAR((a.points_m[k] - b.points_m[k].head<2>()).norm(), 0.0, 1e-4);
      }
    }
  }
}

TEST(Space, SeparationIsTheSumOfTheSafetyRadiiWhateverTheHeights) {
  Mission mission = test::open_space(1);
  mission.vehicles[0].slot_offset_m.z() = 150.0;
  const auto problem = make_problem<Spatial>(mission, 1);
  EXPECT_EQ(required_separation_m(problem.participants[0], problem.participants[1]), 200.0);
}

TEST(Space, ThePathThatOneWouldTakeAloneIsBlocked) {
  const Mission open = test::open_space(1);
  const Mission mission = test::layout_space(1);
  const auto problem = make_problem<Spatial>(mission, 3);
  const Path path = problem.own().hermite.path(best_controls(open, 3));
  EXPECT_NEAR(path.length_m(), 33161.0, 5.0);
  EXPECT_EQ(check_alone(problem, path), Constraint::Obstacle);
  EXPECT_EQ(refute(problem, path), Constraint::Obstacle);
}

TEST(Space, TorsionAndTerrainAreNamed) {
  Mission mission = test::open_space(1);
  for (VehicleSpec& vehicle : mission.vehicles) vehicle.max_torsion_per_m = 1e-6;
  const auto twisted = make_problem<Spatial>(mission, 1);
  const ph::Controls m = best_controls(test::open_space(1), 1);
  EvaluationIn<Spatial> evaluation;
  evaluate(twisted, m, evaluation);
  EXPECT_EQ(first_violation(evaluation.terms), Constraint::Torsion);
  EXPECT_EQ(check_alone(twisted, twisted.own().hermite.path(m)), Constraint::Torsion);

  mission = test::open_space(1);
  mission.terrain = Terrain{.e = 2.2, .f = 0.001, .unit_m = 1000.0};  // a plain at 2200 m, below all but vehicle 2
  const auto low = make_problem<Spatial>(mission, 3);
  const ph::Controls dive{6.0 * low.own().hermite.chord_m(), low.own().hermite.chord_m()};
  evaluate(low, dive, evaluation);
  EXPECT_GT(evaluation.terms.terrain, 0.0);
  EXPECT_GE(own_cost(evaluation.terms, 0.5), evaluation.terms.terrain);
}

TEST(Space, WhatPassesTheDenseCheckKeepsEveryConstraint) {
  int passed = 0;
  int low = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 51);
    Mission mission = test::layout_space(seed);
    mission.planner.dense_points = stream.below(2) == 0 ? 1000 : 150;
    for (VehicleSpec& vehicle : mission.vehicles) vehicle.max_curvature_per_m = vehicle.max_torsion_per_m = 0.1;
    const auto problem = make_problem<Spatial>(mission, 1 + static_cast<AgentId>(stream.below(3)));
    const auto dense = sample_densely(problem, problem.own().hermite.path(random_controls(problem.own(), stream)));
    const Constraint verdict = check_alone(problem, dense);
    const Worst worst = worst_of(problem, dense.path);
    if (verdict == Constraint::None) {
      ++passed;
      EXPECT_LE(worst.curvature_per_m, problem.max_curvature_per_m * (1.0 + 2e-6)) << "seed " << seed;
      EXPECT_LE(worst.torsion_per_m, problem.max_torsion_per_m * (1.0 + 2e-6)) << "seed " << seed;
      EXPECT_GE(worst.clearance_m, problem.keep_out_m) << "seed " << seed;
      EXPECT_GE(worst.height_m, problem.terrain_height_m) << "seed " << seed;
    } else if (verdict == Constraint::Terrain) {
      ++low;
      EXPECT_LE(worst.height_m, problem.terrain_height_m + 2.0 * dense.sag_m + 5.0) << "seed " << seed;
    }
    if (refute(problem, dense.path) != Constraint::None) {
      EXPECT_NE(verdict, Constraint::None) << "seed " << seed;
    }
  }
  EXPECT_GT(passed, 10);
  EXPECT_GT(low, 3);
}

TEST(Space, ThreeUavsAgreeOnOneLengthAndKeepApart) {
  const test::SwarmRun run = test::run_swarm(test::layout_space(1));
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  for (const Planner& planner : run.planners) {
    const PlannerIn<Spatial>& in_space = planner.spatial();
    EXPECT_NEAR(planner.path_length_m(), run.longest_m(), 1e-9 * run.longest_m());
    const auto dense = sample_densely(in_space.problem(), in_space.path());
    EXPECT_EQ(check_alone(in_space.problem(), dense), Constraint::None);
    for (const Planner& other : run.planners) {
      if (&other == &planner) continue;
      EXPECT_TRUE(keeps_apart(dense, sample_densely(in_space.problem(), other.spatial().path()), 200.0));
    }
  }
}

TEST(Space, TheUnobstructedFiguresAreThoseOfThePaper) {
  const test::SwarmRun run = test::run_swarm(test::as_points(test::open_space(1)));
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  EXPECT_NEAR(run.longest_m(), 35047.0, 1.0);  // Table 6: 35.0470 km
  const auto least_m = [&](std::size_t i, std::size_t j) {
    const Path& a = run.planners[i].spatial().path();
    const Path& b = run.planners[j].spatial().path();
    double least = 1e9;
    for (int k = 0; k < 50; ++k) {
      const double part = k / 49.0;
      least = std::min(least, (a.position_at(part * a.length_m()) - b.position_at(part * b.length_m())).norm());
    }
    return least;
  };
  EXPECT_NEAR(least_m(0, 1), 953.0, 10.0);
  EXPECT_NEAR(least_m(0, 2), 1081.7, 0.1);
  EXPECT_NEAR(least_m(1, 2), 1200.0, 0.1);
}

TEST(Space, PlanningTwiceGivesTheSameState) {
  const auto hash = [] {
    StateHash state;
    const test::SwarmRun run = test::run_swarm(test::layout_space(5));
    for (const Planner& planner : run.planners) planner.add_to(state);
    return state.value();
  };
  EXPECT_EQ(hash(), hash());
}

}  // namespace
}  // namespace skein::rendezvous
