#include "planner/rendezvous/swarm/joined_swarm.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/cost/coordinates.hpp"
#include "planner/rendezvous/swarm/search.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

std::uint64_t hash_of(const JoinedSwarmIn<Planar>& swarm) {
  StateHash hash;
  swarm.add_to(hash);
  return hash.value();
}

TEST(JoinedSwarm, FindsAPathWhereASingleSegmentHasNone) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Problem problem = make_problem(test::layout_clutter(seed), 3);
    JoinedSwarmIn<Planar> swarm(problem, 2, {4e4, 4e4});
    double before = swarm.own_best().own;
    for (int k = 0; k < problem.options.generations; ++k) {
      swarm.advance(problem, {}, std::nullopt);
      EXPECT_LE(swarm.own_best().own, before);
      before = swarm.own_best().own;
    }
    EXPECT_EQ(swarm.generation(), problem.options.generations);
    EXPECT_EQ(first_violation(swarm.own_best().terms), Constraint::None) << "seed " << seed;
    EXPECT_EQ(segments_of<Planar>(swarm.own_best().controls), 2U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_TRUE(range_of(problem.own(), i).contains(swarm.best().controls[i])) << i;
    }
  }
}

TEST(JoinedSwarm, SameSeedSameStateAndAnotherSeedAnother) {
  const Problem problem = make_problem(test::layout_clutter(4), 1);
  Problem other = problem;
  other.seed = 5;
  JoinedSwarmIn<Planar> first(problem, 3, {4e4, 4e4});
  JoinedSwarmIn<Planar> second(problem, 3, {4e4, 4e4});
  EXPECT_NE(hash_of(first), hash_of(JoinedSwarmIn<Planar>(other, 3, {4e4, 4e4})));
  for (int k = 0; k < 5; ++k) {
    first.advance(problem, {}, 38000.0);
    second.advance(problem, {}, 38000.0);
    EXPECT_EQ(hash_of(first), hash_of(second));
  }
}

TEST(JoinedSwarm, BeginsAtThePathThatWasThere) {
  const Problem problem = make_problem(test::open_field(1), 1);
  const ph::Controls before{50000.0, 60000.0};
  Evaluation single;
  evaluate(problem, before, single);
  for (std::size_t segments = 2; segments <= 4; ++segments) {
    const JoinedSwarmIn<Planar> swarm(problem, segments, before);
    EXPECT_LE(swarm.best().own, single.own * (1.0 + 1e-9));
  }
}

TEST(JoinedSwarm, AReferenceLengthPullsTheRepresentative) {
  const Problem problem = make_problem(test::open_field(1), 2);
  JoinedSwarmIn<Planar> swarm(problem, 2, {4e4, 4e4});
  for (int k = 0; k < problem.options.generations; ++k) swarm.advance(problem, {}, 35000.0);
  EXPECT_NEAR(swarm.best().length_m, 35000.0, 100.0);
  EXPECT_LT(swarm.own_best().length_m, 34000.0);
}

TEST(JoinedSwarm, IsWhatEveryPlannerSearchesJoinedSegmentsBy) {
  for (const std::string_view name : kRendezvousPlanners) {
    Problem problem = make_problem(test::open_field(1), 2);
    problem.options.name = name;
    const Search one(problem, 1, {4e4, 4e4});
    const Search three(problem, 3, {4e4, 4e4});
    EXPECT_EQ(one.best().controls.size(), 2U) << name;
    EXPECT_EQ(three.best().controls.size(), 6U) << name;
  }
}

}  // namespace
}  // namespace skein::rendezvous
