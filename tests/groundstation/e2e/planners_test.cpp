// Planners by name, as their user calls them: the same run over both carriers, and one table of all of them.
#include <gtest/gtest.h>

#include <set>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 86;

TEST(Planners, BothCarriersGiveTheSameHash) {
  std::set<std::string> hashes;
  for (const std::string name : {"dcpso", "dcpso-paper", "dcpso-solo", "ccga"}) {
    const ScratchFolder out;
    const std::string scenario = scenario_path("rendezvous-2d");
    const std::vector<std::string> flags{"--seed", "1", "--planner", name};
    std::vector<std::string> here = flags;
    here.emplace_back("--in-process");
    const SkeinRun wire = skein_run(scenario, kDomain, out.path() + "/a", flags);
    const SkeinRun memory = skein_run(scenario, kDomain, out.path() + "/b", here);
    ASSERT_FALSE(wire.report.is_null()) << wire.ended.err;
    EXPECT_EQ(wire.report.at("planner"), name);
    EXPECT_EQ(wire.report.at("plan_feasible"), true) << wire.report.dump(2);
    EXPECT_EQ(wire.report.at("state_hash"), memory.report.at("state_hash")) << name;
    EXPECT_EQ(wire.report.at("separations"), memory.report.at("separations")) << name;
    EXPECT_EQ(wire.ended.exit_code, memory.ended.exit_code) << name;
    EXPECT_TRUE(hashes.insert(wire.report.at("state_hash")).second) << name;
  }
}

TEST(Planners, AloneEveryoneArrivesAtATimeOfItsOwn) {
  const ScratchFolder out;
  const SkeinRun run = skein_run(scenario_path("rendezvous-2d"), kDomain, out.path(),
                                 {"--seed", "1", "--in-process", "--planner", "dcpso-solo"});
  EXPECT_EQ(run.ended.exit_code, 1) << run.ended.err;
  EXPECT_EQ(run.report.at("plan_feasible"), true);
  EXPECT_EQ(run.report.at("plan_success"), false);
  EXPECT_GT(run.report.at("plan_spread_m"), 3000.0);
  EXPECT_TRUE(run.report.at("reason").get<std::string>().starts_with("arrivals are ")) << run.report.at("reason");
  EXPECT_EQ(run.report.at("collisions"), 0);
  for (const auto& vehicle : run.report.at("vehicles")) EXPECT_EQ(vehicle.at("status"), "arrived");
}

TEST(Planners, OneSweepPutsThemSideBySide) {
  const std::string list = "dcpso,dcpso-paper,dcpso-solo,ccga";
  const std::vector<std::string> flags{binary("skein"), "sweep", scenario_path("rendezvous-2d"), "--runs", "4",
                                       "--planner",     list};
  const Ended text = run_program(flags, 120.0);
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("separations.2-3.planned_m"), std::string::npos) << text.out;
  std::vector<std::string> as_json = flags;
  as_json.emplace_back("--json");
  const Ended ended = run_program(as_json, 120.0);
  const auto table = nlohmann::json::parse(ended.out).at("table");
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0].at("plan_success").at("rate"), 1.0);
  EXPECT_EQ(table[0].at("success").at("rate"), 1.0);
  EXPECT_LT(table[0].at("figures").at("plan_spread_m").at("mean"), 1e-6);
  EXPECT_EQ(table[1].at("set").at("planner.name"), "dcpso-paper");
  EXPECT_NEAR(table[1].at("figures").at("vehicles.1.planned_length_m").at("mean").get<double>(), 35'061.1, 1.0);
  EXPECT_EQ(table[2].at("over"), "feasible plans");
  EXPECT_NEAR(table[2].at("figures").at("separations.2-3.planned_m").at("mean").get<double>(), 1'200.0, 1.0);
  EXPECT_EQ(table[3].at("runs"), 4);
}

TEST(Planners, AnUnknownOneIsRefused) {
  const Ended ended =
      run_program({binary("skein"), "sweep", scenario_path("rendezvous-2d"), "--planner", "dcpso,best"}, 60.0);
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_NE(ended.err.find("allowed: dcpso, dcpso-paper, dcpso-solo, ccga"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace skein::e2e
