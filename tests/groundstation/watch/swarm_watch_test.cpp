#include "groundstation/watch/swarm_watch.hpp"

#include <gtest/gtest.h>

#include "tests/groundstation/watch/samples.hpp"

namespace skein::watch {
namespace {

/// Both agents at 50 m/s, one step after the other, each answered 10 ms after its tick.
void fly(SwarmWatch& watch, std::uint32_t first, std::uint32_t last, double delay_s = 0.01) {
  for (std::uint32_t k = first; k <= last; ++k) {
    const double t_s = 0.1 * k;
    watch.take(at(tick_at(k, Phase::Flying, k), t_s), t_s);
    for (const AgentId id : {1U, 2U}) {
      const Vec3 place_m(25.0 * k, 500.0 * (id - 1) + 1.0, 0.0);
      watch.take(at(beacon_of(id, k, AgentMode::Flying, k, place_m), t_s + delay_s), t_s);
    }
  }
}

TEST(SwarmWatch, KnowsNothingBeforeItHears) {
  SwarmWatch watch;
  EXPECT_FALSE(watch.heard_tick());
  EXPECT_FALSE(watch.complete());
  const SwarmView view = watch.view(1.0, {});
  EXPECT_TRUE(view.agents.empty());
  EXPECT_FALSE(view.mission);
}

TEST(SwarmWatch, NamesTheMissionsAgentsAtTheirStartsBeforeTheySpeak) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  const SwarmView view = watch.view(0.0, {});
  ASSERT_EQ(view.agents.size(), 2U);
  EXPECT_FALSE(view.agents[1].heard);
  EXPECT_EQ(*view.agents[1].position_m, Vec3(0.0, 500.0, 0.0));
  EXPECT_EQ(*view.agents[1].goal_m, Vec3(10000.0, 500.0, 0.0));
  EXPECT_FALSE(watch.complete());
}

TEST(SwarmWatch, TellsEachAgentsFigures) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  fly(watch, 1, 10);
  EXPECT_TRUE(watch.complete());
  const SwarmView view = watch.view(1.25, {});
  EXPECT_EQ(view.phase, Phase::Flying);
  EXPECT_EQ(view.live, 2U);
  EXPECT_NEAR(view.times_real_time.value(), 5.0, 1e-6);
  const AgentView& agent = agent_in(view, 2);
  EXPECT_TRUE(agent.heard);
  EXPECT_TRUE(agent.live);
  EXPECT_EQ(agent.mode, AgentMode::Flying);
  EXPECT_EQ(agent.step, 10U);
  EXPECT_NEAR(agent.speed_mps, 50.0, 1e-9);
  EXPECT_NEAR(*agent.separation_m, 500.0, 1e-9);
  EXPECT_NEAR(*agent.min_separation_m, 500.0, 1e-9);
  EXPECT_NEAR(*agent.to_go_m, 9750.0, 0.1);
  EXPECT_EQ(agent.to_go_by, ToGoBy::Straight);
  EXPECT_NEAR(*agent.age_s, 0.25, 1e-9);
  EXPECT_EQ(agent.flown_m.size(), 10U);
  EXPECT_GT(agent.rate.bytes_per_s, 0.0);
  EXPECT_EQ(agent.late_steps, 0U);
}

TEST(SwarmWatch, APlanHeardGivesItsLineAndTheWayAlongIt) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  Representative plan;
  plan.run = kRun;
  plan.agent = 1;
  plan.incarnation = 1;
  plan.round = 1;
  plan.particle = {10000.0, 10000.0};
  watch.take(at(plan), 0.0);
  fly(watch, 2, 20);
  const SwarmView view = watch.view(2.0, {});
  EXPECT_EQ(agent_in(view, 1).to_go_by, ToGoBy::Plan);
  EXPECT_NEAR(*agent_in(view, 1).to_go_m, 9500.0, 1.0);
  EXPECT_FALSE(agent_in(view, 1).planned_m.empty());
  EXPECT_TRUE(agent_in(view, 2).planned_m.empty());
}

TEST(SwarmWatch, CountsAStepThatWasAnsweredAPeriodLater) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  fly(watch, 1, 20);
  fly(watch, 21, 21, 0.2);
  fly(watch, 22, 30);
  EXPECT_EQ(agent_in(watch.view(3.0, {}), 1).late_steps, 1U);
}

