#include "planner/rendezvous/swarm/genetic_population.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/swarm/sub_swarm.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

Problem problem_of(Mission mission, AgentId self) {
  mission.planner = *defaults_of("ccga");
  return make_problem(mission, self);
}

GeneticPopulation evolved(const Problem& problem, int generations) {
  GeneticPopulation population(problem);
  for (int g = 0; g < generations; ++g) population.advance(problem, std::span<const PeerPath>(), std::nullopt);
  return population;
}

std::uint64_t hash_of(const GeneticPopulation& population) {
  StateHash hash;
  population.add_to(hash);
  return hash.value();
}

TEST(GeneticPopulation, StartsWhereTheSubSwarmStarts) {
  const Problem problem = problem_of(test::layout_a(3), 2);
  EXPECT_EQ(GeneticPopulation(problem).best().controls, SubSwarm(problem).best().controls);
}

TEST(GeneticPopulation, SameSeedSameState) {
  const Problem problem = problem_of(test::layout_a(3), 2);
  EXPECT_EQ(hash_of(evolved(problem, 7)), hash_of(evolved(problem, 7)));
  EXPECT_NE(hash_of(evolved(problem, 7)), hash_of(evolved(problem, 8)));
  EXPECT_NE(hash_of(evolved(problem, 7)), hash_of(evolved(problem_of(test::layout_a(4), 2), 7)));
}

TEST(GeneticPopulation, TheEliteNeverGetsWorseWhileNothingElseChanges) {
  for (const std::int32_t size : {20, 21}) {  // of an odd population, the last pair has one child
    Problem problem = problem_of(test::layout_b(5), 3);
    problem.options.particles = size;
    GeneticPopulation population(problem);
    for (int g = 1; g <= 50; ++g) {
      const double best = population.best().modified;
      const double own = population.own_best().own;
      population.advance(problem, std::span<const PeerPath>(), std::nullopt);
      EXPECT_EQ(population.generation(), g);
      EXPECT_LE(population.best().modified, best);
      EXPECT_LE(population.own_best().own, own);
      EXPECT_TRUE(problem.own().range_m.contains(population.best().controls.m0_m));
      EXPECT_TRUE(problem.own().range_m.contains(population.best().controls.m1_m));
    }
  }
}

TEST(GeneticPopulation, WithoutCrossoverAndMutationNothingNewComes) {
  Problem problem = problem_of(test::layout_a(1), 1);
  problem.options.crossover_probability = 0.0;
  problem.options.mutation_probability = 0.0;
  const Evaluation first = GeneticPopulation(problem).best();
  const GeneticPopulation last = evolved(problem, 30);
  EXPECT_EQ(last.best().controls, first.controls);
  EXPECT_EQ(last.own_best().own, first.own);
}

TEST(GeneticPopulation, CrossoverAloneStaysWithinTheParents) {
  Problem problem = problem_of(test::open_field(1), 1);
  problem.options.particles = 2;
  problem.options.mutation_probability = 0.0;
  // Two individuals: whatever is bred from them lies on the segment between them.
  std::vector<ph::Controls> ends;
  for (const std::uint64_t j : {0U, 1U}) {
    RandomStream stream(problem.seed, 1, Purpose::SwarmStart, j);
    const Interval& range = problem.own().range_m;
    const double m0_m = stream.uniform(range.min, range.max);
    ends.push_back({m0_m, stream.uniform(range.min, range.max)});
  }
  const GeneticPopulation population = evolved(problem, 20);
  const ph::Controls& m = population.best().controls;
  const double a = (m.m0_m - ends[1].m0_m) / (ends[0].m0_m - ends[1].m0_m);
  EXPECT_GE(a, -1e-12);
  EXPECT_LE(a, 1.0 + 1e-12);
  EXPECT_NEAR(m.m1_m, a * ends[0].m1_m + (1.0 - a) * ends[1].m1_m, 1e-6);
}

TEST(GeneticPopulation, ItsCostsFollowTheReferenceLength) {
  const Problem problem = problem_of(test::open_field(2), 2);
  GeneticPopulation population = evolved(problem, 50);
  ASSERT_LT(population.best().length_m, 32000.0);
  for (int g = 0; g < 50; ++g) population.advance(problem, std::span<const PeerPath>(), 35061.0);
  EXPECT_NEAR(population.best().length_m, 35061.0, 350.0);
  EXPECT_LT(population.own_best().length_m, 32000.0);
}

TEST(GeneticPopulation, StaleCostsStayAsTheyWereStored) {
  Problem problem = problem_of(test::open_field(2), 2);
  problem.options.refresh_costs = 0;
  GeneticPopulation population = evolved(problem, 50);
  const double cost = population.best().modified;
  population.advance(problem, std::span<const PeerPath>(), 60000.0);  // by the new reference every path costs far more
  EXPECT_EQ(population.best().modified, cost);
}

}  // namespace
}  // namespace skein::rendezvous
