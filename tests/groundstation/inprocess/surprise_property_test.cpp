// What nobody planned for, on whole swarms: nothing is touched, all arrive, in a rendezvous in the same step, and
// nobody is where an announced aircraft may be. SKEIN_SEEDS sets how many seeds each campaign flies (default: a tenth).
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "groundstation/inprocess/in_process.hpp"
#include "tests/groundstation/crossings.hpp"

namespace skein {
namespace {

using test::count_status;
using test::transit_scenario;
using Json = nlohmann::ordered_json;

std::uint64_t seeds_or(std::uint64_t few) {
  const char* set = std::getenv("SKEIN_SEEDS");
  return set == nullptr ? few : std::strtoull(set, nullptr, 10);
}

Json fly(const std::string& name, std::uint64_t seed, const std::vector<Override>& changes = {}) {
  return run_in_process(transit_scenario(name, seed, changes), {}).report;
}

/// Nobody touched anything, at rest or not.
void expect_untouched(const Json& report, std::uint64_t seed) {
  ASSERT_EQ(report.at("collisions"), 0) << seed << ": " << report.at("reason");
  ASSERT_EQ(report.at("rammed_at_rest"), 0) << seed << ": " << report.at("reason");
  ASSERT_EQ(report.at("unaccepted_plans"), 0) << seed << ": " << report.at("first_unaccepted_plan");
}

std::set<std::uint32_t> arrival_steps(const Json& report) {
  std::set<std::uint32_t> steps;
  for (const auto& vehicle : report.at("vehicles")) {
    if (vehicle.at("status") == "arrived") steps.insert(vehicle.at("arrival_step").get<std::uint32_t>());
  }
  return steps;
}

std::size_t count_replans(const Json& report, const std::string& reason) {
  std::size_t count = 0;
  for (const auto& replan : report.at("replans")) {
    count += replan.at("reason") == reason && replan.at("outcome") == "switched" ? 1 : 0;
  }
  return count;
}

TEST(Surprises, ARendezvousPlansAnewAndArrivesInTheSameStep) {
  const std::uint64_t seeds = seeds_or(100);
  std::size_t together = 0;
  std::size_t replanned = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Json report = fly("rendezvous-surprise", seed);
    expect_untouched(report, seed);
    ASSERT_FALSE(report.at("reason").get<std::string>().empty());
    together += report.at("exit_code") == 0 && arrival_steps(report).size() == 1 ? 1 : 0;
    replanned += count_replans(report, "blocked") > 0 ? 1 : 0;
  }
  EXPECT_GE(together, seeds - seeds / 100);
  EXPECT_GT(replanned, seeds * 9 / 10) << "the surprise must matter";
}

TEST(Surprises, WhatIsLargeIsPassedTogetherOnlyByANewPlan) {
  std::size_t together = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const char* replan : {"0", "1"}) {
      const Json report = fly("rendezvous-surprise", seed,
                              {{"planner.replan", replan},
                               {"sudden_obstacles.1.radius_m", "600"},
                               {"sudden_obstacles.1.ahead.distance_m", "720"}});
      expect_untouched(report, seed);
      const bool all = report.at("exit_code") == 0;
      if (*replan == '1') {
        EXPECT_TRUE(all) << seed << ": " << report.at("reason");
      } else {
        together += all ? 1 : 0;
      }
    }
  }
  EXPECT_LT(together, 5U) << "the controller slides by, but late";
}

TEST(Surprises, ASwarmWithASlowVehicleArrivesTogether) {
  for (std::uint64_t seed = 0; seed < seeds_or(10); ++seed) {
    const Json report = fly("rendezvous-slow", seed);
    EXPECT_EQ(report.at("exit_code"), 0) << seed << ": " << report.at("reason");
    EXPECT_EQ(arrival_steps(report).size(), 1U) << seed;
    EXPECT_GE(count_replans(report, "deviation"), 1U) << seed;
    bool noticed = false;
    for (const auto& event : report.at("events")) {
      noticed = noticed || (event.at("agent") == 2 && event.at("reason") == "deviation");
    }
    EXPECT_TRUE(noticed) << "by the monitor of the slow one, seed " << seed;
  }
}

TEST(Surprises, InScenesInsideTheGuaranteeNothingIsTouchedInMotion) {
  const std::uint64_t seeds = seeds_or(100);
  std::size_t rammed = 0;
  std::size_t arrived = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Json report = fly("random-scenes", seed);
    ASSERT_EQ(report.at("collisions"), 0) << seed << ": " << report.at("reason");
    rammed += report.at("rammed_at_rest") > 0 ? 1 : 0;
    arrived += count_status(report, "arrived");
  }
  EXPECT_LE(rammed, seeds / 100);
  EXPECT_GE(arrived, 4 * seeds - 4 * rammed);
}

