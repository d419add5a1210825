// Scripts learn from `skein status` and `skein topics` what a swarm that others started is doing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using ::testing::HasSubstr;

const std::string kDomain = "94";
const std::string kScenario = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

/// Two agents that fly for a while.
class Pair {
 public:
  Pair(const std::string& swarm, const std::string& realtime)
      : program_({binary("skein"), "run", kScenario, "--realtime", realtime, "--domain", kDomain, "--swarm", swarm,
                  "--out", out_.path()}) {}
  [[nodiscard]] bool flies() { return program_.read_until("flight:", 60.0); }
  Program& program() { return program_; }

 private:
  ScratchFolder out_;
  Program program_;
};

std::vector<std::string> ask(const std::string& verb, const std::vector<std::string>& more) {
  std::vector<std::string> words{binary("skein"), verb, "--domain", kDomain};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Observe, StatusHasTheFiguresOfTheDomainsOnlySwarm) {
  Pair pair("observe-pair", "1");
  ASSERT_TRUE(pair.flies());
  const Ended ended = run_program(ask("status", {"--json"}), 60.0);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto status = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(status.is_object()) << ended.out;
  EXPECT_EQ(status.at("swarm"), "observe-pair");
  EXPECT_EQ(status.at("scenario"), "small");
  EXPECT_EQ(status.at("phase"), "flying");
  EXPECT_EQ(status.at("live"), 2);
  ASSERT_EQ(status.at("agents").size(), 2U);
  for (const auto& agent : status.at("agents")) {
    EXPECT_EQ(agent.at("mode"), "flying");
    EXPECT_GT(agent.at("speed_mps").get<double>(), 0.0);
    EXPECT_GT(agent.at("to_go_m").get<double>(), 0.0);
    EXPECT_GT(agent.at("separation_m").get<double>(), 0.0);
    EXPECT_GT(agent.at("bytes_per_s").get<double>(), 0.0);
  }
  const Ended text = run_program(ask("status", {"--swarm", "observe-pair"}), 60.0);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("swarm observe-pair, small (seed 7): flying"));
}

TEST(Observe, TopicsHaveRatesAndWriters) {
  Pair pair("observe-topics", "1");
  ASSERT_TRUE(pair.flies());
  const Ended ended = run_program(ask("topics", {"--json", "--swarm", "observe-topics"}), 60.0);
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto topics = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(topics.is_object()) << ended.out;
  const auto named = [&](const std::string& name) {
    return *std::ranges::find_if(topics.at("topics"), [&](const auto& topic) { return topic.at("name") == name; });
  };
  EXPECT_EQ(named("skein/tick").at("writers"), 1);
  EXPECT_EQ(named("skein/beacon").at("writers"), 2);
  EXPECT_EQ(named("skein/sense").at("writers"), 2);
  EXPECT_EQ(named("skein/mission").at("samples"), 1);
  EXPECT_GT(named("skein/beacon").at("bytes_per_s").get<double>(), 0.0);
  EXPECT_GT(named("skein/beacon").at("samples").get<int>(), named("skein/tick").at("samples").get<int>());
}

TEST(Observe, WatchingEndsWithTheRunAndItsExitCode) {
  Pair pair("observe-watch", "30");
  Program watcher(
      ask("status", {"--json", "--watch", "--interval", "0.2", "--swarm", "observe-watch", "--startup-timeout", "30"}));
  EXPECT_EQ(pair.program().wait(120.0).exit_code, 0);
  const Ended ended = watcher.wait(60.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  std::istringstream lines(ended.out);
  std::string line;
  nlohmann::json last;
  while (std::getline(lines, line)) {
    last = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(last.is_object()) << line;
  }
  ASSERT_TRUE(last.is_object()) << ended.out;
  EXPECT_EQ(last.at("phase"), "finished");
  EXPECT_EQ(last.at("outcome").at("exit_code"), 0);
  EXPECT_EQ(last.at("outcome").at("reason"), "all vehicles arrived in formation");
}

TEST(Observe, WithoutASwarmThereIsOneLineAndExitCode3) {
  for (const std::string verb : {"status", "topics"}) {
    const Ended nobody = run_program(ask(verb, {"--startup-timeout", "0.3"}), 30.0);
    EXPECT_EQ(nobody.exit_code, 3) << nobody.err;
    EXPECT_EQ(nobody.err, "skein " + verb + ": no swarm in domain 94 within 0.3 s\n");
    const Ended named = run_program(ask(verb, {"--startup-timeout", "0.3", "--swarm", "geese"}), 30.0);
    EXPECT_EQ(named.exit_code, 3) << named.err;
    EXPECT_EQ(named.err, "skein " + verb + ": no world of swarm geese in domain 94 within 0.3 s\n");
    EXPECT_TRUE(named.out.empty());
  }
}

TEST(Observe, BadFlagsGiveOneLineAndExitCode2) {
  for (const std::vector<std::string>& flags :
       std::vector<std::vector<std::string>>{{"--interval", "1"}, {"--swarm", "a*b"}, {"--watch", "--interval", "0"}}) {
    const Ended ended = run_program(ask("status", flags), 30.0);
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_EQ(std::ranges::count(ended.err, '\n'), 1) << ended.err;
  }
}

}  // namespace
}  // namespace skein::e2e
