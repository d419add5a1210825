// Commands in transits by cells: whatever they are and whenever they come, nobody touches anything, everybody who was
// not landed arrives once all may go on, and the replay of the report gives the same state hash.
#include <gtest/gtest.h>

#include <set>

#include "groundstation/inprocess/in_process.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/report/report.hpp"
#include "simworld/report/steering_report.hpp"
#include "tests/groundstation/crossings.hpp"
#include "tests/simworld/checkpoint/scratch.hpp"

namespace skein {
namespace {

using test::count_status;
using test::transit_scenario;

InProcessResult run_with(const Scenario& scenario, std::vector<OrderedAt> orders) {
  InProcessOptions options;
  options.orders = std::move(orders);
  return run_in_process(scenario, options);
}

void expect_replayed(const Scenario& scenario, const InProcessResult& run) {
  const InProcessResult again = run_with(scenario, orders_of(nlohmann::json::parse(run.report.dump())));
  EXPECT_EQ(again.report.at("state_hash"), run.report.at("state_hash"));
  EXPECT_EQ(again.report.at("commands"), run.report.at("commands"));
}

OrderedAt at(std::uint32_t round, OrderKind kind, AgentId agent = kAllAgents, const Vec3& to_m = Vec3::Zero()) {
  return {round, {1000U + round, agent, kind, to_m, 0.0}};
}

/// A dozen orders of all kinds but abort, within the first rounds of flight; at last all resume.
std::vector<OrderedAt> random_orders(std::uint64_t seed, const Scenario& scenario) {
  constexpr OrderKind kKinds[] = {OrderKind::Hold, OrderKind::Resume, OrderKind::Goto, OrderKind::Land};
  RandomStream stream(seed, 0, Purpose::Mover, 9);
  const auto& vehicles = scenario.mission.vehicles;
  const Box& area = scenario.mission.transit->area;
  std::vector<OrderedAt> orders;
  std::uint32_t round = 2;
  for (std::uint32_t i = 0; i < 12; ++i) {
    round += 1 + static_cast<std::uint32_t>(stream.below(6));
    const OrderKind kind = kKinds[stream.below(i % 4 == 0 ? 4 : 3)];
    AgentId agent = vehicles[stream.below(vehicles.size())].id;
    if ((kind == OrderKind::Hold || kind == OrderKind::Resume) && stream.below(3) == 0) agent = kAllAgents;
    Vec3 to_m = area.min_m;
    for (int axis = 0; axis < 3; ++axis) to_m[axis] = stream.uniform(area.min_m[axis], area.max_m[axis]);
    OrderedAt order = at(round, kind, agent, to_m);
    if (stream.below(2) == 0) order.order.speed_mps = 4.0;
    orders.push_back(order);
  }
  orders.push_back(at(round + 40, OrderKind::Resume));
  return orders;
}

struct Setting {
  const char* scenario;
  std::vector<Override> changes;
  std::uint64_t seeds = 12;
};

class RandomTransitOrders : public testing::TestWithParam<Setting> {};

TEST_P(RandomTransitOrders, TouchNobodyAndAllArriveAfterwards) {
  for (std::uint64_t seed = 1; seed <= GetParam().seeds; ++seed) {
    const Scenario scenario = transit_scenario(GetParam().scenario, seed, GetParam().changes);
    const InProcessResult run = run_with(scenario, random_orders(seed, scenario));
    SCOPED_TRACE("seed " + std::to_string(seed));
    EXPECT_EQ(run.report.at("collisions"), 0);
    EXPECT_EQ(count_status(run.report, "arrived") + count_status(run.report, "landed"),
              scenario.mission.vehicles.size())
        << run.report.at("reason");
    expect_replayed(scenario, run);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, RandomTransitOrders,
                         testing::Values(Setting{"transit-partition", {}},
                                         Setting{"transit-partition", {{"radio.loss", "0.2"}, {"step_s", "0.5"}}},
                                         Setting{"transit-power-station", {{"vehicles.agents", "4"}}},
                                         Setting{"transit-forest", {{"forest.density_per_m2", "0.004"}}},
                                         Setting{"transit-power-station-3d", {{"radio.loss", "0.1"}}, 4}));

TEST(TransitSteering, NobodyGivesUpBecauseOneIsHeld) {
  Scenario scenario = transit_scenario("transit-partition", 1);
  scenario.world.max_steps = 300;
  const InProcessResult run = run_with(scenario, {at(8, OrderKind::Hold, 2)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.report.at("collisions"), 0);
  EXPECT_EQ(run.report.at("steps"), 600);
  const auto reason = run.report.at("reason").get<std::string>();
  EXPECT_NE(reason.find("agent 2 flies by command"), std::string::npos) << reason;
  EXPECT_EQ(count_status(run.report, "unreachable") + count_status(run.report, "deadlock"), 0U);
  EXPECT_EQ(count_status(run.report, "arrived"), 5U) << run.report.at("vehicles").dump(1);
  expect_replayed(scenario, run);
}

TEST(TransitSteering, WhoLandsIsOutOfTheWay) {
  const Scenario scenario = transit_scenario("transit-partition", 1);
  const InProcessResult run = run_with(scenario, {at(8, OrderKind::Land, 2), at(8, OrderKind::Land, 5)});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(count_status(run.report, "landed"), 2U);
  EXPECT_EQ(count_status(run.report, "arrived"), 4U);
  EXPECT_EQ(run.report.at("collisions"), 0);
  expect_replayed(scenario, run);
}

TEST(TransitSteering, TheDeathOfTheWorldForgetsNoOrder) {
  const Scenario scenario = transit_scenario("transit-partition", 4);
  InProcessOptions options;
  options.orders = random_orders(4, scenario);
  const InProcessResult whole = run_in_process(scenario, options);
  const test::Scratch folder;
  options.checkpoint = folder.path();
  std::set<std::uint32_t> steps;  // before, with and after each order; round k + 1 is step k
  for (const OrderedAt& order : options.orders) steps.insert({order.round - 2, order.round - 1, order.round});
  const auto last = whole.report.at("steps").get<std::uint32_t>();
  std::erase_if(steps, [&](std::uint32_t step) { return step == 0 || step >= last; });
  for (const std::uint32_t step : steps) options.faults.push_back({FaultKind::Kill, kWorldId, Phase::Flying, step});
  const InProcessResult disturbed = run_in_process(scenario, options);
  EXPECT_EQ(disturbed.report.at("state_hash"), whole.report.at("state_hash"));
  EXPECT_EQ(disturbed.report.at("commands"), whole.report.at("commands"));
  EXPECT_EQ(disturbed.report.at("world_restarts"), steps.size());
}

TEST(TransitSteering, AStartChangesNothing) {
  const Scenario scenario = transit_scenario("transit-partition", 1);
  EXPECT_EQ(run_with(scenario, {at(1, OrderKind::Start)}).report.at("state_hash"),
            run_in_process(scenario, {}).report.at("state_hash"));
}

}  // namespace
}  // namespace skein
