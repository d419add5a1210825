#include "planner/rendezvous/cost/coordinates.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "planner/core/math/det_math.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

std::vector<double> counted(std::size_t size) {
  std::vector<double> particle(size);
  std::iota(particle.begin(), particle.end(), 1.0);
  return particle;
}

TEST(Coordinates, SizesNameTheNumberOfSegments) {
  for (std::size_t segments = 1; segments <= 4; ++segments) {
    EXPECT_EQ(segments_of<Planar>(*controls_of<Planar>(counted(2 * segments))), segments);
    EXPECT_EQ(segments_of<Spatial>(*controls_of<Spatial>(counted(3 * segments - 1))), segments);
    EXPECT_EQ(particle_size<Planar>(segments), 2 * segments);
    EXPECT_EQ(particle_size<Spatial>(segments), 3 * segments - 1);
  }
  for (const std::size_t size : {0U, 1U, 3U, 5U, 7U, 9U, 10U, 16U}) {
    EXPECT_FALSE(controls_of<Planar>(counted(size)).has_value()) << size;
  }
  for (const std::size_t size : {0U, 3U, 4U, 6U, 12U, 14U}) {
    EXPECT_FALSE(controls_of<Spatial>(counted(size)).has_value()) << size;
  }
}

TEST(Coordinates, AParticleSurvivesTheWayThroughControls) {
  const std::vector<double> particle = counted(8);
  const ph::Controls controls = *controls_of<Planar>(particle);
  EXPECT_EQ(controls.m0_m, 1.0);
  EXPECT_EQ(controls.m1_m, 2.0);
  EXPECT_EQ(controls.interior.values[5], 8.0);
  EXPECT_EQ(particle_of(controls), particle);
}

TEST(Coordinates, EqualityAndHashKnowTheInterior) {
  const ph::Controls a = *controls_of<Planar>(std::vector<double>{1.0, 2.0, 3.0, 0.5});
  ph::Controls b = a;
  b[3] = 0.25;
  EXPECT_FALSE(a == b);
  EXPECT_FALSE(a == ph::Controls(1.0, 2.0));
  StateHash of_a;
  StateHash of_b;
  add_to(of_a, a);
  add_to(of_b, b);
  EXPECT_NE(of_a.value(), of_b.value());
}

TEST(Coordinates, RangesAreThoseOfLengthsAndAngles) {
  const Problem problem = make_problem(test::open_field(1), 1);
  EXPECT_EQ(range_of(problem.own(), 1), problem.own().range_m);
  EXPECT_EQ(range_of(problem.own(), 2), problem.own().range_m);
  EXPECT_EQ(range_of(problem.own(), 3), (Interval{-math::kPi, math::kPi}));
  const ProblemIn<Spatial> space = make_problem<Spatial>(test::open_space(1), 1);
  EXPECT_FALSE(is_angle<Spatial>(2));
  EXPECT_TRUE(is_angle<Spatial>(3));
  EXPECT_TRUE(is_angle<Spatial>(4));
  EXPECT_FALSE(is_angle<Spatial>(5));
  const ph::Controls far = *controls_of<Spatial>(std::vector<double>{-1.0, 1e9, 1e9, 4.0, -4.0});
  const ph::Controls near = clamped(space.own(), far);
  for (std::size_t i = 0; i < near.size(); ++i) EXPECT_TRUE(range_of(space.own(), i).contains(near[i])) << i;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_GE(start_range(problem.own(), i).min, range_of(problem.own(), i).min);
    EXPECT_LE(start_range(problem.own(), i).max, range_of(problem.own(), i).max);
  }
}

}  // namespace
}  // namespace skein::rendezvous