TEST(SwarmWatch, ClocksThatDifferAreNotLate) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  fly(watch, 1, 30, 3600.0);
  EXPECT_EQ(agent_in(watch.view(3.0, {}), 1).late_steps, 0U);
}

TEST(SwarmWatch, CostsFollowTheGenerationsAndBeginAgainWithANewSearch) {
  SwarmWatch watch;
  for (std::uint32_t g = 0; g < 5; ++g) {
    Beacon beacon = beacon_of(1, g + 1, AgentMode::Planning);
    beacon.generation = g;
    beacon.cost = 40.0 - g;
    watch.take(at(beacon), 0.1 * g);
  }
  ASSERT_EQ(agent_in(watch.view(1.0, {}), 1).costs.size(), 5U);
  EXPECT_EQ(agent_in(watch.view(1.0, {}), 1).costs.back(), (CostPoint{4, 36.0}));
  Beacon again = beacon_of(1, 6, AgentMode::Planning);
  again.generation = 1;
  again.cost = 50.0;
  watch.take(at(again), 0.6);
  EXPECT_EQ(agent_in(watch.view(1.0, {}), 1).costs.size(), 1U);
}

// Once the search is over, the paths are fitted to each other, and charged for margins that the flight does not have.
TEST(SwarmWatch, TheCostOfAPlanIsThatOfItsSearch) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  EXPECT_FALSE(agent_in(watch.view(0.0, {}), 1).cost);
  const auto say = [&](std::uint32_t round, AgentMode mode, std::uint32_t generation, double cost) {
    Beacon beacon = beacon_of(1, round, mode);
    beacon.generation = generation;
    beacon.cost = cost;
    watch.take(at(beacon), 0.1 * round);
  };
  say(1, AgentMode::Planning, 50, 17.5);
  say(2, AgentMode::Planning, 50, 100017.5);
  say(3, AgentMode::Ready, 50, 100017.5);
  say(4, AgentMode::Flying, 50, 100017.5);
  const SwarmView flying = watch.view(1.0, {});
  EXPECT_EQ(agent_in(flying, 1).cost, 17.5);
  EXPECT_EQ(agent_in(flying, 1).costs, (std::vector<CostPoint>{{50, 17.5}}));
  say(5, AgentMode::Holding, 0, 0.0);
  const SwarmView holding = watch.view(1.0, {});
  EXPECT_EQ(agent_in(holding, 1).cost, 17.5);
  EXPECT_EQ(agent_in(holding, 1).generation, 50U);
}

TEST(SwarmWatch, WhoFliesElsewhereByCommandHasNoDistanceToGo) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  watch.take(at(beacon_of(1, 1, AgentMode::Holding, 1, {10.0, 0.0, 0.0})), 0.1);
  EXPECT_NEAR(agent_in(watch.view(1.0, {}), 1).to_go_m.value(), 9990.0, 1e-9);
  watch.take(at(beacon_of(1, 2, AgentMode::GoingTo, 2, {10.0, 0.0, 0.0})), 0.2);
  EXPECT_FALSE(agent_in(watch.view(1.0, {}), 1).to_go_m);
}

TEST(SwarmWatch, ASeparationIsOfOneRound) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  watch.take(at(tick_at(1, Phase::Flying, 1)), 0.0);
  watch.take(at(beacon_of(1, 1, AgentMode::Flying, 1, {10.0, 0.0, 0.0})), 0.1);
  watch.take(at(beacon_of(2, 1, AgentMode::Flying, 1, {10.0, 500.0, 0.0})), 0.1);
  watch.take(at(beacon_of(1, 2, AgentMode::Flying, 2, {10.0, 100.0, 0.0})), 0.2);
  EXPECT_NEAR(agent_in(watch.view(0.2, {}), 1).separation_m.value(), 500.0, 1e-9) << "agent 2 is not there yet";
  watch.take(at(beacon_of(2, 2, AgentMode::Flying, 2, {10.0, 550.0, 0.0})), 0.3);
  EXPECT_NEAR(agent_in(watch.view(0.3, {}), 2).separation_m.value(), 450.0, 1e-9);
}

