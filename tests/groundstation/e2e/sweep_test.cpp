// The sweep as its user calls it: statistics that equal the single runs they are made of.
#include <gtest/gtest.h>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

TEST(Sweep, EqualsTheRunsItIsMadeOf) {
  const ScratchFolder out;
  const std::string scenario = scenario_path("rendezvous-2d");
  const Ended ended = run_program({binary("skein"), "sweep", scenario, "--runs", "3", "--seed", "10", "--json"}, 120.0);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto row = nlohmann::json::parse(ended.out).at("rows").at(0);
  ASSERT_EQ(row.at("per_run").size(), 3U);
  const SkeinRun run = skein_run(scenario, 83, out.path(), {"--seed", "11"});
  const auto& middle = row.at("per_run").at(1);
  EXPECT_EQ(middle.at("seed"), 11);
  EXPECT_EQ(middle.at("state_hash"), run.report.at("state_hash"));
}

TEST(Sweep, RequireSuccessDecidesTheExitCode) {
  const std::string scenario = scenario_path("rendezvous-2d");
  const std::vector<std::string> hopeless{binary("skein"),     "sweep", scenario, "--runs", "2", "--set",
                                          "world.max_steps=10"};
  EXPECT_EQ(run_program(hopeless, 120.0).exit_code, 0);
  std::vector<std::string> strict = hopeless;
  strict.insert(strict.end(), {"--require-success", "0.5"});
  const Ended ended = run_program(strict, 120.0);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.out.find("did not end within"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace skein::e2e
