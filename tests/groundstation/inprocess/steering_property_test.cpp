// Commands are part of a run: whatever they are and whenever they come, the run ends, and the replay of what its report
// says of them gives the same state hash.
#include <gtest/gtest.h>

#include <algorithm>

#include "groundstation/inprocess/in_process.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/report/report.hpp"
#include "simworld/report/steering_report.hpp"
#include "tests/groundstation/crossings.hpp"
#include "tests/groundstation/ring.hpp"

namespace skein {
namespace {

constexpr std::uint32_t kFirst = 60;  ///< a round in which the ring is in flight

Scenario ring(std::uint64_t seed) {
  ScenarioResult result = parse_scenario(test::ring_yaml(6), "ring.yaml", {}, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

InProcessResult run_with(const Scenario& scenario, std::vector<OrderedAt> orders,
                         std::vector<InjectedAt> injections = {}) {
  InProcessOptions options;
  options.orders = std::move(orders);
  options.injections = std::move(injections);
  return run_in_process(scenario, options);
}

InProcessResult replay_of(const Scenario& scenario, const InProcessResult& run) {
  const auto report = nlohmann::json::parse(run.report.dump());
  return run_with(scenario, orders_of(report), injections_of(report));
}

OrderedAt at(std::uint32_t round, OrderKind kind, AgentId agent = kAllAgents) {
  return {round, {1000U + round, agent, kind, Vec3::Zero(), 0.0}};
}

TEST(Steering, AStartChangesNothing) {
  const Scenario scenario = ring(1);
  EXPECT_EQ(run_with(scenario, {at(1, OrderKind::Start)}).report.at("state_hash"),
            run_in_process(scenario, {}).report.at("state_hash"));
}

TEST(Steering, AHeldRingArrivesTogetherLater) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Scenario scenario = ring(seed);
    const InProcessResult plain = run_in_process(scenario, {});
    const std::uint32_t hold = plain.report.at("rounds").get<std::uint32_t>() + 50;
    const InProcessResult held = run_with(scenario, {at(hold, OrderKind::Hold), at(hold + 30, OrderKind::Resume)});
    ASSERT_EQ(plain.exit_code, 0) << plain.report.dump(2);
    EXPECT_EQ(held.exit_code, 0) << held.report.dump(2);
    EXPECT_EQ(held.report.at("collisions"), 0);
    EXPECT_GT(held.report.at("steps"), plain.report.at("steps"));
    EXPECT_EQ(held.report.at("commands").size(), 2U);
    for (const auto& command : held.report.at("commands")) EXPECT_EQ(command.at("acknowledged").size(), 6U);
    EXPECT_EQ(replay_of(scenario, held).report.at("state_hash"), held.report.at("state_hash"));
  }
}

/// A handful of orders of all kinds but abort, at rounds of the first part of the flight; all resume at last.
std::vector<OrderedAt> random_orders(std::uint64_t seed, std::uint32_t first, const Scenario& scenario) {
  constexpr OrderKind kKinds[] = {OrderKind::Hold, OrderKind::Resume, OrderKind::Land, OrderKind::Goto};
  RandomStream stream(seed, 0, Purpose::Mover, 7);
  const auto& vehicles = scenario.mission.vehicles;
  std::vector<OrderedAt> orders;
  std::uint32_t round = first;
  for (std::uint32_t i = 0; i < 6; ++i) {
    round += 1 + static_cast<std::uint32_t>(stream.below(20));
    Order order;
    order.id = 1 + i;
    order.kind = kKinds[stream.below(4)];
    order.agent = vehicles[stream.below(vehicles.size())].id;
    if (order.kind != OrderKind::Goto && order.kind != OrderKind::Land && stream.below(2) == 0) order.agent = 0;
    if (order.kind == OrderKind::Goto) {
      order.to_m = vehicle_of(scenario.mission, order.agent).start.position_m + Vec3(stream.uniform(-50.0, 50.0), 0, 0);
    }
    orders.push_back({round, order});
  }
  orders.push_back(at(round + 40, OrderKind::Resume));
  return orders;
}

TEST(Steering, RandomOrdersEndAndEqualTheirReplays) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scenario scenario = seed % 2 == 0 ? ring(seed) : test::transit_scenario("swarm-crossing", seed);
    scenario.world.max_steps = 1500;
    const std::uint32_t first = seed % 2 == 0 ? kFirst : 20;
    const InProcessResult run = run_with(scenario, random_orders(seed, first, scenario));
    const InProcessResult again = replay_of(scenario, run);
    ASSERT_EQ(again.report.at("state_hash"), run.report.at("state_hash")) << run.report.dump(2);
    ASSERT_EQ(again.report.at("commands"), run.report.at("commands"));
  }
}

TEST(Steering, ACrossingThatIsHeldAndResumedStaysClean) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scenario scenario = test::transit_scenario("swarm-crossing", seed);
    const InProcessResult plain = run_in_process(scenario, {});
    const InProcessResult held = run_with(scenario, {at(60, OrderKind::Hold), at(90, OrderKind::Resume),
                                                     at(110, OrderKind::Hold, 2), at(150, OrderKind::Resume, 2)});
    if (plain.report.at("collisions") == 0) {
      EXPECT_EQ(held.report.at("collisions"), 0) << held.report.dump(2);
    }
    EXPECT_GT(held.report.at("steps"), plain.report.at("steps"));
  }
}

TEST(Steering, AnInjectedObstacleIsSeenAndReplayed) {
  const Scenario scenario = test::transit_scenario("swarm-crossing", 1);
  Injection obstacle;
  obstacle.id = 9;
  obstacle.position_m = Vec3(0.0, 0.0, scenario.mission.vehicles.front().start.position_m.z());
  obstacle.radius_m = 1.0;
  const InProcessResult run = run_with(scenario, {}, {{30, obstacle}});
  ASSERT_EQ(run.report.at("injections").size(), 1U);
  EXPECT_NE(run.report.at("state_hash"), run_in_process(scenario, {}).report.at("state_hash"));
  EXPECT_EQ(replay_of(scenario, run).report.at("state_hash"), run.report.at("state_hash"));
}

TEST(Steering, ATimeOutSaysWhoFliesByCommand) {
  Scenario scenario = test::transit_scenario("swarm-crossing", 1);
  scenario.world.max_steps = 100;
  const InProcessResult run = run_with(scenario, {at(50, OrderKind::Hold)});
  EXPECT_EQ(run.exit_code, 1);
  const auto reason = run.report.at("reason").get<std::string>();
  EXPECT_NE(reason.find("agent 1 flies by command"), std::string::npos) << reason;
  EXPECT_GT(run.report.at("steps"), 100);
}

TEST(Steering, OrdersThatNeverCameAreNamed) {
  const InProcessResult run = run_with(ring(1), {at(1'000'000, OrderKind::Hold)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.report.at("reason").get<std::string>().find("never took place"), std::string::npos);
}

}  // namespace
}  // namespace skein
