// Only whole processes can prove it: a swarm over DDS plans, flies and arrives, and is the run that one process makes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <set>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 61;

TEST(Run, MainJobArrivesInFormation) {
  const ScratchFolder out;
  const SkeinRun run = skein_run(scenario_path("rendezvous-2d"), kDomain, out.path(), {"--seed", "1"});
  ASSERT_EQ(run.ended.exit_code, 0) << run.ended.err;
  EXPECT_NE(run.ended.err.find("3 of 3 agents"), std::string::npos) << run.ended.err;
  EXPECT_NE(run.ended.err.find("generation"), std::string::npos) << run.ended.err;
  EXPECT_TRUE(run.report.at("success"));
  EXPECT_EQ(run.report.at("carrier"), "dds");
  EXPECT_EQ(run.report.at("collisions"), 0);
  std::set<int> pids;
  const auto& vehicles = run.report.at("vehicles");
  ASSERT_EQ(vehicles.size(), 3U);
  for (const auto& vehicle : vehicles) {
    pids.insert(vehicle.at("pid").get<int>());
    EXPECT_NEAR(vehicle.at("planned_length_m").get<double>(), vehicles[0].at("planned_length_m").get<double>(), 1e-3);
    EXPECT_LT(vehicle.at("planned_length_m"), 35'100.0);
    EXPECT_EQ(vehicle.at("arrival_step"), vehicles[0].at("arrival_step"));
    EXPECT_LT(vehicle.at("max_curvature_per_m"), 0.002);
  }
  EXPECT_EQ(pids.size(), 3U) << "three agents, three processes";
  for (const auto& process : run.report.at("processes")) EXPECT_EQ(process.at("ended_by"), "exit status 0");
  EXPECT_GT(run.report.at("pss_mb_per_agent"), 0.0);
  EXPECT_TRUE(gone_within(out.path(), 5.0));
}

TEST(Run, BothCarriersAndASecondRunGiveTheSameHash) {
  const unsigned seeds = seeds_or("SKEIN_E2E_SEEDS", 2);
  for (const std::string name : {"rendezvous-2d", "rendezvous-2d-b", "rendezvous-3d", "rendezvous-clutter"}) {
    for (unsigned seed = 0; seed < seeds; ++seed) {
      const ScratchFolder out;
      const std::vector<std::string> flags{"--seed", std::to_string(seed)};
      const std::vector<std::string> here{"--seed", std::to_string(seed), "--in-process"};
      const SkeinRun first = skein_run(scenario_path(name), kDomain + 1, out.path() + "/a", flags);
      const SkeinRun second = skein_run(scenario_path(name), kDomain + 1, out.path() + "/b", flags);
      const SkeinRun memory = skein_run(scenario_path(name), kDomain + 1, out.path() + "/c", here);
      ASSERT_EQ(first.ended.exit_code, 0) << first.ended.err;
      ASSERT_EQ(second.ended.exit_code, 0) << second.ended.err;
      ASSERT_EQ(memory.ended.exit_code, 0) << memory.ended.err;
      EXPECT_EQ(first.report.at("state_hash"), second.report.at("state_hash")) << name << " seed " << seed;
      EXPECT_EQ(first.report.at("state_hash"), memory.report.at("state_hash")) << name << " seed " << seed;
      EXPECT_EQ(memory.report.at("carrier"), "in-process");
    }
  }
}

TEST(Run, HashDoesNotDependOnTheProcessorsInstructions) {
  const ScratchFolder out;
  const std::vector<std::string> flags{"--seed", "5", "--in-process"};
  const SkeinRun plain = skein_run(scenario_path("rendezvous-2d"), kDomain, out.path() + "/a", flags);
  const SkeinRun masked =
      skein_run(scenario_path("rendezvous-2d"), kDomain, out.path() + "/b", flags,
                {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL", "SKEIN_ISA=baseline"});
  ASSERT_EQ(plain.ended.exit_code, 0) << plain.ended.err;
  ASSERT_EQ(masked.ended.exit_code, 0) << masked.ended.err;
  EXPECT_EQ(plain.report.at("state_hash"), masked.report.at("state_hash"));
  // The plain formulation: one candidate at a time, nothing pruned.
  const SkeinRun scalar =
      skein_run(scenario_path("rendezvous-2d"), kDomain, out.path() + "/c", flags, {"SKEIN_ISA=scalar"});
  ASSERT_EQ(scalar.ended.exit_code, 0) << scalar.ended.err;
  EXPECT_EQ(plain.report.at("state_hash"), scalar.report.at("state_hash"));
}

class KilledAgent : public testing::TestWithParam<std::string> {};

TEST_P(KilledAgent, OthersFinishAndTheReplayGivesTheSameHash) {
  const ScratchFolder out;
  const std::string scenario = scenario_path("rendezvous-2d");
  const SkeinRun run = skein_run(scenario, kDomain + 2, out.path() + "/a", {"--seed", "4", "--fault", GetParam()});
  EXPECT_EQ(run.ended.exit_code, 4) << run.ended.err;
  EXPECT_FALSE(run.report.at("success"));
  EXPECT_EQ(run.report.at("completed_without"), nlohmann::json::array({2}));
  const std::string reason = run.report.at("reason");
  EXPECT_NE(reason.find("agent 2"), std::string::npos) << reason;
  EXPECT_NE(reason.find("step"), std::string::npos) << reason;
  EXPECT_NE(reason.find("process_ended"), std::string::npos) << reason;
  EXPECT_NE(reason.find("signal 9 (Killed)"), std::string::npos) << reason;
  for (const auto& process : run.report.at("processes")) {
    const bool killed = process.at("agent") == 2;
    EXPECT_EQ(process.at("ended_by"), killed ? "signal 9 (Killed)" : "exit status 0");
  }
  const SkeinRun replay = skein_run(scenario, kDomain + 2, out.path() + "/b",
                                    {"--seed", "4", "--in-process", "--roster", out.path() + "/a/report.json"});
  EXPECT_EQ(replay.ended.exit_code, 4);
  EXPECT_EQ(replay.report.at("state_hash"), run.report.at("state_hash"));
  EXPECT_EQ(replay.report.at("roster_changes"), run.report.at("roster_changes"));
}

INSTANTIATE_TEST_SUITE_P(InBothPhases, KilledAgent,
                         testing::Values("kill:2@plan:1", "kill:2@plan:25", "kill:2@fly:1", "kill:2@fly:100"),
                         [](const auto& parameter) { return "Fault" + std::to_string(parameter.index); });

TEST(Run, AFaultWhoseMomentNeverComesIsNamed) {
  const ScratchFolder out;
  const SkeinRun run =
      skein_run(scenario_path("rendezvous-2d"), kDomain + 3, out.path(), {"--fault", "kill:2@fly:5000"});
  EXPECT_EQ(run.ended.exit_code, 1);
  const std::string reason = run.report.at("reason");
  EXPECT_NE(reason.find("kill:2@fly:5000 never took place"), std::string::npos) << reason;
}

TEST(Run, AReplayOfAnotherRunIsRefused) {
  const ScratchFolder out;
  const std::string scenario = scenario_path("rendezvous-2d");
  const SkeinRun run = skein_run(scenario, kDomain, out.path() + "/a", {"--seed", "4", "--in-process"});
  ASSERT_EQ(run.ended.exit_code, 0);
  const std::string report = out.path() + "/a/report.json";
  for (const std::vector<std::string>& other : {std::vector<std::string>{"--seed", "5"},
                                                {"--seed", "4", "--fail-fast"},
                                                {"--seed", "4", "--set", "step_s=1"}}) {
    std::vector<std::string> flags{"--in-process", "--roster", report};
    flags.insert(flags.end(), other.begin(), other.end());
    EXPECT_EQ(skein_run(scenario, kDomain, out.path() + "/b", flags).ended.exit_code, 2)
        << testing::PrintToString(other);
  }
}

TEST(Run, AWorldThatDiesIsNamed) {
  const ScratchFolder out;
  Program program({binary("skein"), "run", scenario_path("rendezvous-2d"), "--domain", std::to_string(kDomain + 3),
                   "--out", out.path(), "--set", "step_s=0.02"});
  ASSERT_TRUE(program.read_until("flight: step", 60.0));
  for (const pid_t pid : processes_with(out.path())) {
    if (pid != program.pid()) kill(pid, SIGKILL);  // only the world has the folder on its command line
  }
  const Ended ended = program.wait(60.0);
  EXPECT_EQ(ended.exit_code, 4);
  EXPECT_NE(ended.err.find("the world ended without a report: signal 9 (Killed)"), std::string::npos) << ended.err;
  EXPECT_TRUE(gone_within(out.path(), 5.0));
}

TEST(Run, ByHandASecondWorldIsRefusedAndTheFirstOneRuns) {
  const ScratchFolder out;
  const std::vector<std::string> bus{"--domain", std::to_string(kDomain + 4), "--swarm", "e2e-by-hand"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), bus.begin(), bus.end());
    return arguments;
  };
  const std::string scenario = scenario_path("rendezvous-2d");
  Program first_agent(with({binary("skein-agent"), "--id", "2"}));
  Program world(with({binary("skein-simworld"), scenario, "--out", out.path() + "/a"}));
  ASSERT_TRUE(world.read_until("waiting", 30.0));
  const Ended second = run_program(with({binary("skein-simworld"), scenario, "--out", out.path() + "/b"}), 60.0);
  EXPECT_EQ(second.exit_code, 3) << second.err;
  EXPECT_NE(second.err.find("already has a world"), std::string::npos) << second.err;
  Program second_agent(with({binary("skein-agent"), "--id", "1"}));
  Program third_agent(with({binary("skein-agent"), "--id", "3"}));
  EXPECT_EQ(world.wait(60.0).exit_code, 0);
  for (Program* agent : {&first_agent, &second_agent, &third_agent}) EXPECT_EQ(agent->wait(60.0).exit_code, 0);
}

TEST(Run, AnAgentThatDiesUnasked) {
  const ScratchFolder out;
  Program program({binary("skein"), "run", scenario_path("rendezvous-2d"), "--json", "--domain",
                   std::to_string(kDomain + 3), "--out", out.path(), "--swarm", "e2e-unasked", "--seed", "1", "--set",
                   "step_s=0.02", "--set", "world.max_steps=1000000"});
  ASSERT_TRUE(program.read_until("flight: step", 60.0));
  std::vector<pid_t> agents;
  for (const pid_t pid : processes_with("e2e-unasked")) {
    for (const pid_t with_id : processes_with("skein-agent")) {
      if (pid == with_id) agents.push_back(pid);
    }
  }
  ASSERT_EQ(agents.size(), 3U);
  ASSERT_EQ(kill(agents[0], SIGKILL), 0);
  const Ended ended = program.wait(240.0);
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  const auto report = nlohmann::json::parse(ended.out);
  EXPECT_EQ(report.at("completed_without").size(), 1U) << report.dump(2);
  EXPECT_EQ(report.at("roster_changes")[0].at("reason"), "process_ended");
}

}  // namespace
}  // namespace skein::e2e
