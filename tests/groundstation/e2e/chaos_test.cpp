// Only whole processes can prove it: a campaign of faults ends with a table, keeps every promise, and leaves nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 86;

Ended chaos(const std::string& scenario, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{binary("skein"), "chaos", scenario, "--domain", std::to_string(kDomain)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments, 500.0);
}

std::string faults_file(const ScratchFolder& out, const std::string& text) {
  std::string path = out.path() + "/faults";
  std::ofstream(path) << text;
  return path;
}

constexpr const char* kNever[] = {
    "unsafe", "hangs", "orphans", "leftovers", "unexplained", "replay_mismatches", "maps_differ", "unaccepted_plans"};

TEST(Chaos, EveryRunKeepsTheInvariants) {
  const ScratchFolder out;
  const unsigned runs = seeds_or("SKEIN_E2E_CHAOS", 10);  // of all kinds that this machine can do
  for (const char* scenario : {"rendezvous-ring", "transit-power-station"}) {
    const bool ring = std::string(scenario) == "rendezvous-ring";
    const Ended ended = chaos(scenario_path(scenario), {"--runs", std::to_string(runs), "--seed", "7", "--agents",
                                                        ring ? "6" : "5", "--out", out.path() + "/runs", "--json"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err << ended.out;
    const auto summary = nlohmann::json::parse(ended.out);
    EXPECT_EQ(summary.at("runs"), runs);
    EXPECT_GE(summary.at("injected").get<unsigned>() + 1, runs) << "one may come too late: " << summary.dump(2);
    EXPECT_EQ(summary.at("completed").get<unsigned>() + summary.at("degraded").get<unsigned>(), runs);
    for (const char* key : kNever) EXPECT_EQ(summary.at(key), 0) << key << summary.dump(2);
    EXPECT_EQ(summary.at("maps_judged"), ring ? 0U : runs) << summary.dump(2);
    for (const char* kind : {"world", "pause", "slow", "delay"}) {
      if (!summary.at("faults").contains(kind)) continue;
      const auto& counts = summary.at("faults").at(kind);
      EXPECT_EQ(counts.at("completed"), counts.at("runs")) << summary.dump(2);
    }
    EXPECT_FALSE(std::filesystem::exists(out.path() + "/runs")) << "nothing is kept of a sound campaign";
    EXPECT_TRUE(gone_within(out.path() + "/runs", 5.0));
  }
}

TEST(Chaos, APartitionHealsAndWhoWasCutOffReturns) {
  const ScratchFolder out;
  const unsigned runs = 6;
  const Ended ended = run_program({binary("skein"), "chaos", scenario_path("rendezvous-ring"), "--domain", "88",
                                   "--agents", "6", "--runs", std::to_string(runs), "--seed", "3", "--faults",
                                   faults_file(out, "partition\n"), "--out", out.path() + "/runs", "--json"},
                                  300.0);
  if (ended.exit_code == 2) {  // this machine gives no network namespace, and says so
    EXPECT_NE(ended.err.find(": partition "), std::string::npos) << ended.err;
    return;
  }
  ASSERT_EQ(ended.exit_code, 0) << ended.err << ended.out;
  const auto summary = nlohmann::json::parse(ended.out);
  for (const char* key : kNever) EXPECT_EQ(summary.at(key), 0) << key << summary.dump(2);
  const auto& counts = summary.at("faults").at("partition");
  EXPECT_GT(counts.at("completed"), 0) << "shorter than the deadline: " << summary.dump(2);
  EXPECT_GT(counts.at("degraded"), 0) << "longer: " << summary.dump(2);
  EXPECT_EQ(counts.at("recovery_steps").at("runs"), counts.at("degraded")) << "all return: " << summary.dump(2);
}

TEST(Chaos, WhatIsWrongIsNamedInOneLine) {
  const ScratchFolder out;
  const std::string small = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";
  const std::string faults = faults_file(out, "kill\nmelt\n");
  const Ended unknown = chaos(small, {"--faults", faults});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err, "skein chaos: " + faults +
                             ":2:1: unknown fault 'melt'; allowed: kill, stop, restart, world, "
                             "pause, slow, drop, delay, partition\n");
  const Ended missing = chaos(small, {"--faults", out.path() + "/none"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.err, "skein chaos: --faults " + out.path() + "/none: it cannot be read\n");
  EXPECT_EQ(chaos(out.path() + "/none.yaml", {}).exit_code, 2);
}

TEST(Chaos, ASignalEndsTheCampaignAndItsRunAndItGoesOnLater) {
  const ScratchFolder out;
  const std::vector<std::string> words{"--faults", faults_file(out, "pause\n"), "--out", out.path() + "/runs",
                                       "--resume", out.path() + "/journal",     "--runs"};
  std::vector<std::string> many{binary("skein"), "chaos", scenario_path("rendezvous-ring"), "--domain",
                                std::to_string(kDomain)};
  many.insert(many.end(), words.begin(), words.end());
  many.emplace_back("1000");
  Program program(many);
  ASSERT_TRUE(program.read_until("2 of 1000", 60.0));
  program.signal_group(SIGTERM);
  const Ended ended = program.wait(30.0);
  EXPECT_EQ(ended.exit_code, 143);
  EXPECT_TRUE(gone_within(out.path() + "/runs", 5.0));

  const bool third_made = ended.err.find("3 of 1000") != std::string::npos;  // before the signal came
  std::vector<std::string> few = words;
  few.insert(few.end(), {third_made ? "4" : "3", "--json"});
  const Ended rest = chaos(scenario_path("rendezvous-ring"), few);
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(std::ranges::count(rest.err, '\n'), 1) << "one run is made: " << rest.err;
  const auto summary = nlohmann::json::parse(rest.out);
  EXPECT_EQ(summary.at("runs"), third_made ? 4 : 3);
  EXPECT_EQ(summary.at("per_run").at(1).at("seed"), summary.at("seed").get<unsigned>() + 1);
  few.front() = "--limit";  // other faults: another campaign
  few[1] = "60";
  const Ended other = chaos(scenario_path("rendezvous-ring"), few);
  EXPECT_EQ(other.exit_code, 2) << other.err;
  EXPECT_NE(other.err.find("it is the journal of another skein chaos"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace skein::e2e
