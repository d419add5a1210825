// Agents that die and return in a transit, and carriers and radios that lose samples: the run is what its roster says,
// and those who are left arrive unhurt.
#include <cstdlib>

#include "simworld/report/report.hpp"
#include "tests/groundstation/crossings.hpp"
#include "tests/groundstation/fault_scripts.hpp"
#include "tests/groundstation/inprocess/tampering.hpp"

namespace skein {
namespace {

using test::count_status;
using test::transit_scenario;
using Json = nlohmann::ordered_json;

InProcessResult run_faulty(const Scenario& scenario, const std::vector<Fault>& faults) {
  InProcessOptions options;
  options.faults = faults;
  return run_in_process(scenario, options);
}

InProcessResult replay_of(const Scenario& scenario, const InProcessResult& faulty, bus::Tamper tamper = {}) {
  InProcessOptions options;
  options.replay = roster_changes_of(nlohmann::json::parse(faulty.report.dump()));
  options.tamper = std::move(tamper);
  return run_in_process(scenario, options);
}

class LossOfAgents : public testing::TestWithParam<const char*> {};

TEST_P(LossOfAgents, EqualsItsReplayAndHarmsNobody) {
  RandomStream random(52, 1, Purpose::Test, 0);
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scenario scenario =
        transit_scenario("transit-forest", seed, {{"vehicles.on_agent_loss", GetParam()}, {"radio.loss", "0.1"}});
    const auto at = static_cast<std::uint32_t>(1 + random.below(20));
    const auto agent = static_cast<AgentId>(1 + random.below(5));
    const InProcessResult killed = run_faulty(scenario, {{FaultKind::Kill, agent, Phase::Flying, at}});
    ASSERT_EQ(killed.exit_code, 4) << seed << ": " << killed.report.at("reason");
    ASSERT_EQ(killed.report.at("collisions"), 0) << seed;
    ASSERT_EQ(killed.report.at("radio").at("over_budget"), 0) << seed;
    // who hovers says nothing, so that others keep clear of all that it could reach: of a gap, too, and then they say
    // so
    const std::size_t done = count_status(killed.report, "arrived") + count_status(killed.report, "unreachable") +
                             count_status(killed.report, "deadlock");
    ASSERT_EQ(done, 4U) << seed << killed.report.at("reason");
    if (std::string(GetParam()) == "remove") {
      ASSERT_EQ(killed.report.at("completed_without"), nlohmann::ordered_json::array({agent})) << seed;
    }
    const InProcessResult replayed = replay_of(scenario, killed);
    ASSERT_EQ(replayed.report.at("state_hash"), killed.report.at("state_hash")) << seed;
    ASSERT_EQ(replayed.report.at("vehicles"), killed.report.at("vehicles")) << seed;
    ASSERT_EQ(replayed.report.at("radio"), killed.report.at("radio")) << seed;
    std::uint64_t lost = 0;
    const InProcessResult rough = replay_of(scenario, killed, test::lossy(seed, {.drop = 0.1, .delay = 0.2}, lost));
    ASSERT_EQ(rough.report.at("state_hash"), killed.report.at("state_hash")) << seed;
  }
}

TEST_P(LossOfAgents, AndTheirReturnEqualTheReplay) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scenario scenario =
        transit_scenario("transit-partition", seed, {{"vehicles.on_agent_loss", GetParam()}, {"radio.loss", "0.1"}});
    const InProcessResult faulty = run_faulty(scenario, test::random_script(seed, 6, 1, 15));
    ASSERT_EQ(faulty.report.at("collisions"), 0) << seed << ": " << faulty.report.at("reason");
    const InProcessResult replayed = replay_of(scenario, faulty);
    ASSERT_EQ(replayed.report.at("state_hash"), faulty.report.at("state_hash")) << seed;
    ASSERT_EQ(replayed.report.at("roster_changes"), faulty.report.at("roster_changes")) << seed;
    ASSERT_EQ(replayed.report.at("vehicles"), faulty.report.at("vehicles")) << seed;
  }
}

TEST_P(LossOfAgents, WhoReturnsFliesNoMore) {
  const Scenario scenario = transit_scenario("transit-partition", 1, {{"vehicles.on_agent_loss", GetParam()}});
  const InProcessResult faulty =
      run_faulty(scenario, {{FaultKind::Kill, 5, Phase::Flying, 6}, {FaultKind::Restart, 5, Phase::Flying, 12}});
  EXPECT_EQ(faulty.exit_code, 4);
  EXPECT_EQ(faulty.report.at("collisions"), 0);
  ASSERT_EQ(faulty.report.at("roster_changes").size(), 2U);
  EXPECT_EQ(faulty.report.at("roster_changes").at(1).at("reason"), "rejoined");
  EXPECT_NE(faulty.report.at("vehicles").at(4).at("status"), "arrived");
  // it hovers where others must pass, unheard: one of them gives up
  const bool hovers = std::string(GetParam()) == "hover";
  EXPECT_EQ(count_status(faulty.report, "arrived"), hovers ? 4U : 5U) << faulty.report.at("reason");
  EXPECT_EQ(count_status(faulty.report, "deadlock"), hovers ? 1U : 0U) << faulty.report.at("reason");
  EXPECT_EQ(replay_of(scenario, faulty).report.at("state_hash"), faulty.report.at("state_hash"));
}

