#include "planner/rendezvous/align/joined_level_set.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/align/level_set.hpp"
#include "planner/rendezvous/cost/coordinates.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

template <typename Space>
void expect_level_set(const ProblemIn<Space>& problem, const std::vector<double>& particle) {
  const ph::Controls from = *controls_of<Space>(particle);
  const double length_m = problem.own().hermite.length_m(from);
  for (const double factor : {0.995, 1.002, 1.08}) {
    const auto found = on_joined_rays(problem, from, factor * length_m, 0, 64);
    EXPECT_GE(found.size(), 8U) << factor;
    for (const ph::Controls& controls : found) {
      EXPECT_NEAR(problem.own().hermite.length_m(controls), factor * length_m, 1e-9 * length_m);
      EXPECT_EQ(controls.size(), from.size());
      for (std::size_t i = 0; i < controls.size(); ++i) {
        EXPECT_TRUE(range_of(problem.own(), i).contains(controls[i])) << i;
      }
    }
    EXPECT_EQ(on_joined_rays(problem, from, factor * length_m, 0, 64), found);
    EXPECT_NE(on_joined_rays(problem, from, factor * length_m, 64, 64), found);
  }
  EXPECT_EQ(on_joined_rays(problem, from, length_m, 0, 64), std::vector{from});
  EXPECT_TRUE(on_joined_rays(problem, from, 0.5 * problem.own().hermite.chord_m(), 0, 64).empty());
}

TEST(JoinedLevelSet, PointsHaveTheLengthAndKeepTheRanges) {
  expect_level_set(make_problem(test::layout_clutter(1), 3), {4e4, 5e4, 3e4, -0.9, 4e4, 0.8});
}

TEST(JoinedLevelSet, InSpaceToo) {
  expect_level_set(make_problem<Spatial>(test::open_space(1), 1), {4e4, 5e4, 3e4, -0.9, 0.2, 4e4, 0.8, -0.3});
}

}  // namespace
}  // namespace skein::rendezvous
