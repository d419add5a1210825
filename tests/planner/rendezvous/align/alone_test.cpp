#include "planner/rendezvous/align/alone.hpp"

#include <gtest/gtest.h>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

TEST(Alone, LowersTheCostToTheOptimum) {
  const Problem problem = make_problem(test::open_field(1), 1);
  const AlonePath found = best_alone(problem, {50000.0, 12000.0});
  EXPECT_EQ(found.violated, Constraint::None);
  EXPECT_NEAR(found.length_m, 35061.1, 0.5);
}

TEST(Alone, RepairsAParticleThatViolates) {
  // UAV 3's unobstructed optimum runs through the circle of layout A.
  const Problem problem = make_problem(test::layout_a(1), 3);
  const ph::Controls bad{7534.0, 3373.0};
  ASSERT_EQ(check_alone(problem, problem.own().hermite.path(bad)), Constraint::Obstacle);
  const AlonePath found = best_alone(problem, bad);
  EXPECT_EQ(found.violated, Constraint::None);
  EXPECT_EQ(check_alone(problem, problem.own().hermite.path(found.controls)), Constraint::None);
  EXPECT_NEAR(found.length_m, 34340.0, 15.0);
}

TEST(Alone, NamesWhatCannotBeKept) {
  Mission mission = test::open_field(1);
  mission.zones = {test::circle_km(2.0, -5.0, 0.1)};  // round the start of UAV 1
  EXPECT_EQ(best_alone(make_problem(mission, 1), {40000.0, 10000.0}).violated, Constraint::Obstacle);
  mission.zones = {test::rectangle_km(29.0, 31.0, 14.0, 16.0)};  // round the slots
  EXPECT_EQ(best_alone(make_problem(mission, 1), {40000.0, 10000.0}).violated, Constraint::NoFly);
  mission.zones.clear();
  mission.vehicles[0].max_curvature_per_m = 1e-5;
  EXPECT_EQ(best_alone(make_problem(mission, 1), {40000.0, 10000.0}).violated, Constraint::Curvature);
}

}  // namespace
}  // namespace skein::rendezvous
