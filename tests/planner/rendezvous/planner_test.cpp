#include "planner/rendezvous/planner.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

std::uint64_t hash_of(const Planner& planner) {
  StateHash hash;
  planner.add_to(hash);
  return hash.value();
}

TEST(Planner, FirstRoundIsGenerationZeroAndReadsNoPeers) {
  Planner planner(test::layout_a(1), 2);
  const PlanRound round = planner.advance({});
  EXPECT_EQ(round.generation, 0U);
  EXPECT_EQ(round.status, PlanStatus::Planning);
  EXPECT_EQ(round.representative.agent, 2U);
  EXPECT_EQ(round.representative.stage, PlanStage::Searching);
  EXPECT_EQ(round.representative.particle.size(), 2U);
  EXPECT_EQ(round.representative.path_length_m, round.representative.own_length_m);
  EXPECT_THROW((void)planner.path_length_m(), std::logic_error);
}

TEST(Planner, ThreeUavsAgreeOnOneLength) {
  const test::SwarmRun run = test::run_swarm(test::layout_a(1));
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  const double length_m = run.planners[0].path_length_m();
  EXPECT_LT(length_m, 35100.0);
  for (const Planner& planner : run.planners) {
    EXPECT_NEAR(planner.path_length_m(), length_m, 1e-9 * length_m);
    const DensePath dense = sample_densely(planner.planar().problem(), planner.planar().path());
    EXPECT_EQ(check_alone(planner.planar().problem(), dense), Constraint::None);
    for (const Planner& other : run.planners) {
      if (&other == &planner) continue;
      EXPECT_TRUE(keeps_apart(dense, sample_densely(planner.planar().problem(), other.planar().path()), 200.0));
    }
  }
  for (const PlanRound& round : run.last) {
    EXPECT_EQ(round.representative.stage, PlanStage::Settled);
    EXPECT_EQ(round.generation, 50U);
  }
}

TEST(Planner, AfterTheEndEveryCallReturnsTheSame) {
  test::SwarmRun run = test::run_swarm(test::layout_a(1));
  const PlanRound again = run.planners[0].advance({});
  EXPECT_EQ(again.status, PlanStatus::Ready);
  EXPECT_EQ(again.representative, run.last[0].representative);
}

TEST(Planner, OneUavPlansAlone) {
  Mission mission = test::layout_a(1);
  mission.vehicles = {mission.vehicles[2]};
  const test::SwarmRun run = test::run_swarm(mission);
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  EXPECT_NEAR(run.longest_m(), 34340.0, 15.0);
}

TEST(Planner, SameSeedSameStateInEveryRound) {
  const Mission mission = test::layout_b(9);
  std::vector<std::uint64_t> first;
  std::vector<std::uint64_t> second;
  for (auto* hashes : {&first, &second}) {
    (void)test::run_swarm(mission, 200, [&](int, test::SwarmRun& run) {
      for (const Planner& planner : run.planners) hashes->push_back(hash_of(planner));
    });
  }
  EXPECT_EQ(first, second);
  Mission other = mission;
  other.seed = 10;
  EXPECT_NE(hash_of(Planner(mission, 1)), hash_of(Planner(other, 1)));
}

TEST(Planner, AnAlteredRepresentativeChangesTheOthers) {
  const Mission mission = test::layout_a(4);
  const test::SwarmRun untouched = test::run_swarm(mission, 30);
  const test::SwarmRun touched = test::run_swarm(mission, 30, [](int round, test::SwarmRun& run) {
    if (round == 10) run.last[0].representative.own_length_m += 500.0;
  });
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_NE(hash_of(touched.planners[i]), hash_of(untouched.planners[i]));
    EXPECT_NE(touched.last[i].representative, untouched.last[i].representative);
  }
}

TEST(Planner, FailsTogetherAndNamesTheConstraint) {
  Mission mission = test::layout_a(1);
  mission.planner.equalise_rounds = 5;
  mission.zones.push_back(test::circle_km(-1.0, 10.0, 0.2));  // round the start of UAV 2
  const test::SwarmRun run = test::run_swarm(mission, 400);
  ASSERT_TRUE(run.all(PlanStatus::Failed));
  EXPECT_EQ(run.last[1].failed_constraint, Constraint::Obstacle);
  EXPECT_EQ(run.last[1].failed_peer, 0U);
  EXPECT_EQ(run.last[0].failed_constraint, Constraint::Obstacle);
  EXPECT_EQ(run.last[0].failed_peer, 2U);
  EXPECT_THROW((void)run.planners[0].path_length_m(), std::logic_error);
}

void expect_refused(const std::function<void(std::vector<Representative>&)>& spoil, const char* said) {
  const Mission mission = test::layout_a(1);
  Planner planner(mission, 2);
  (void)planner.advance({});
  std::vector<Representative> peers;
  for (const AgentId id : {1U, 3U}) peers.push_back(Planner(mission, id).advance({}).representative);
  Planner sound = planner;
  EXPECT_NO_THROW((void)sound.advance(peers));
  spoil(peers);
  try {
    (void)planner.advance(peers);
    ADD_FAILURE() << "accepted, though: " << said;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
  }
}

TEST(Planner, BrokenRepresentativesAreRefused) {
  using Peers = std::vector<Representative>;
  expect_refused([](Peers& p) { p[0].particle.pop_back(); }, "two numbers");
  expect_refused([](Peers& p) { p[0].particle = {1.0, 2.0, 3.0}; }, "two numbers");
  expect_refused([](Peers& p) { p[0].particle.resize(10, 1.0); }, "joined segments");
  expect_refused([](Peers& p) { p[0].particle.insert(p[0].particle.end(), {1e4, 4.0}); }, "search range");
  expect_refused([](Peers& p) { p[0].particle.insert(p[0].particle.end(), {-1.0, 0.0}); }, "search range");
  expect_refused([](Peers& p) { p[1].particle[0] = -1.0; }, "search range");
  expect_refused([](Peers& p) { p[1].particle[1] = 1e9; }, "search range");
  expect_refused([](Peers& p) { p[1].particle[1] = std::numeric_limits<double>::quiet_NaN(); }, "search range");
  expect_refused([](Peers& p) { p[0].path_length_m = 0.0; }, "length");
  expect_refused([](Peers& p) { p[0].own_length_m = std::numeric_limits<double>::infinity(); }, "length");
  expect_refused([](Peers& p) { p[0].agent = 2; }, "itself");
  expect_refused([](Peers& p) { p[1].agent = 8; }, "no participant 8");
  expect_refused([](Peers& p) { std::swap(p[0], p[1]); }, "ascend");
}

TEST(Planner, AMissionItCannotPlanIsRefused) {
  EXPECT_THROW(Planner(test::layout_a(1), 9), std::invalid_argument);
  Mission mission = test::layout_a(1);
  mission.planner.name = "other";
  EXPECT_THROW(Planner(mission, 1), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous
