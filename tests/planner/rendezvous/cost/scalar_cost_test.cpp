#include "planner/rendezvous/cost/scalar_cost.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/cost/coordinates.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

/// Three gentle segments of UAV 1.
ph::Controls three_segments() {
  return *controls_of<Planar>(std::vector<double>{40000.0, 50000.0, 35000.0, 0.3, 45000.0, -0.2});
}

TEST(ScalarCost, JoinedPathsHaveTheLengthEnergyAndPointsOfTheWhole) {
  const Problem problem = make_problem(test::open_field(1), 1);
  const Planar::Path path = problem.own().hermite.path(three_segments());
  Evaluation e;
  evaluate(problem, three_segments(), e);
  ASSERT_EQ(path.pieces().size(), 3U);
  EXPECT_EQ(e.controls, three_segments());
  EXPECT_EQ(e.length_m, path.length_m());
  EXPECT_DOUBLE_EQ(e.terms.curve_energy, 1000.0 * path.elastic_energy_per_m());
  EXPECT_DOUBLE_EQ(e.own, bare_cost(problem, path));
  EXPECT_EQ(first_violation(e.terms), Constraint::None);
  ASSERT_EQ(e.points_m.size(), 50U);
  EXPECT_EQ(e.points_m.front(), path.position(0.0));
  EXPECT_EQ(e.points_m.back(), path.position(1.0));
  EXPECT_LE((e.points_m[20] - path.position_at(path.length_m() * 20.0 / 49.0)).norm(), 1e-6 * path.length_m());
}

TEST(ScalarCost, AZoneInTheWayOfAnySegmentCounts) {
  Mission mission = test::open_field(1);
  const Planar::Path path = make_problem(mission, 1).own().hermite.path(three_segments());
  for (const ph::PlanarPath& piece : path.pieces()) {
    const Vec2 at_km = piece.position(0.43) / 1000.0;
    Evaluation e;
    mission.zones = {test::circle_km(at_km.x(), at_km.y(), 0.001)};
    evaluate(make_problem(mission, 1), three_segments(), e);
    EXPECT_EQ(first_violation(e.terms), Constraint::Obstacle);
    EXPECT_EQ(refute(make_problem(mission, 1), path), Constraint::None);  // it looks at points alone
    EXPECT_EQ(check_alone(make_problem(mission, 1), path), Constraint::Obstacle);
  }
}

TEST(ScalarCost, CurvatureOfAnySegmentCounts) {
  Mission mission = test::open_field(1);
  const Planar::Path path = make_problem(mission, 1).own().hermite.path(three_segments());
  for (VehicleSpec& vehicle : mission.vehicles) vehicle.max_curvature_per_m = 0.9 * max_curvature_per_m(path);
  Evaluation e;
  evaluate(make_problem(mission, 1), three_segments(), e);
  EXPECT_EQ(first_violation(e.terms), Constraint::Curvature);
  EXPECT_EQ(e.own, bare_cost(make_problem(mission, 1), path) + 1e5);
}

}  // namespace
}  // namespace skein::rendezvous
