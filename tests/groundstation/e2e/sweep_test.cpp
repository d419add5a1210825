// The sweep as its user calls it: statistics that equal the single runs they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

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

TEST(Sweep, InterruptedItGoesOnFromItsJournal) {
  const ScratchFolder out;
  const std::string journal = out.path() + "/journal";
  const std::string xml = out.path() + "/runs.xml";
  const std::vector<std::string> sweep{binary("skein"),
                                       "sweep",
                                       scenario_path("rendezvous-2d"),
                                       "--runs",
                                       "30",
                                       "--jobs",
                                       "1",
                                       "--resume",
                                       journal,
                                       "--json",
                                       "--junit",
                                       xml};
  const auto lines = [&] {
    std::ifstream in(journal);
    return std::count(std::istreambuf_iterator<char>(in), {}, '\n');
  };
  Program interrupted(sweep);
  for (int i = 0; i < 1000 && lines() < 4; ++i) (void)interrupted.read_until("nothing is said there", 0.02);
  const Ended twice = run_program(sweep, 60.0);
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_EQ(twice.err, "--resume: " + journal + ": another skein goes on with it now\n");
  interrupted.signal_group(SIGINT);
  const Ended first = interrupted.wait(60.0);
  EXPECT_EQ(first.exit_code, 130) << first.err;
  EXPECT_FALSE(nlohmann::json::parse(first.out).at("complete"));
  const auto made = nlohmann::json::parse(first.out).at("rows").at(0).at("per_run");
  ASSERT_GE(made.size(), 3U);
  ASSERT_LT(made.size(), 30U);
  EXPECT_NE(first.err.find("interrupted: " + std::to_string(made.size()) + " of 30 runs are done; the same command"),
            std::string::npos)
      << first.err;
  EXPECT_NE(text_of(xml).find("<error message=\"" + std::to_string(30 - made.size()) + " of 30 runs were not made\""),
            std::string::npos);
  const Ended second = run_program(sweep, 120.0);
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_NE(text_of(xml).find("tests=\"30\" failures=\"0\" errors=\"0\""), std::string::npos);
  const auto whole = nlohmann::json::parse(second.out).at("rows").at(0).at("per_run");
  ASSERT_EQ(whole.size(), 30U);
  for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(whole[i], made[i]);  // wall times too: not run again
  const Ended third = run_program(sweep, 120.0);
  EXPECT_EQ(third.out, second.out);
  std::vector<std::string> other = sweep;
  other.insert(other.end(), {"--set", "planner.particles=12"});
  const Ended refused = run_program(other, 60.0);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--resume: " + journal + ": it is the journal of another skein sweep"), std::string::npos);
}

TEST(Sweep, WhatIsRefusedLeavesOlderFilesAlone) {
  const ScratchFolder out;
  const std::string xml = out.path() + "/old.xml";
  const std::string page = out.path() + "/old.html";
  const std::string other = out.path() + "/other";
  for (const std::string& file : {xml, page, other}) std::ofstream(file) << "old\n";
  const std::vector<std::string> outputs{"--runs", "1", "--junit", xml, "--report", page};
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"/nowhere.yaml"}, {scenario_path("rendezvous-2d"), "--resume", other}}) {
    std::vector<std::string> command{binary("skein"), "sweep"};
    command.insert(command.end(), words.begin(), words.end());
    command.insert(command.end(), outputs.begin(), outputs.end());
    const Ended ended = run_program(command, 60.0);
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    for (const std::string& file : {xml, page, other}) EXPECT_EQ(text_of(file), "old\n") << file;
  }
}

TEST(Sweep, WritesJunitAndSaysHowFarItIs) {
  const ScratchFolder out;
  const std::string file = out.path() + "/runs.xml";
  const Ended ended = run_program({binary("skein"), "sweep", scenario_path("rendezvous-2d"), "--runs", "2", "--junit",
                                   file, "--progress", "--set", "world.max_steps=10"},
                                  60.0);
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err, "sweep: 2 of 2 runs\n");
  const std::string xml = text_of(file);
  EXPECT_NE(xml.find("tests=\"2\" failures=\"2\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"the flight did not end within world.max_steps = 10 steps\""),
            std::string::npos)
      << xml;
}

}  // namespace
}  // namespace skein::e2e
