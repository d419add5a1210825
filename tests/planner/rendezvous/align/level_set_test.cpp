#include "planner/rendezvous/align/level_set.hpp"

#include <gtest/gtest.h>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

TEST(LevelSet, RaysEndAtTheLength) {
  const Problem problem = make_problem(test::open_field(1), 2);
  const Participant& uav = problem.own();
  const auto found = on_rays(uav, {71000.0, 121000.0}, 35061.0, 64);
  EXPECT_GT(found.size(), 16U);
  for (const ph::Controls& m : found) {
    EXPECT_NEAR(uav.hermite.length_m(m), 35061.0, 35061.0 * kLengthTolerance);
    EXPECT_TRUE(uav.range_m.contains(m.m0_m) && uav.range_m.contains(m.m1_m));
  }
}

TEST(LevelSet, AParticleOfTheLengthIsTakenAsItIs) {
  const Problem problem = make_problem(test::open_field(1), 2);
  const ph::Controls m{71000.0, 121000.0};
  const auto found = on_rays(problem.own(), m, problem.own().hermite.length_m(m), 64);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0], m);
}

TEST(LevelSet, GridEdgesCrossTheWholeLevelCurve) {
  const Problem problem = make_problem(test::open_field(1), 3);
  const auto found = on_grid(problem.own(), 35061.0, 64);
  EXPECT_GT(found.size(), 50U);
  for (const ph::Controls& m : found) {
    EXPECT_NEAR(problem.own().hermite.length_m(m), 35061.0, 35061.0 * kLengthTolerance);
  }
}

TEST(LevelSet, NothingIsShorterThanTheChord) {
  const Problem problem = make_problem(test::open_field(1), 1);
  const double length_m = 0.99 * problem.own().hermite.chord_m();
  EXPECT_TRUE(on_grid(problem.own(), length_m, 64).empty());
  EXPECT_TRUE(on_rays(problem.own(), {40000.0, 40000.0}, length_m, 64).empty());
}

TEST(LevelSet, SameLengthIsRelative) {
  EXPECT_TRUE(same_length(35000.0, 35000.0 + 3e-6));
  EXPECT_FALSE(same_length(35000.0, 35000.0 + 5e-6));
}

}  // namespace
}  // namespace skein::rendezvous
