// Only whole plans can prove Remark 4: where no single segment is feasible, the swarm finds joined ones by itself, with
// the proofs, lengths and ends of every other plan.
#include <gtest/gtest.h>

#include <cmath>

#include "planner/rendezvous/cost/coordinates.hpp"
#include "planner/rendezvous/ph/preimage_spline.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

constexpr int kNodes = 400;
constexpr int kSamples = 200;

/// Whether a path keeps curvature and zones at samples: what is refused here violates a constraint for certain.
bool keeps_constraints(const Problem& problem, const ph::PlanarPath& path) {
  for (int i = 0; i <= kSamples; ++i) {
    const double q = static_cast<double>(i) / kSamples;
    if (std::fabs(path.curvature(q)) > problem.max_curvature_per_m) return false;
    const Vec2 here = path.position(q);
    for (const PlanarZone& zone : problem.zones) {
      if (distance_m(zone, here) < problem.keep_out_m) return false;
    }
  }
  return true;
}

/// Nodes of a grid over the search range at which one of the four interpolants is feasible.
int feasible_nodes(const Problem& problem) {
  const ph::JoinedHermite& ends = problem.own().hermite;
  const auto node = [&](int i) { return problem.own().range_m.min + problem.own().range_m.width() * i / (kNodes - 1); };
  int found = 0;
  for (int i = 0; i < kNodes; ++i) {
    for (int j = 0; j < kNodes; ++j) {
      bool feasible = false;
      for (const auto& [end_sign, root_sign] : {std::pair{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
        ph::SplineCoefficients<ph::Complex> c{};
        c[0] = std::sqrt(node(i)) * ends.half_start();
        c[2] = end_sign * std::sqrt(node(j)) * ends.half_end();
        c = ph::closed(c, 1, ph::Complex{ends.chord_m(), 0.0}, root_sign);
        const ph::Complex turn = ends.half_chord();
        const ph::PlanarPath path(ends.start_m(), {turn * c[0], turn * c[1], turn * c[2]});
        EXPECT_LE((path.position(1.0) - ends.path({4e4, 4e4}).position(1.0)).norm(), 1e-5);
        feasible = feasible || keeps_constraints(problem, path);
      }
      if (feasible) ++found;
    }
  }
  return found;
}

TEST(ClutterProperty, TheOracleFindsNoSingleSegment) {
  EXPECT_EQ(feasible_nodes(make_problem(test::layout_clutter(0), 1)), 0);
  EXPECT_EQ(feasible_nodes(make_problem(test::layout_clutter(0), 3)), 0);
  EXPECT_GT(feasible_nodes(make_problem(test::layout_clutter(0), 2)), 0);
}

template <typename Space>
const PlannerIn<Space>& in(const Planner& planner) {
  return std::get<PlannerIn<Space>>(planner.in_space());
}

/// One length, every own constraint proved, all apart.
template <typename Space>
void expect_proved(const test::SwarmRun& run) {
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  const double length_m = run.planners[0].path_length_m();
  for (const Planner& planner : run.planners) {
    const ProblemIn<Space>& problem = in<Space>(planner).problem();
    const auto own = sample_densely(problem, in<Space>(planner).path());
    EXPECT_NEAR(planner.path_length_m(), length_m, 1e-9 * length_m);
    EXPECT_EQ(check_alone(problem, own), Constraint::None);
    for (const Planner& other : run.planners) {
      if (&other == &planner) continue;
      const auto peer = sample_densely(problem, in<Space>(other).path());
      EXPECT_TRUE(keeps_apart(own, peer, required_separation_m(problem.own(), in<Space>(other).problem().own())));
    }
  }
}

TEST(ClutterProperty, JoinedSegmentsAreChosenByThemselves) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const test::SwarmRun run = test::run_swarm(test::layout_clutter(seed), 400);
    expect_proved<Planar>(run);
    EXPECT_LT(run.longest_m(), 39000.0);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t pieces = run.planners[i].planar().path().pieces().size();
      EXPECT_EQ(run.last[i].representative.particle.size(), 2 * pieces);
      EXPECT_GE(pieces, i == 1 ? 1U : 2U);
    }
  }
}

TEST(ClutterProperty, OneSegmentAllowedFailsAndNamesTheConstraint) {
  Mission mission = test::layout_clutter(1);
  mission.planner.max_segments = 1;
  const test::SwarmRun run = test::run_swarm(mission, 400);
  ASSERT_TRUE(run.all(PlanStatus::Failed));
  EXPECT_TRUE(has_own_trouble(run.last[0].failed_constraint));
  EXPECT_EQ(run.last[0].failed_peer, 0U);
  mission.planner.max_segments = 2;  // enough for UAV 3, not for UAV 1
  EXPECT_TRUE(test::run_swarm(mission, 400).all(PlanStatus::Failed));
}

TEST(ClutterProperty, WhoeverIsLostTheOthersChangeStageTogether) {
  for (std::size_t lost = 0; lost < 3; ++lost) {
    for (const int when : {20, 51, 52, 53, 54, 70, 105, 106, 107}) {
      SCOPED_TRACE("UAV " + std::to_string(lost + 1) + " lost in round " + std::to_string(when));
      const test::SwarmRun run = test::run_swarm(test::layout_clutter(2), 400, [&](int round, test::SwarmRun& swarm) {
        if (round != when) return;
        swarm.planners.erase(swarm.planners.begin() + static_cast<std::ptrdiff_t>(lost));
        swarm.last.erase(swarm.last.begin() + static_cast<std::ptrdiff_t>(lost));
      });
      ASSERT_EQ(run.planners.size(), 2U);
      expect_proved<Planar>(run);
    }
  }
}

TEST(ClutterProperty, ASoloSearchJoinsSegmentsToo) {
  Mission mission = test::layout_clutter(3);
  mission.planner = *defaults_of("dcpso-solo");
  const test::SwarmRun run = test::run_swarm(mission, 400);
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  EXPECT_GE(run.planners[0].planar().path().pieces().size(), 2U);
  EXPECT_EQ(run.planners[1].planar().path().pieces().size(), 1U);
}

TEST(ClutterProperty, InSpaceToo) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mission mission = test::open_space(seed);
    mission.zones = test::layout_clutter(seed).zones;
    const test::SwarmRun run = test::run_swarm(mission, 400);
    expect_proved<Spatial>(run);
    EXPECT_GE(run.planners[0].spatial().path().pieces().size(), 2U);
  }
}

}  // namespace
}  // namespace skein::rendezvous
