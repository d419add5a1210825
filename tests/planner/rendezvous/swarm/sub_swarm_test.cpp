#include "planner/rendezvous/swarm/sub_swarm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

SubSwarm evolved(const Problem& problem, int generations) {
  SubSwarm swarm(problem);
  for (int g = 0; g < generations; ++g) swarm.advance(problem, std::span<const PeerPath>(), std::nullopt);
  return swarm;
}

/// Best lengths (km) of the three UAVs, each for itself, over all generations.
std::vector<Evaluation> alone(const Mission& mission) {
  std::vector<Evaluation> bests;
  for (AgentId id = 1; id <= 3; ++id) {
    const Problem problem = make_problem(mission, id);
    evaluate(problem, evolved(problem, 50).own_best().controls, bests.emplace_back());
  }
  return bests;
}

double least_separation_km(const Evaluation& a, const Evaluation& b) {
  double least = 1e9;
  for (std::size_t k = 0; k < a.points_m.size(); ++k) least = std::min(least, (a.points_m[k] - b.points_m[k]).norm());
  return least / 1000.0;
}

TEST(SubSwarm, TheOpenFieldOptimumOfThePaper) {
  const auto bests = alone(test::open_field(1));
  EXPECT_NEAR(bests[0].length_m, 35061.1, 2.0);
  EXPECT_NEAR(bests[1].length_m, 31376.2, 4.0);
  EXPECT_NEAR(bests[2].length_m, 33126.6, 4.0);
}

TEST(SubSwarm, LayoutAWithoutCooperationIsThePapersTable3) {
  const auto bests = alone(test::as_points(test::layout_a(1)));
  EXPECT_NEAR(bests[0].length_m, 35061.1, 2.0);
  EXPECT_NEAR(bests[1].length_m, 31376.2, 4.0);
  EXPECT_NEAR(bests[2].length_m, 34336.1, 8.0);  // the paper's own layout, known from figures only, gives 34343.9
  EXPECT_NEAR(least_separation_km(bests[0], bests[1]), 0.7862, 1e-3);
  EXPECT_NEAR(least_separation_km(bests[0], bests[2]), 1.0817, 1e-4);
  EXPECT_NEAR(least_separation_km(bests[1], bests[2]), 1.2000, 1e-4);
}

TEST(SubSwarm, SameSeedSameState) {
  const Problem problem = make_problem(test::layout_a(3), 2);
  const auto hash_of = [](const SubSwarm& swarm) {
    StateHash hash;
    swarm.add_to(hash);
    return hash.value();
  };
  EXPECT_EQ(hash_of(evolved(problem, 7)), hash_of(evolved(problem, 7)));
  EXPECT_NE(hash_of(evolved(problem, 7)), hash_of(evolved(problem, 8)));
  EXPECT_NE(hash_of(evolved(problem, 7)), hash_of(evolved(make_problem(test::layout_a(4), 2), 7)));
}

TEST(SubSwarm, BestsNeverGetWorseWhileNothingElseChanges) {
  const Problem problem = make_problem(test::layout_b(5), 3);
  SubSwarm swarm(problem);
  for (int g = 1; g <= 50; ++g) {
    const double best = swarm.best().modified;
    const double own = swarm.own_best().own;
    swarm.advance(problem, std::span<const PeerPath>(), std::nullopt);
    EXPECT_EQ(swarm.generation(), g);
    EXPECT_LE(swarm.best().modified, best);
    EXPECT_LE(swarm.own_best().own, own);
    EXPECT_TRUE(problem.own().range_m.contains(swarm.best().controls.m0_m));
    EXPECT_TRUE(problem.own().range_m.contains(swarm.best().controls.m1_m));
  }
}

TEST(SubSwarm, StoredCostsFollowTheReferenceLength) {
  const Problem problem = make_problem(test::open_field(2), 2);
  SubSwarm swarm = evolved(problem, 30);
  ASSERT_LT(swarm.best().length_m, 32000.0);
  for (int g = 0; g < 30; ++g) swarm.advance(problem, std::span<const PeerPath>(), 35061.0);
  EXPECT_NEAR(swarm.best().length_m, 35061.0, 30.0);
  EXPECT_LT(swarm.own_best().length_m, 32000.0);
}

TEST(SubSwarm, StaleCostsStayAsTheyWereStored) {
  Problem problem = make_problem(test::open_field(2), 2);
  problem.options.refresh_costs = 0;
  SubSwarm swarm = evolved(problem, 30);
  const double cost = swarm.best().modified;
  swarm.advance(problem, std::span<const PeerPath>(), 60000.0);  // by the new reference every path costs far more
  EXPECT_EQ(swarm.best().modified, cost);
  problem.options.refresh_costs = 1;
  swarm.advance(problem, std::span<const PeerPath>(), 60000.0);
  EXPECT_GT(swarm.best().modified, 2.0 * cost);
}

TEST(SubSwarm, ARepresentativeInTheWayIsAvoided) {
  const Problem problem = make_problem(test::open_field(2), 1);
  SubSwarm swarm = evolved(problem, 40);
  const PeerPath blocker{2, 200.0, swarm.best().points_m};
  PeerPath shifted = blocker;
  for (std::size_t k = 5; k + 5 < shifted.points_m.size(); ++k) shifted.points_m[k] += Vec2(50.0, 50.0);
  for (std::size_t k = 0; k < 5; ++k) shifted.points_m[k] = shifted.points_m[49 - k] = Vec2(-1e6, -1e6);
  for (int g = 0; g < 30; ++g) swarm.advance(problem, std::span<const PeerPath>(&shifted, 1), std::nullopt);
  EXPECT_EQ(first_violation(swarm.best().terms), Constraint::None);
  EXPECT_GT((swarm.best().points_m[25] - shifted.points_m[25]).norm(), 200.0);
}

}  // namespace
}  // namespace skein::rendezvous
