// Only whole processes can prove it: a swarm crosses unknown space over DDS, shares its maps, and is the run that one
// process makes; and the sweep sets planners side by side.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 74;

SkeinRun run_of(const std::string& name, unsigned seed, const std::string& out, bool in_process) {
  std::vector<std::string> flags{"--seed", std::to_string(seed)};
  if (in_process) flags.emplace_back("--in-process");
  return skein_run(scenario_path(name), kDomain, out + (in_process ? "/memory" : "/dds"), flags);
}

TEST(Transit, NineProcessesCrossThePowerStation) {
  const ScratchFolder out;
  const unsigned seeds = seeds_or("SKEIN_E2E_SEEDS", 2);
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const std::string folder = out.path() + "/" + std::to_string(seed);
    const SkeinRun run = run_of("transit-power-station", seed, folder, false);
    ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
    EXPECT_EQ(run.report.at("carrier"), "dds");
    EXPECT_EQ(run.report.at("collisions"), 0);
    EXPECT_EQ(run.report.at("arrived"), 9);
    std::set<int> pids;
    for (const auto& vehicle : run.report.at("vehicles")) {
      EXPECT_EQ(vehicle.at("status"), "arrived");
      EXPECT_GT(vehicle.at("path_length_m").get<double>(), 400.0);
      pids.insert(vehicle.at("pid").get<int>());
    }
    EXPECT_EQ(pids.size(), 9U) << "nine agents, nine processes";
    EXPECT_GT(run.report.at("radio").at("sent_samples"), 100);
    EXPECT_EQ(run.report.at("radio").at("over_budget"), 0);
    EXPECT_TRUE(run.report.at("roster_changes").empty());
    const SkeinRun memory = run_of("transit-power-station", seed, folder, true);
    ASSERT_EQ(memory.ended.exit_code, 0) << memory.ended.err;
    EXPECT_EQ(memory.report.at("state_hash"), run.report.at("state_hash")) << seed;
    EXPECT_EQ(memory.report.at("radio"), run.report.at("radio")) << seed;
  }
  EXPECT_TRUE(gone_within(out.path(), 5.0));
}

TEST(Transit, GroupsThatMeetHaveEqualMapsOverBothCarriers) {
  const ScratchFolder out;
  const SkeinRun run = run_of("transit-partition", 1, out.path(), false);
  ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
  EXPECT_EQ(run.report.at("map_equal"), true);
  EXPECT_EQ(run.report.at("partitions").at(0).at("groups"), 2);
  const SkeinRun memory = run_of("transit-partition", 1, out.path(), true);
  ASSERT_EQ(memory.ended.exit_code, 0) << memory.ended.err;
  for (const char* key : {"state_hash", "map_equal", "map_equal_since_step", "partitions", "radio"}) {
    EXPECT_EQ(memory.report.at(key), run.report.at(key)) << key;
  }
}

TEST(Transit, AKilledAgentsRunEqualsItsReplay) {
  const ScratchFolder out;
  const std::string scenario = scenario_path("transit-partition");
  const SkeinRun run = skein_run(scenario, kDomain, out.path() + "/a", {"--seed", "2", "--fault", "kill:2@fly:9"});
  EXPECT_EQ(run.ended.exit_code, 4) << run.ended.err;
  EXPECT_EQ(run.report.at("completed_without"), nlohmann::json::array({2}));
  EXPECT_EQ(run.report.at("collisions"), 0);
  const SkeinRun replay = skein_run(scenario, kDomain, out.path() + "/b",
                                    {"--seed", "2", "--in-process", "--roster", out.path() + "/a/report.json"});
  EXPECT_EQ(replay.ended.exit_code, 4) << replay.ended.err;
  EXPECT_EQ(replay.report.at("state_hash"), run.report.at("state_hash"));
}

TEST(Transit, TheSweepSetsPlannersAndValuesSideBySide) {
  std::vector<std::string> command{binary("skein"),
                                   "sweep",
                                   scenario_path("transit-power-station"),
                                   "--runs",
                                   "2",
                                   "--agents",
                                   "3",
                                   "--planner",
                                   "peach3d,peach",
                                   "--set",
                                   "planner.cell_m=4,6"};
  const Ended table = run_program(command, 240.0);
  ASSERT_EQ(table.exit_code, 0) << table.err;
  for (const char* word : {"peach3d", "peach", "planner.cell_m=4", "planner.cell_m=6", "total_path_m"}) {
    EXPECT_NE(table.out.find(word), std::string::npos) << word << " in\n" << table.out;
  }
  command.emplace_back("--json");
  const Ended json = run_program(command, 240.0);
  ASSERT_EQ(json.exit_code, 0) << json.err;
  const auto document = nlohmann::json::parse(json.out);
  ASSERT_EQ(document.at("rows").size(), 4U);
  for (const auto& row : document.at("rows")) EXPECT_EQ(row.at("runs"), 2);
  EXPECT_FALSE(document.at("table").empty());
}

TEST(Transit, MistakesAreNamedInOneLine) {
  const std::string transit = scenario_path("transit-partition");
  const std::string rendezvous = scenario_path("rendezvous-2d");
  for (const std::vector<std::string>& flags : {std::vector<std::string>{"run", transit, "--controller", "nonesuch"},
                                                {"run", rendezvous, "--controller", "peach"},
                                                {"run", transit, "--agents", "7"},
                                                {"run", transit, "--set", "radio.loss=2"},
                                                {"run", transit, "--set", "planner.decision_s=0.3"},
                                                {"run", transit, "--set", "formation={}"},
                                                {"sweep", transit, "--runs", "1", "--controller", "orca,nonesuch"},
                                                {"sweep", rendezvous, "--runs", "1", "--controller", "peach3d"},
                                                {"sweep", transit, "--runs", "1", "--set", "sensor.range_m=24,-1"},
                                                {"validate", transit, "--set", "goals={x_m: 64, y_m: 10}"}}) {
    std::vector<std::string> command{binary("skein")};
    command.insert(command.end(), flags.begin(), flags.end());
    const Ended ended = run_program(command, 30.0);
    const std::string what = testing::PrintToString(flags) + "\n" + ended.err;
    EXPECT_EQ(ended.exit_code, 2) << what;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << what;
  }
}

}  // namespace
}  // namespace skein::e2e
