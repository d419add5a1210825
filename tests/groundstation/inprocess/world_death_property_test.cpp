// The death of the world changes nothing: killed at any tick, as often as there are ticks, and with agents that die and
// come back around it, a run comes to the state hash and the figures of the undisturbed one.
#include "simworld/report/report.hpp"
#include "tests/groundstation/crossings.hpp"
#include "tests/groundstation/inprocess/tampering.hpp"
#include "tests/simworld/checkpoint/scratch.hpp"

namespace skein {
namespace {

using test::paper_scenario;

Fault death(Phase phase, std::uint32_t at) {
  return {FaultKind::Kill, kWorldId, phase, at};
}

InProcessResult run_with_faults(const Scenario& scenario, const std::vector<Fault>& faults, bus::Tamper tamper = {}) {
  const test::Scratch folder;
  InProcessOptions options;
  options.faults = faults;
  options.checkpoint = folder.path();
  options.tamper = std::move(tamper);
  return run_in_process(scenario, options);
}

/// A report without what depends on wall time, and on how often a tick was repeated.
nlohmann::ordered_json figures_of(const InProcessResult& result) {
  nlohmann::ordered_json figures = result.report;
  for (const char* key :
       {"discovery_s", "plan_s", "rounds_per_s", "steps_per_s", "realtime_factor", "world_restarts"}) {
    figures.erase(key);
  }
  for (const char* topic : {"mission", "tick", "sense"}) figures.at("topics").erase(topic);
  return figures;
}

void expect_equal(const InProcessResult& disturbed, const InProcessResult& whole, std::size_t deaths) {
  EXPECT_EQ(figures_of(disturbed), figures_of(whole));
  EXPECT_EQ(disturbed.exit_code, whole.exit_code);
  EXPECT_EQ(disturbed.report.at("world_restarts"), deaths);
}

TEST(WorldDeath, AtRandomMomentsOfARendezvousChangesNothing) {
  RandomStream random(71, 1, Purpose::Test, 0);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scenario scenario = paper_scenario(seed, seed % 2 == 0 ? "rendezvous-2d" : "rendezvous-2d-b");
    const InProcessResult whole = run_in_process(scenario, {});
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool planning = random.uniform() < 0.5;
      faults.push_back(death(planning ? Phase::Planning : Phase::Flying,
                             static_cast<std::uint32_t>(1 + random.below(planning ? 50 : 1300))));
    }
    const InProcessResult disturbed = run_with_faults(scenario, faults);
    expect_equal(disturbed, whole, 3);
    if (HasFailure()) FAIL() << "seed " << seed << text_of(faults[0]) << text_of(faults[1]) << text_of(faults[2]);
  }
}

TEST(WorldDeath, AtEveryTickOfATransitChangesNothing) {
  for (const char* name : {"transit-corridor", "transit-partition"}) {
    const Scenario scenario = test::transit_scenario(name, 3);
    const InProcessResult whole = run_in_process(scenario, {});
    std::vector<Fault> faults{death(Phase::Planning, 1)};
    for (std::uint32_t step = 1; step <= whole.report.at("steps").get<std::uint32_t>(); ++step) {
      faults.push_back(death(Phase::Flying, step));
    }
    const InProcessResult disturbed = run_with_faults(scenario, faults);
    expect_equal(disturbed, whole, faults.size());
  }
}

TEST(WorldDeath, WithSamplesThatGetLostChangesNothing) {
  const Scenario scenario = paper_scenario(4);
  const InProcessResult whole = run_in_process(scenario, {});
  std::uint64_t lost = 0;
  const InProcessResult disturbed = run_with_faults(scenario, {death(Phase::Planning, 20), death(Phase::Flying, 70)},
                                                    test::lossy(1, {.drop = 0.1, .delay = 0.2}, lost));
  EXPECT_EQ(disturbed.report.at("state_hash"), whole.report.at("state_hash"));
  EXPECT_EQ(disturbed.report.at("world_restarts"), 2);
  EXPECT_GT(lost, 100U);
}

TEST(WorldDeath, AroundFaultsOnAgentsEqualsTheReplayOfTheRoster) {
  const std::vector<Fault> agents{{FaultKind::Kill, 2, Phase::Planning, 12},
                                  {FaultKind::Restart, 2, Phase::Flying, 40},
                                  {FaultKind::Stop, 3, Phase::Flying, 100},
                                  {FaultKind::Cont, 3, Phase::Flying, 130}};
  Scenario scenario = paper_scenario(2);
  scenario.world.on_agent_loss = OnAgentLoss::Continue;
  InProcessOptions options;
  options.faults = agents;
  const InProcessResult whole = run_in_process(scenario, options);
  ASSERT_EQ(whole.report.at("roster_changes").size(), 4U) << whole.report.dump(2);
  for (const int shift : {-1, 0, 1}) {
    std::vector<Fault> faults = agents;
    for (const Fault& fault : agents) {
      faults.push_back(death(fault.phase, static_cast<std::uint32_t>(static_cast<int>(fault.at) + shift)));
    }
    const InProcessResult disturbed = run_with_faults(scenario, faults);
    EXPECT_EQ(disturbed.report.at("state_hash"), whole.report.at("state_hash")) << shift;
    EXPECT_EQ(disturbed.report.at("roster_changes"), whole.report.at("roster_changes")) << shift;
    EXPECT_EQ(disturbed.report.at("reason"), whole.report.at("reason")) << shift;
    EXPECT_EQ(disturbed.report.at("world_restarts"), 4) << shift;
  }
}

TEST(WorldDeath, WithoutACheckpointIsRefused) {
  InProcessOptions options;
  options.faults = {death(Phase::Planning, 3)};
  EXPECT_THROW((void)run_in_process(paper_scenario(1), options), std::invalid_argument);
}

}  // namespace
}  // namespace skein
