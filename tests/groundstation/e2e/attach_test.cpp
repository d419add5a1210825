// Only whole processes can prove it: who watches a run that others started learns how it went, and disturbs nothing.
#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

const std::string kDomain = "69";
const std::string kScenario = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

std::vector<std::string> attach_to(const std::string& swarm) {
  std::vector<std::string> words{binary("skein"), "run", "--attach", "--domain", kDomain, "--json"};
  if (!swarm.empty()) words.insert(words.end(), {"--swarm", swarm});
  return words;
}

std::unique_ptr<Program> start(std::vector<std::string> words, const std::string& swarm) {
  words.insert(words.end(), {"--domain", kDomain, "--swarm", swarm});
  return std::make_unique<Program>(words);
}

TEST(Attach, WatchesASwarmStartedByHandToItsEnd) {
  const ScratchFolder out;
  const std::string swarm = "attach-by-hand";
  Program before(attach_to(swarm));  // it may be there first
  const auto world = start({binary("skein-simworld"), kScenario, "--out", out.path()}, swarm);
  ASSERT_TRUE(world->read_until("waiting", 30.0));
  Program after(attach_to(""));  // the domain's only swarm
  ASSERT_TRUE(after.read_until("discovery", 30.0));
  ASSERT_TRUE(before.read_until("discovery", 30.0));
  const auto first = start({binary("skein-agent"), "--id", "1"}, swarm);
  const auto second = start({binary("skein-agent"), "--id", "2"}, swarm);
  EXPECT_EQ(world->wait(60.0).exit_code, 0);
  const Ended alone =
      run_program({binary("skein"), "run", kScenario, "--in-process", "--json", "--out", out.path() + "/alone"}, 60.0);
  const auto report = nlohmann::json::parse(alone.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << alone.err;
  for (Program* watcher : {&before, &after}) {
    const Ended ended = watcher->wait(30.0);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const auto result = nlohmann::json::parse(ended.out, nullptr, false);
    ASSERT_TRUE(result.is_object()) << ended.out;
    EXPECT_EQ(result.at("reason"), "all vehicles arrived in formation");
    EXPECT_EQ(result.at("scenario"), "small");
    EXPECT_EQ(result.at("state_hash"), report.at("state_hash"));
  }
  EXPECT_EQ(first->wait(30.0).exit_code, 0);
  EXPECT_EQ(second->wait(30.0).exit_code, 0);
}

TEST(Attach, TakesOverTheExitCodeOfARunThatIsEnded) {
  const ScratchFolder out;
  const std::string swarm = "attach-ended";
  const auto world = start({binary("skein-simworld"), kScenario, "--out", out.path(), "--set", "step_s=0.002", "--set",
                            "world.max_steps=1000000"},
                           swarm);
  const auto first = start({binary("skein-agent"), "--id", "1"}, swarm);
  const auto second = start({binary("skein-agent"), "--id", "2"}, swarm);
  ASSERT_TRUE(world->read_until("flying", 60.0));
  Program watcher(attach_to(swarm));
  ASSERT_TRUE(watcher.read_until("flight", 30.0));
  world->signal_group(SIGTERM);
  EXPECT_EQ(world->wait(30.0).exit_code, 143);
  const Ended ended = watcher.wait(30.0);
  EXPECT_EQ(ended.exit_code, 143) << ended.err;
  EXPECT_NE(ended.out.find("ended by SIGTERM"), std::string::npos) << ended.out;
}

TEST(Attach, SaysThatAWorldDied) {
  const ScratchFolder out;
  const std::string swarm = "attach-died";
  const auto world = start({binary("skein-simworld"), kScenario, "--out", out.path()}, swarm);
  Program watcher(attach_to(swarm));
  ASSERT_TRUE(watcher.read_until("discovery", 30.0));
  world->signal_group(SIGKILL);
  EXPECT_EQ(world->wait(30.0).exit_code, 137);
  const Ended ended = watcher.wait(60.0);  // its lease runs out after 20 s
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  EXPECT_NE(ended.err.find("the world of swarm attach-died is gone"), std::string::npos) << ended.err;
}

TEST(Attach, NamesTheSwarmsToChooseFrom) {
  const ScratchFolder out;
  const auto one = start({binary("skein-simworld"), kScenario, "--out", out.path() + "/1"}, "attach-one");
  const auto two = start({binary("skein-simworld"), kScenario, "--out", out.path() + "/2"}, "attach-two");
  ASSERT_TRUE(one->read_until("waiting", 30.0));
  ASSERT_TRUE(two->read_until("waiting", 30.0));
  const Ended ended = run_program(attach_to(""), 60.0);
  EXPECT_EQ(ended.exit_code, 2) << ended.err;
  EXPECT_NE(ended.err.find("has 2 swarms: attach-one, attach-two; choose one with --swarm"), std::string::npos)
      << ended.err;
  for (const auto& world : {one.get(), two.get()}) {
    world->signal_group(SIGTERM);
    EXPECT_EQ(world->wait(30.0).exit_code, 143);
  }
}

TEST(Attach, GivesUpWhereNobodyIs) {
  std::vector<std::string> words = attach_to("attach-nobody");
  words.insert(words.end(), {"--startup-timeout", "0.5"});
  const Ended ended = run_program(words, 30.0);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_NE(ended.err.find("no world of swarm attach-nobody in domain 69 within 0.5 s"), std::string::npos)
      << ended.err;
}

TEST(Attach, TakesNoScenario) {
  EXPECT_EQ(run_program({binary("skein"), "run", "--attach", kScenario}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({binary("skein"), "run"}, 30.0).exit_code, 2);
}

}  // namespace
}  // namespace skein::e2e
