// Deaths, silences and returns are changes of the roster and nothing else: whatever the faults, the run ends, and the
// replay of its roster changes gives the same state hash.

#include <fmt/core.h>

#include <algorithm>

#include "simworld/report/report.hpp"
#include "tests/groundstation/fault_scripts.hpp"
#include "tests/groundstation/inprocess/tampering.hpp"
#include "tests/groundstation/ring.hpp"

namespace skein {
namespace {

Scenario ring(std::uint64_t seed, const std::string& on_agent_loss) {
  ScenarioResult result = parse_scenario(test::ring_yaml(6, on_agent_loss), "ring.yaml", {}, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

std::string text_of(const std::vector<Fault>& script) {
  std::string text;
  for (const Fault& fault : script) text += fmt::format(" {}", skein::text_of(fault));
  return text;
}

InProcessResult replay_of(const Scenario& scenario, const InProcessResult& run, bus::Tamper tamper = {}) {
  InProcessOptions options;
  options.replay = roster_changes_of(nlohmann::json::parse(run.report.dump()));
  options.tamper = std::move(tamper);
  return run_in_process(scenario, options);
}

InProcessResult run_script(const Scenario& scenario, std::vector<Fault> script) {
  InProcessOptions options;
  options.faults = std::move(script);
  return run_in_process(scenario, options);
}

std::size_t returns_of(const nlohmann::json& report) {
  const auto& changes = report.at("roster_changes");
  return static_cast<std::size_t>(
      std::count_if(changes.begin(), changes.end(), [](const auto& c) { return c.at("reason") == "rejoined"; }));
}

TEST(Faults, RandomScriptsEndAndEqualTheirReplays) {
  constexpr const char* kOnLoss[] = {"remove", "hover", "continue"};
  std::size_t losses = 0;
  std::size_t returns = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Scenario scenario = ring(seed, kOnLoss[seed % 3]);
    const std::vector<Fault> script = test::random_script(seed, 6, 35, 300);
    const InProcessResult run = run_script(scenario, script);
    const std::string what = text_of(script) + "\n" + run.report.dump(2);
    const bool any_lost = !run.report.at("roster_changes").empty();
    const bool unsafe = run.report.at("collisions") > 0;
    ASSERT_TRUE(!any_lost || run.exit_code == (unsafe ? 1 : 4)) << what;
    const bool unused = run.report.at("reason").get<std::string>().find("never took place") != std::string::npos;
    ASSERT_TRUE(any_lost || run.exit_code == (unused ? 1 : 0)) << what;
    ASSERT_EQ(run.report.at("unaccepted_plans"), 0) << what;
    const InProcessResult replayed = replay_of(scenario, run);
    ASSERT_EQ(replayed.report.at("state_hash"), run.report.at("state_hash")) << what << replayed.report.dump(2);
    ASSERT_EQ(replayed.report.at("roster_changes"), run.report.at("roster_changes")) << what;
    ASSERT_EQ(replayed.report.at("vehicles"), run.report.at("vehicles")) << what;
    ASSERT_TRUE(!any_lost || replayed.exit_code == run.exit_code) << what;
    returns += returns_of(run.report);
    losses += run.report.at("roster_changes").size() - returns_of(run.report);
  }
  EXPECT_GT(losses, 150U);
  EXPECT_GT(returns, 75U);
}

TEST(Faults, ABadBusChangesNothingOfAReplay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Scenario scenario = ring(seed, "remove");
    const InProcessResult run = run_script(scenario, test::random_script(seed, 6, 35, 300));
    scenario.lockstep.deadline_s = 1000.0;  // nobody is to be dropped by bad luck
    std::uint64_t lost = 0;
    const InProcessResult rough = replay_of(scenario, run, test::lossy(seed, {.drop = 0.1, .delay = 0.2}, lost));
    ASSERT_EQ(rough.report.at("state_hash"), run.report.at("state_hash")) << run.report.dump(2);
    ASSERT_GT(lost, 0U);
  }
}

TEST(Faults, TheSameScriptGivesTheSameRun) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scenario scenario = ring(seed, "continue");
    const std::vector<Fault> script = test::random_script(seed, 6, 35, 300);
    EXPECT_EQ(run_script(scenario, script).report.at("state_hash"),
              run_script(scenario, script).report.at("state_hash"));
  }
}

TEST(Faults, ARestartedAgentFliesNothingUnlessItsVehicleContinues) {
  const std::vector<Fault> script{{FaultKind::Restart, 2, Phase::Flying, 50}};
  for (const auto& [on_loss, status] :
       {std::pair{"remove", "removed"}, std::pair{"hover", "hovering"}, std::pair{"continue", "rejoined"}}) {
    const InProcessResult run = run_script(ring(1, on_loss), script);
    EXPECT_EQ(run.report.at("vehicles").at(1).at("status"), status);
    EXPECT_EQ(run.report.at("vehicles").at(1).at("reason"), "agent lost: process_ended, rejoined");
    ASSERT_EQ(run.report.at("roster_changes").size(), 2U);
    EXPECT_EQ(run.report.at("roster_changes").at(1).at("incarnation"), 2);
    EXPECT_EQ(run.report.at("roster_changes").at(1).at("step"), 50);
  }
}

TEST(Faults, FaultsOnOneAgentAtOneMoment) {
  for (const std::vector<FaultKind>& kinds :
       {std::vector{FaultKind::Kill, FaultKind::Restart}, std::vector{FaultKind::Restart, FaultKind::Kill},
        std::vector{FaultKind::Stop, FaultKind::Restart}, std::vector{FaultKind::Stop, FaultKind::Kill},
        std::vector{FaultKind::Restart, FaultKind::Restart}}) {
    const Scenario scenario = ring(3, "remove");
    std::vector<Fault> script;
    script.reserve(kinds.size());
    for (const FaultKind kind : kinds) script.push_back({kind, 4, Phase::Planning, 9});
    const InProcessResult run = run_script(scenario, script);
    EXPECT_EQ(run.report.at("reason").get<std::string>().find("never took place"), std::string::npos)
        << run.report.dump(2);
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(run.report.at("roster_changes").size(), kinds.back() == FaultKind::Kill ? 1U : 2U);
    EXPECT_EQ(replay_of(scenario, run).report.at("state_hash"), run.report.at("state_hash"));
  }
}

TEST(Faults, AStopAndAContAtOneMomentChangeNothing) {
  const Scenario scenario = ring(3, "remove");
  const InProcessResult run =
      run_script(scenario, {{FaultKind::Stop, 4, Phase::Flying, 9}, {FaultKind::Cont, 4, Phase::Flying, 9}});
  EXPECT_TRUE(run.report.at("roster_changes").empty());
  EXPECT_EQ(run.report.at("state_hash"), run_in_process(scenario, {}).report.at("state_hash"));
}

}  // namespace
}  // namespace skein