class Crossing : public testing::TestWithParam<const char*> {};

TEST_P(Crossing, AllSwapPlaces) {
  for (std::uint64_t seed = 0; seed < seeds_or(10); ++seed) {
    const Json report = fly("swarm-crossing", seed, {{std::string(kAgentsFlag), GetParam()}});
    expect_untouched(report, seed);
    EXPECT_EQ(report.at("exit_code"), 0) << seed << ": " << report.at("reason");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Crossing, testing::Values("4", "8", "16", "32", "64"),
                         [](const auto& agents) { return std::string(agents.param); });

TEST(Surprises, NobodyIsInAZoneThatIsOccupiedOrNotConfirmed) {
  std::size_t waited = 0;
  for (std::uint64_t seed = 0; seed < seeds_or(10); ++seed) {
    const Json report = fly("airport", seed);
    expect_untouched(report, seed);
    EXPECT_EQ(report.at("zone_entries"), 0) << seed;
    EXPECT_EQ(report.at("exit_code"), 0) << seed << ": " << report.at("reason");
    for (const auto& event : report.at("events")) waited += event.at("reason") == "unconfirmed" ? 1 : 0;
  }
  EXPECT_GT(waited, 0U) << "the announcements must matter";
}

TEST(Surprises, AnAgentThatCameBackTakesPartInTheNextPlan) {
  const Scenario scenario = transit_scenario("rendezvous-surprise", 4);
  InProcessOptions options;
  options.replay = {{300, 355, 2, 1, LossReason::ProcessEnded}, {300, 355, 2, 2, LossReason::Rejoined}};
  const Json report = run_in_process(scenario, options).report;
  EXPECT_EQ(count_status(report, "arrived"), 3U) << report.at("reason");
  EXPECT_EQ(arrival_steps(report).size(), 1U);
  EXPECT_GE(count_replans(report, "no_plan"), 1U);
}

TEST(Surprises, WhoComesBackInTheStepOfTheSwitchKeepsAllFromSwitching) {
  const Scenario scenario = transit_scenario("rendezvous-surprise", 4, {{"vehicles.on_agent_loss", "continue"}});
  InProcessOptions once;
  once.replay = {{300, 355, 2, 1, LossReason::ProcessEnded}, {300, 355, 2, 2, LossReason::Rejoined}};
  const Json first = run_in_process(scenario, once).report;
  const auto& plan = first.at("replans").at(0);
  ASSERT_EQ(plan.at("outcome"), "switched");
  const std::uint32_t step = plan.at("switch_step");
  const std::uint32_t per_step = 20;
  const auto round_of = [&](std::uint32_t k) {  // of the flight round of a step while the swarm plans
    return plan.at("round").get<std::uint32_t>() + (k - plan.at("step").get<std::uint32_t>()) * per_step;
  };
  InProcessOptions late = once;
  late.replay.push_back({step - 1, round_of(step - 1), 1, 1, LossReason::ProcessEnded});
  late.replay.push_back({step, round_of(step), 1, 2, LossReason::Rejoined});
  const Json second = run_in_process(scenario, late).report;
  ASSERT_EQ(second.at("roster_changes").size(), 4U) << "both moments came";
  for (const auto& event : second.at("events")) {
    if (event.at("step") != step) continue;
    EXPECT_NE(event.at("mode"), "autonomous") << event.dump();
  }
  expect_untouched(second, 4);
}

TEST(Surprises, OnAStraightTransitWhoComesBackFliesOn) {
  const Scenario scenario =
      transit_scenario("swarm-crossing", 3, {{std::string(kAgentsFlag), "4"}, {"vehicles.on_agent_loss", "continue"}});
  InProcessOptions options;
  options.replay = {{30, 31, 1, 1, LossReason::ProcessEnded}, {33, 34, 1, 2, LossReason::Rejoined}};
  const Json report = run_in_process(scenario, options).report;
  EXPECT_EQ(count_status(report, "arrived"), 4U) << report.at("reason");
  EXPECT_EQ(report.at("exit_code"), 4);
  EXPECT_TRUE(report.at("completed_without").empty()) << "all arrived, the lost one too";
}

TEST(Surprises, SeveralCloseInOnOneGoal) {
  for (const char* agents : {"2", "3", "4", "6"}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Json report = fly("random-scenes", seed,
                              {{"vehicles.agents", agents}, {"draw.own_goals", "0"}, {"random_obstacles.count", "0"}});
      EXPECT_EQ(report.at("exit_code"), 0) << agents << ": " << report.at("reason");
      EXPECT_EQ(report.at("collisions"), 0);
    }
  }
}

}  // namespace
}  // namespace skein
