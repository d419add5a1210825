// Whole runs over the in-memory bus: what they report, and that nothing in transit but content changes them.
#include "groundstation/inprocess/in_process.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/core/random/random_stream.hpp"
#include "simworld/report/report.hpp"

namespace skein {
namespace {

Scenario scenario_of(const std::string& name, std::uint64_t seed, const std::vector<Override>& changes = {}) {
  const std::string path = std::string(SKEIN_SOURCE_DIR) + "/deploy/scenarios/" + name + ".yaml";
  ScenarioResult result = load_scenario(path, changes, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

TEST(InProcess, ThreeVehiclesArriveInFormation) {
  const InProcessResult result = run_in_process(scenario_of("rendezvous-2d", 1), {});
  EXPECT_EQ(result.exit_code, 0) << result.report.dump(2);
  EXPECT_TRUE(result.report.at("success"));
  EXPECT_EQ(result.report.at("collisions"), 0);
  const auto& vehicles = result.report.at("vehicles");
  ASSERT_EQ(vehicles.size(), 3U);
  for (const auto& vehicle : vehicles) {
    EXPECT_NEAR(vehicle.at("planned_length_m").get<double>(), vehicles[0].at("planned_length_m").get<double>(), 1e-3);
    EXPECT_LT(vehicle.at("planned_length_m"), 35100.0);
    EXPECT_EQ(vehicle.at("arrival_step"), vehicles[0].at("arrival_step"));
    EXPECT_LT(vehicle.at("max_curvature_per_m"), 0.002);
    EXPECT_EQ(vehicle.at("status"), "arrived");
  }
}

TEST(InProcess, ThreeVehiclesArriveInFormationInSpace) {
  const InProcessResult result = run_in_process(scenario_of("rendezvous-3d", 1), {});
  EXPECT_EQ(result.exit_code, 0) << result.report.dump(2);
  EXPECT_EQ(result.report.at("collisions"), 0);
  EXPECT_GT(result.report.at("min_clearance_m").get<double>(), 0.0);
  for (const auto& vehicle : result.report.at("vehicles")) {
    EXPECT_NEAR(vehicle.at("planned_length_m").get<double>(), 35047.4, 1.0);
    EXPECT_LT(vehicle.at("max_curvature_per_m"), 0.002);
    EXPECT_GT(vehicle.at("max_torsion_per_m"), 0.0);
    EXPECT_LT(vehicle.at("max_torsion_per_m"), 0.002);
    EXPECT_EQ(vehicle.at("status"), "arrived");
  }
}

TEST(InProcess, JoinedSegmentsAreFlownThroughClutter) {
  const InProcessResult result = run_in_process(scenario_of("rendezvous-clutter", 3), {});
  EXPECT_EQ(result.exit_code, 0) << result.report.dump(2);
  const auto& vehicles = result.report.at("vehicles");
  ASSERT_EQ(vehicles.size(), 3U);
  EXPECT_GE(vehicles[0].at("particle").size(), 4U);
  EXPECT_GE(vehicles[2].at("particle").size(), 4U);
  EXPECT_GT(result.report.at("min_clearance_m").get<double>(), 0.0);
  for (const auto& vehicle : vehicles) {
    EXPECT_EQ(vehicle.at("arrival_step"), vehicles[0].at("arrival_step"));
    EXPECT_LT(vehicle.at("max_curvature_per_m"), 0.002);
    EXPECT_EQ(vehicle.at("status"), "arrived");
  }
}

TEST(InProcess, SameSeedSameHashOtherSeedOtherHash) {
  const auto first = run_in_process(scenario_of("rendezvous-2d", 7), {});
  const auto again = run_in_process(scenario_of("rendezvous-2d", 7), {});
  const auto other = run_in_process(scenario_of("rendezvous-2d", 8), {});
  EXPECT_EQ(first.report.at("state_hash"), again.report.at("state_hash"));
  EXPECT_NE(first.report.at("state_hash"), other.report.at("state_hash"));
}

TEST(InProcess, MultirotorsArriveTogetherAndHover) {
  const std::vector<Override> hovering{
      {"vehicles.type", "multirotor"}, {"vehicles.speed_mps", "20"}, {"vehicles.max_acceleration_mps2", "4"}};
  for (const char* name : {"rendezvous-2d", "rendezvous-3d"}) {
    const InProcessResult result = run_in_process(scenario_of(name, 1, hovering), {});
    EXPECT_EQ(result.exit_code, 0) << result.report.dump(2);
    for (const auto& vehicle : result.report.at("vehicles")) {
      EXPECT_EQ(vehicle.at("arrival_step"), result.report.at("vehicles")[0].at("arrival_step"));
      EXPECT_NEAR(vehicle.at("path_length_m").get<double>(), vehicle.at("planned_length_m").get<double>(), 2.0);
    }
  }
}

TEST(InProcess, KilledAgentsRunEqualsItsReplay) {
  for (const Fault& fault :
       {Fault{FaultKind::Kill, 2, Phase::Planning, 25}, Fault{FaultKind::Kill, 2, Phase::Flying, 100}}) {
    const Scenario scenario = scenario_of("rendezvous-2d", 3);
    InProcessOptions options;
    options.faults = {fault};
    const auto killed = run_in_process(scenario, options);
    EXPECT_EQ(killed.exit_code, 4) << killed.report.dump(2);
    EXPECT_EQ(killed.report.at("completed_without"), nlohmann::json::array({2}));
    ASSERT_EQ(killed.report.at("roster_changes").size(), 1U);
    EXPECT_EQ(killed.report.at("roster_changes")[0].at("agent"), 2);
    EXPECT_EQ(killed.report.at("roster_changes")[0].at(fault.phase == Phase::Planning ? "round" : "step"), fault.at);

    InProcessOptions replay;
    replay.replay = roster_changes_of(nlohmann::json::parse(killed.report.dump()));
    const auto replayed = run_in_process(scenario, replay);
    EXPECT_EQ(replayed.report.at("state_hash"), killed.report.at("state_hash"));
    EXPECT_EQ(replayed.exit_code, 4);
    EXPECT_NE(killed.report.at("state_hash"), run_in_process(scenario, {}).report.at("state_hash"));
  }
}

}  // namespace
}  // namespace skein