TEST(SwarmWatch, NearnessIsAnEventOnce) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  watch.take(at(tick_at(1, Phase::Flying, 1)), 0.0);
  const auto place = [&](std::uint32_t k, double y_m) {
    watch.take(at(beacon_of(1, k, AgentMode::Flying, k, {10.0, 0.0, 0.0})), 0.1 * k);
    watch.take(at(beacon_of(2, k, AgentMode::Flying, k, {10.0, y_m, 0.0})), 0.1 * k);
  };
  const auto count = [&](EventKind kind) {
    const SwarmView view = watch.view(1.0, {});
    return std::ranges::count(view.events, kind, &Event::kind);
  };
  place(1, 120.0);
  EXPECT_EQ(count(EventKind::NearMiss), 0);
  place(2, 80.0);
  place(3, 70.0);
  EXPECT_EQ(count(EventKind::NearMiss), 1);
  EXPECT_EQ(count(EventKind::Collision), 0);
  place(4, 3.0);
  EXPECT_EQ(count(EventKind::Collision), 1);
  EXPECT_NEAR(*agent_in(watch.view(1.0, {}), 1).min_separation_m, 3.0, 1e-9);
}

TEST(SwarmWatch, CopiesAndLateSamplesChangeNothing) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  fly(watch, 1, 10);
  const std::size_t events = watch.view(1.0, {}).events.size();
  fly(watch, 9, 10);
  watch.take(at(tick_at(3, Phase::Planning)), 1.0);
  const SwarmView view = watch.view(1.0, {});
  EXPECT_EQ(view.phase, Phase::Flying);
  EXPECT_EQ(view.round, 10U);
  EXPECT_EQ(view.events.size(), events);
  EXPECT_EQ(agent_in(view, 1).flown_m.size(), 10U);
}

TEST(SwarmWatch, AnotherRunStartsAnew) {
  SwarmWatch watch;
  watch.take(at(two_fly_east()), 0.0);
  fly(watch, 1, 10);
  Tick other = tick_at(1, Phase::Planning);
  other.run = kRun + 1;
  watch.take(at(other), 2.0);
  watch.take(at(beacon_of(1, 11, AgentMode::Flying, 11, {1.0, 1.0, 1.0})), 2.0);  // of the run before
  const SwarmView view = watch.view(2.0, {});
  EXPECT_EQ(view.phase, Phase::Planning);
  EXPECT_FALSE(agent_in(view, 1).heard);
  EXPECT_TRUE(agent_in(view, 1).flown_m.empty());
}

TEST(SwarmWatch, ANewcomerToAHeldIdHidesNobody) {
  SwarmWatch watch;
  fly(watch, 1, 3);
  Beacon newcomer = beacon_of(1, 3, AgentMode::Waiting);
  newcomer.incarnation = 0;
  newcomer.nonce = 99;
  watch.take(at(newcomer), 0.4);
  EXPECT_EQ(agent_in(watch.view(0.5, {}), 1).mode, AgentMode::Flying);
}

TEST(SwarmWatch, WhatIsNoSampleIsCounted) {
  SwarmWatch watch;
  wire::Tick bad = to_wire(tick_at(1, Phase::Planning), {0, kRun});
  bad.phase(99);
  watch.take(bad, 0.0);
  EXPECT_FALSE(watch.heard_tick());
  EXPECT_EQ(watch.view(0.0, {}).refused_samples, 1U);
}

TEST(SwarmWatch, TopicsHaveRatesAndEndpoints) {
  SwarmWatch watch;
  fly(watch, 1, 20);
  Endpoints endpoints{};
  endpoints[static_cast<std::size_t>(bus::TopicId::Beacon)] = {2, 3};
  const SwarmView view = watch.view(2.0, endpoints);
  const TopicView& beacons = view.topics[static_cast<std::size_t>(bus::TopicId::Beacon)];
  EXPECT_NEAR(beacons.rate.samples_per_s, 20.0, 1.5);
  EXPECT_EQ(beacons.samples, 40U);
  EXPECT_EQ(beacons.writers, 2U);
  EXPECT_EQ(beacons.readers, 3U);
  EXPECT_FALSE(view.topics[static_cast<std::size_t>(bus::TopicId::Sense)].read);
}

}  // namespace
}  // namespace skein::watch