/// A scenario that goes on until the radio has had the time to make all maps equal.
Scenario settling(const std::string& name, std::uint64_t seed, std::vector<Override> changes) {
  const std::uint32_t steps = settling_steps(transit_scenario(name, seed, changes).mission).value();
  changes.push_back({"world.extra_steps", std::to_string(steps + 1)});
  return transit_scenario(name, seed, changes);
}

TEST_P(LossOfAgents, MapsAreEqualAfterTheLastHealing) {
  const char* seeds = std::getenv("SKEIN_SEEDS");
  const std::uint64_t runs = seeds == nullptr ? 8 : std::strtoull(seeds, nullptr, 10);
  constexpr std::pair<const char*, unsigned> kFlights[] = {{"transit-partition", 25}, {"transit-power-station", 60}};
  for (const auto& [name, steps] : kFlights) {
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
      const Scenario scenario =
          settling(name, seed, {{"vehicles.on_agent_loss", GetParam()}, {"radio.loss", seed % 2 == 0 ? "0" : "0.1"}});
      const InProcessResult faulty = run_faulty(scenario, test::random_script(seed, 6, 1, steps));
      const std::string what = std::string(name) + " " + std::to_string(seed) + ": ";
      ASSERT_EQ(faulty.report.at("maps_differ"), 0) << what << faulty.report.at("reason");
      ASSERT_GE(faulty.report.at("maps_due"), 2) << what << faulty.report.at("reason");
      ASSERT_EQ(faulty.report.at("unaccepted_plans"), 0) << what;
      ASSERT_EQ(faulty.report.at("radio").at("over_budget"), 0) << what;
    }
  }
}

TEST_P(LossOfAgents, WhoReturnsHasTheSwarmsMapAgain) {
  // agent 2 is back when it and all others stand still already; what it alone had seen is in the maps of the others
  const Scenario scenario = settling("transit-partition", 1, {{"vehicles.on_agent_loss", GetParam()}});
  const std::uint32_t flown =
      run_in_process(scenario, {}).report.at("steps").get<std::uint32_t>() - scenario.world.extra_steps;
  const InProcessResult back = run_faulty(
      scenario, {{FaultKind::Kill, 2, Phase::Flying, flown - 1}, {FaultKind::Restart, 2, Phase::Flying, flown}});
  ASSERT_EQ(back.report.at("roster_changes").size(), 2U);
  EXPECT_EQ(back.report.at("maps_due"), 6) << "its own, too";
  EXPECT_EQ(back.report.at("maps_differ"), 0);
  EXPECT_EQ(back.report.at("map_equal"), true);
  EXPECT_EQ(replay_of(scenario, back).report.at("state_hash"), back.report.at("state_hash"));
}

INSTANTIATE_TEST_SUITE_P(InATransit, LossOfAgents, testing::Values("remove", "hover"),
                         [](const auto& what) { return std::string("They") + what.param; });

TEST(LossyCarrier, ChangesNothingInATransit) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scenario scenario = transit_scenario("transit-power-station", seed, {{"radio.loss", "0.1"}});
    const InProcessResult calm = test::run_with(scenario, {});
    ASSERT_EQ(calm.exit_code, 0) << calm.report.at("reason");
    std::uint64_t lost = 0;
    const test::Losses losses{.drop = 0.15, .duplicate = 0.2, .delay = 0.2};
    const InProcessResult rough = test::run_with(scenario, test::lossy(seed, losses, lost));
    ASSERT_EQ(rough.report.at("state_hash"), calm.report.at("state_hash")) << seed;
    ASSERT_EQ(rough.report.at("radio"), calm.report.at("radio")) << seed;
    ASSERT_EQ(rough.report.at("refused_samples"), 0) << seed;
    ASSERT_TRUE(rough.report.at("roster_changes").empty()) << seed;
    ASSERT_GT(lost, 100U) << seed;
  }
}

TEST(LossyRadio, AllArriveWhateverItLosesAndNobodyIsHurt) {
  for (const char* loss : {"0.3", "0.7", "1"}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Json report =
          run_in_process(transit_scenario("transit-power-station", seed, {{"radio.loss", loss}}), {}).report;
      EXPECT_EQ(report.at("collisions"), 0) << loss << " " << seed;
      EXPECT_EQ(report.at("radio").at("over_budget"), 0) << loss << " " << seed;
      if (std::string(loss) != "1") {
        EXPECT_EQ(report.at("exit_code"), 0) << loss << " " << seed << ": " << report.at("reason");
      }
      std::uint64_t heard = 0;
      for (const auto& link : report.at("radio").at("links")) heard += link.at("samples").get<std::uint64_t>();
      EXPECT_EQ(heard == 0, std::string(loss) == "1") << loss;
    }
  }
}

TEST(LossyRadio, LateAndNarrowItCostsTimeButHarmsNobody) {
  for (const char* latency : {"1", "3"}) {
    const Json report = run_in_process(transit_scenario("transit-power-station", 1,
                                                        {{"radio.latency_rounds", latency},
                                                         {"radio.loss", "0.1"},
                                                         {"radio.bit_rate_bps", "20000"},
                                                         {"world.max_steps", "2000"}}),
                                       {})
                            .report;
    EXPECT_EQ(report.at("collisions"), 0) << latency;
    EXPECT_EQ(report.at("radio").at("over_budget"), 0) << latency;
    EXPECT_LE(report.at("radio").at("peak_slot_bits"), report.at("radio").at("slot_bits")) << latency;
  }
}

}  // namespace
}  // namespace skein
