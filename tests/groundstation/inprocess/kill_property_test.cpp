// A kill is a change of the roster and nothing else: killed runs equal the replays of their rosters, wherever they
// fall.
#include "simworld/report/report.hpp"
#include "tests/groundstation/inprocess/tampering.hpp"

namespace skein {
namespace {

using test::paper_scenario;

InProcessResult replay_of(const Scenario& scenario, const InProcessResult& killed, bus::Tamper tamper = {}) {
  InProcessOptions options;
  options.replay = roster_changes_of(nlohmann::json::parse(killed.report.dump()));
  options.tamper = std::move(tamper);
  return run_in_process(scenario, options);
}

TEST(Kill, AtRandomMomentsEqualsItsReplay) {
  RandomStream random(51, 1, Purpose::Test, 0);
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const Scenario scenario = paper_scenario(seed, seed % 2 == 0 ? "rendezvous-2d" : "rendezvous-2d-b");
    InProcessOptions options;
    const bool planning = random.uniform() < 0.5;
    const auto at = static_cast<std::uint32_t>(planning ? 2 + random.below(49) : 1 + random.below(1300));
    const auto agent = static_cast<AgentId>(1 + random.below(3));
    options.faults = {{FaultKind::Kill, agent, planning ? Phase::Planning : Phase::Flying, at}};
    const InProcessResult killed = run_in_process(scenario, options);
    ASSERT_EQ(killed.exit_code, 4) << text_of(options.faults[0]) << killed.report.dump(2);
    ASSERT_EQ(killed.report.at("completed_without"), nlohmann::json::array({agent})) << text_of(options.faults[0]);
    const auto& change = killed.report.at("roster_changes").at(0);
    ASSERT_EQ(change.at(planning ? "round" : "step"), at);
    ASSERT_EQ(change.at("reason"), "process_ended");

    const InProcessResult replayed = replay_of(scenario, killed);
    ASSERT_EQ(replayed.report.at("state_hash"), killed.report.at("state_hash")) << text_of(options.faults[0]);
    ASSERT_EQ(replayed.report.at("roster_changes"), killed.report.at("roster_changes"));
    ASSERT_EQ(replayed.report.at("vehicles"), killed.report.at("vehicles"));
    std::uint64_t lost = 0;
    const InProcessResult rough = replay_of(scenario, killed, test::lossy(seed, {.drop = 0.1, .delay = 0.2}, lost));
    ASSERT_EQ(rough.report.at("state_hash"), killed.report.at("state_hash")) << text_of(options.faults[0]);
  }
}

TEST(Kill, OfAllAgentsEndsTheRun) {
  InProcessOptions options;
  options.faults = {{FaultKind::Kill, 1, Phase::Planning, 5},
                    {FaultKind::Kill, 2, Phase::Planning, 5},
                    {FaultKind::Kill, 3, Phase::Planning, 20}};
  const Scenario scenario = paper_scenario(1);
  const InProcessResult killed = run_in_process(scenario, options);
  EXPECT_EQ(killed.exit_code, 4);
  EXPECT_TRUE(killed.report.at("completed_without").empty());
  EXPECT_EQ(killed.report.at("roster_changes").size(), 3U);
  EXPECT_EQ(replay_of(scenario, killed).report.at("state_hash"), killed.report.at("state_hash"));
}

TEST(Kill, ContinuesWithoutItsAgentWhenTheScenarioSaysSo) {
  Scenario scenario = paper_scenario(2);
  scenario.world.on_agent_loss = OnAgentLoss::Continue;
  InProcessOptions options;
  options.faults = {{FaultKind::Kill, 2, Phase::Flying, 100}};
  const InProcessResult killed = run_in_process(scenario, options);
  EXPECT_EQ(killed.report.at("vehicles").at(1).at("status"), "adrift");
  EXPECT_EQ(replay_of(scenario, killed).report.at("state_hash"), killed.report.at("state_hash"));
}

TEST(Kill, FailFastEndsAtOnce) {
  InProcessOptions options;
  options.faults = {{FaultKind::Kill, 2, Phase::Flying, 100}};
  options.fail_fast = true;
  const InProcessResult killed = run_in_process(paper_scenario(2), options);
  EXPECT_EQ(killed.exit_code, 4);
  EXPECT_EQ(killed.report.at("steps"), 98);  // the tick after step 99's round ends the run, step 99 is not flown
}

}  // namespace
}  // namespace skein
