// Only whole processes can prove it: world and agents started by hand, in any order, in several terminals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <memory>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

constexpr unsigned kDomain = 67;

/// What two terminals type: everybody's command line is in domain 67 and in one swarm.
class Terminals {
 public:
  explicit Terminals(std::string swarm) : swarm_(std::move(swarm)) {}

  [[nodiscard]] std::unique_ptr<Program> world(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{binary("skein-simworld"),
                                       std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return start(arguments);
  }
  [[nodiscard]] std::unique_ptr<Program> agent(unsigned id) {
    return start({binary("skein-agent"), "--id", std::to_string(id)});
  }
  [[nodiscard]] std::unique_ptr<Program> nameless_agent() { return start({binary("skein-agent")}); }

 private:
  [[nodiscard]] std::unique_ptr<Program> start(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--domain", std::to_string(kDomain), "--swarm", swarm_});
    return std::make_unique<Program>(arguments);
  }

  std::string swarm_;
};

TEST(ByHand, ThreeTerminalsInAnyOrder) {
  std::array<unsigned, 3> order{0, 1, 2};  // 0 is the world, the others are the agents
  do {
    const ScratchFolder out;
    Terminals terminals("by-hand-" + std::to_string(100 * order[0] + 10 * order[1] + order[2]));
    std::vector<std::unique_ptr<Program>> programs;
    for (const unsigned who : order) {
      programs.push_back(who == 0 ? terminals.world(out.path()) : terminals.agent(who));
      programs.back()->read_until(who == 0 ? "waiting" : "introduces itself", 30.0);
    }
    for (const auto& program : programs) {
      const Ended ended = program->wait(60.0);
      EXPECT_EQ(ended.exit_code, 0) << testing::PrintToString(order) << ended.err;
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

/// A flight long enough to do something in it.
const std::vector<std::string> kSlow{"--set", "step_s=0.002",         "--set", "world.max_steps=1000000",
                                     "--set", "lockstep.deadline_s=2"};

TEST(ByHand, AgentsWithoutAnIdAreGivenOneEach) {
  const ScratchFolder out;
  Terminals terminals("by-hand-nameless");
  const auto first = terminals.nameless_agent();
  const auto world = terminals.world(out.path() + "/a");
  const auto second = terminals.nameless_agent();
  for (Program* program : {first.get(), world.get(), second.get()}) {
    const Ended ended = program->wait(60.0);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
  }
  const SkeinRun alone =
      skein_run(std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml", kDomain, out.path() + "/b", {"--in-process"});
  std::ifstream file(out.path() + "/a/report.json");
  EXPECT_EQ(nlohmann::json::parse(file).at("state_hash"), alone.report.at("state_hash"));
}

TEST(ByHand, ANewcomerWithoutAnIdTakesALostAgentsPlace) {
  const ScratchFolder out;
  Terminals terminals("by-hand-newcomer");
  const auto world = terminals.world(out.path(), kSlow);
  const auto first = terminals.agent(1);
  const auto second = terminals.agent(2);
  ASSERT_TRUE(world->read_until("flying", 60.0));
  const auto newcomer = terminals.nameless_agent();  // waits: both ids are held
  ASSERT_TRUE(newcomer->read_until("asks swarm", 60.0));
  second->signal_group(SIGKILL);
  EXPECT_EQ(second->wait(30.0).exit_code, 137);
  ASSERT_TRUE(newcomer->read_until("rejoined at round", 60.0));
  world->signal_group(SIGTERM);
  EXPECT_EQ(newcomer->wait(30.0).exit_code, 0);
  EXPECT_EQ(first->wait(30.0).exit_code, 0);
  EXPECT_EQ(world->wait(30.0).exit_code, 143);
}

TEST(ByHand, ASecondLiveIdIsRefusedInOneLine) {
  const ScratchFolder out;
  Terminals terminals("by-hand-second-id");
  const auto world = terminals.world(out.path(), kSlow);
  const auto first = terminals.agent(1);
  const auto second = terminals.agent(2);
  ASSERT_TRUE(world->read_until("flying", 60.0));
  const auto intruder = terminals.agent(2);
  const Ended refused = intruder->wait(30.0);
  EXPECT_EQ(refused.exit_code, 3) << refused.err;
  EXPECT_NE(refused.err.find("the world refused agent 2: id_in_use"), std::string::npos) << refused.err;
  world->signal_group(SIGTERM);
  EXPECT_EQ(world->wait(30.0).exit_code, 143);
  EXPECT_EQ(first->wait(30.0).exit_code, 0);
  EXPECT_EQ(second->wait(30.0).exit_code, 0);
}

TEST(ByHand, AKilledAgentMayBeStartedAgain) {
  const ScratchFolder out;
  Terminals terminals("by-hand-again");
  const auto world = terminals.world(out.path(), kSlow);
  const auto first = terminals.agent(1);
  const auto second = terminals.agent(2);
  ASSERT_TRUE(world->read_until("flying", 60.0));
  second->signal_group(SIGKILL);
  EXPECT_EQ(second->wait(30.0).exit_code, 137);
  const auto again = terminals.agent(2);  // waits until the deadline has dropped the one before
  ASSERT_TRUE(again->read_until("rejoined at round", 60.0));
  world->signal_group(SIGTERM);
  const Ended ended = world->wait(30.0);
  EXPECT_EQ(again->wait(30.0).exit_code, 0);
  EXPECT_EQ(first->wait(30.0).exit_code, 0);
  EXPECT_EQ(ended.exit_code, 143);
}

TEST(ByHand, AStoppedAgentComesBackWhenItIsContinued) {
  const ScratchFolder out;
  Terminals terminals("by-hand-stopped");
  const auto world = terminals.world(out.path(), kSlow);
  const auto first = terminals.agent(1);
  const auto second = terminals.agent(2);
  ASSERT_TRUE(world->read_until("flying", 60.0));
  second->signal_group(SIGSTOP);
  ASSERT_TRUE(world->read_until("\"live\":1", 60.0));
  second->signal_group(SIGCONT);
  ASSERT_TRUE(second->read_until("rejoined at round", 60.0));
  world->signal_group(SIGTERM);
  EXPECT_EQ(world->wait(30.0).exit_code, 143);
  EXPECT_EQ(second->wait(30.0).exit_code, 0);
  EXPECT_EQ(first->wait(30.0).exit_code, 0);
}

TEST(ByHand, ClosedStandardStreamsDoNotMatter) {
  const ScratchFolder out;
  const std::string command = binary("skein") + " run " + SKEIN_SOURCE_DIR + "/tests/data/small.yaml --domain " +
                              std::to_string(kDomain) + " --out " + out.path() + "/a <&- >&- 2>&-";
  EXPECT_EQ(run_program({"/bin/sh", "-c", command}, 60.0).exit_code, 0);
}

TEST(ByHand, AnAgentWaitsForItsFirstTickAsLongAsItsStartupTimeoutSays) {
  const Ended ended = run_program({binary("skein-agent"), "--id", "1", "--domain", std::to_string(kDomain), "--swarm",
                                   "by-hand-alone", "--startup-timeout", "0.4"},
                                  30.0);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_NE(ended.err.find("no tick of a world for 0.4 s"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace skein::e2e
