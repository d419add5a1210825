#include "planner/rendezvous/cost/cost.hpp"

#include <gtest/gtest.h>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

Evaluation evaluated(const Problem& problem, double m0_km, double m1_km) {
  Evaluation evaluation;
  evaluate(problem, {1000.0 * m0_km, 1000.0 * m1_km}, evaluation);
  return evaluation;
}

TEST(Cost, TermsAreInTheLengthUnit) {
  // The unobstructed optimum of UAV 1 (docs/families/rendezvous.md): 35.0611 km; w1 L + (1 - w1) E = 17.6029.
  const Evaluation e = evaluated(make_problem(test::open_field(1), 1), 37.333, 7.879);
  EXPECT_NEAR(e.length_m, 35061.1, 0.1);
  EXPECT_NEAR(e.terms.length, 35.0611, 1e-4);
  EXPECT_NEAR(e.own, 17.60291, 1e-5);
  EXPECT_DOUBLE_EQ(e.own, 0.5 * e.terms.length + 0.5 * e.terms.curve_energy);
  EXPECT_EQ(e.modified, e.own);
  EXPECT_EQ(first_violation(e.terms), Constraint::None);
  EXPECT_EQ(e.points_m.size(), 50U);
}

TEST(Cost, TheUnitDoesNotChangeThePath) {
  Mission mission = test::open_field(1);
  mission.length_unit_m = 1.0;
  const Evaluation e = evaluated(make_problem(mission, 1), 37.333, 7.879);
  EXPECT_NEAR(e.terms.length, 35061.1, 0.1);
  EXPECT_NEAR(e.terms.curve_energy, 0.1447e-3, 1e-7);
}

TEST(Cost, EachConstraintHasItsPenalty) {
  Mission mission = test::open_field(1);
  const auto terms_with = [&](const std::vector<Zone>& zones) {
    mission.zones = zones;
    return evaluated(make_problem(mission, 1), 37.333, 7.879).terms;
  };
  const Vec2 middle = make_problem(mission, 1).own().hermite.path({37333.0, 7879.0}).position(0.5);
  const double x = middle.x() / 1000.0;
  const double y = middle.y() / 1000.0;
  EXPECT_EQ(terms_with({test::circle_km(x, y, 0.5)}).obstacle, 1e5);
  EXPECT_EQ(terms_with({test::circle_km(x, y, 0.5)}).no_fly, 0.0);
  EXPECT_EQ(terms_with({test::rectangle_km(x, x + 1.0, y, y + 1.0)}).no_fly, 1e5);
  // A circle of 1 m between two of the 50 points is met by the chord, kept out of by 7 m.
  EXPECT_EQ(terms_with({test::circle_km(x, y, 0.001)}).obstacle, 1e5);
  mission.vehicles[0].max_curvature_per_m = 1e-5;
  EXPECT_EQ(terms_with({}).unflyable, 1e5);
}

TEST(Cost, FirstViolationFollowsTheOrderOfTheEnumeration) {
  CostTerms terms;
  terms.dtime = 1.0;
  EXPECT_EQ(first_violation(terms), Constraint::None);
  terms.collision = 1e5;
  EXPECT_EQ(first_violation(terms), Constraint::Separation);
  terms.no_fly = 1e5;
  EXPECT_EQ(first_violation(terms), Constraint::NoFly);
  terms.obstacle = 1e5;
  EXPECT_EQ(first_violation(terms), Constraint::Obstacle);
  terms.unflyable = 1e5;
  EXPECT_EQ(first_violation(terms), Constraint::Curvature);
  EXPECT_EQ(own_cost(terms, 0.5), 3e5);
  EXPECT_EQ(modified_cost(terms, 0.5), 4e5 + 1.0);
}

TEST(Cost, LengthsPullQuadratically) {
  const Problem problem = make_problem(test::open_field(1), 1);
  Evaluation e = evaluated(problem, 37.333, 7.879);
  modify(problem, {}, e.length_m + 200.0, e);
  EXPECT_NEAR(e.terms.dtime, 100.0 * 0.2 * 0.2, 1e-9);
  EXPECT_DOUBLE_EQ(e.modified, e.own + e.terms.dtime);
  modify(problem, {}, std::nullopt, e);
  EXPECT_EQ(e.terms.dtime, 0.0);
  EXPECT_EQ(e.modified, e.own);
}

TEST(Cost, PointsWithTheSameNumberMustKeepApart) {
  const Problem problem = make_problem(test::open_field(1), 1);
  Evaluation e = evaluated(problem, 37.333, 7.879);
  PeerPath peer{2, 200.0, e.points_m};
  for (Vec2& point : peer.points_m) point += Vec2(0.0, 201.0);
  modify(problem, {&peer, 1}, std::nullopt, e);
  EXPECT_EQ(e.terms.collision, 0.0);
  peer.points_m[31] -= Vec2(0.0, 2.0);
  modify(problem, {&peer, 1}, std::nullopt, e);
  EXPECT_EQ(e.terms.collision, 1e5);
  // The same places at other times are no collision.
  Evaluation ahead = e;
  for (std::size_t k = 0; k < 50; ++k) peer.points_m[k] = e.points_m[k == 49 ? 0 : k + 1];
  modify(problem, {&peer, 1}, std::nullopt, ahead);
  EXPECT_EQ(ahead.terms.collision, 0.0);
}

}  // namespace
}  // namespace skein::rendezvous
