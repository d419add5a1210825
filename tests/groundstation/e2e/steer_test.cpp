// An operator steers a swarm that others started: each verb is acknowledged or says why not, and a commanded run is
// repeated to the same state hash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string kDomain = "96";
const std::string kScenario = std::string(SKEIN_SOURCE_DIR) + "/tests/data/small.yaml";

std::vector<std::string> verb(const std::string& swarm, const std::vector<std::string>& words) {
  std::vector<std::string> all{binary("skein")};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--domain", kDomain, "--swarm", swarm, "--json"});
  return all;
}

json answer_to(const std::string& swarm, const std::vector<std::string>& words, int exit_code = 0) {
  const Ended ended = run_program(verb(swarm, words), 60.0);
  EXPECT_EQ(ended.exit_code, exit_code) << words.front() << ": " << ended.err;
  return json::parse(ended.out, nullptr, false);
}

/// A swarm, paced; of two agents if nothing else is said.
class Swarm {
 public:
  explicit Swarm(const std::string& swarm, const std::vector<std::string>& more = {},
                 const std::string& scenario = kScenario)
      : program_(words(swarm, more, scenario)) {}
  Program& program() { return program_; }
  [[nodiscard]] std::string file(const std::string& name) const { return out_.path() + "/" + name; }

 private:
  std::vector<std::string> words(const std::string& swarm, const std::vector<std::string>& more,
                                 const std::string& scenario) const {
    std::vector<std::string> all{binary("skein"), "run",   scenario,    "--domain", kDomain,          "--swarm",
                                 swarm,           "--out", out_.path(), "--record", file("run.mcap"), "--json"};
    if (scenario == kScenario) all.insert(all.end(), {"--realtime", "4"});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ScratchFolder out_;
  Program program_;
};

/// From its report, and from its recording.
void expect_repeated(const Swarm& swarm, const std::string& scenario, const json& report) {
  const ScratchFolder again;
  const Ended replay = run_program({binary("skein"), "run", scenario, "--in-process", "--roster",
                                    swarm.file("report.json"), "--out", again.path(), "--json"},
                                   60.0);
  EXPECT_EQ(json::parse(replay.out, nullptr, false).at("state_hash"), report.at("state_hash")) << replay.err;
  const Ended verify = run_program({binary("skein"), "verify", swarm.file("run.mcap"), "--rerun"}, 60.0);
  EXPECT_EQ(verify.exit_code, 0) << verify.out << verify.err;
}

TEST(Steer, EachVerbIsAcknowledgedAndTheRunIsRepeated) {
  Swarm pair("steer-pair", {"--wait-start"});
  const json early = answer_to("steer-pair", {"hold"}, 1);
  EXPECT_EQ(early.at("result"), "not_flying");
  const json start = answer_to("steer-pair", {"start", "--deadline", "30"});
  EXPECT_EQ(start.at("round"), 1);
  EXPECT_EQ(start.at("acknowledged"), (json{1, 2}));
  ASSERT_TRUE(pair.program().read_until("flight:", 60.0));
  EXPECT_EQ(answer_to("steer-pair", {"hold"}).at("acknowledged"), (json{1, 2}));
  EXPECT_EQ(answer_to("steer-pair", {"resume", "--agent", "2"}).at("acknowledged"), json::array({2}));
  EXPECT_EQ(answer_to("steer-pair", {"resume"}).at("acknowledged"), (json{1, 2}));
  const json injected = answer_to("steer-pair", {"inject", "obstacle", "sphere", "--at", "-5000", "-5000", "500",
                                                 "--radius", "3", "--velocity", "-1", "0", "0"});
  EXPECT_EQ(injected.at("result"), "accepted");
  EXPECT_EQ(injected.at("command"), "inject");
  EXPECT_EQ(answer_to("steer-pair", {"hold", "--agent", "7"}, 1).at("result"), "unknown_agent");
  EXPECT_EQ(answer_to("steer-pair", {"start"}, 1).at("result"), "started");
  EXPECT_EQ(answer_to("steer-pair", {"goto", "100", "-200", "0", "--agent", "1"}).at("acknowledged"), json::array({1}));
  EXPECT_EQ(answer_to("steer-pair", {"land", "--agent", "1"}).at("acknowledged"), json::array({1}));
  EXPECT_EQ(answer_to("steer-pair", {"abort"}).at("result"), "accepted");
  const Ended ended = pair.program().wait(60.0);
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  const json report = json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << ended.out;
  EXPECT_EQ(report.at("reason"), "aborted by command");
  EXPECT_EQ(report.at("commands").size(), 7U);
  EXPECT_EQ(report.at("injections").size(), 1U);

  expect_repeated(pair, kScenario, report);
}

TEST(Steer, ATransitByCellsObeysEachVerb) {
  const std::string swarm = "steer-cells";
  const std::string scenario = std::string(SKEIN_SOURCE_DIR) + "/deploy/scenarios/transit-partition.yaml";
  Swarm six(swarm, {"--wait-start", "--realtime", "1"}, scenario);
  EXPECT_EQ(answer_to(swarm, {"start", "--deadline", "30"}).at("acknowledged"), (json{1, 2, 3, 4, 5, 6}));
  ASSERT_TRUE(six.program().read_until("flight:", 60.0));
  EXPECT_EQ(answer_to(swarm, {"hold"}).at("acknowledged"), (json{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(answer_to(swarm, {"goto", "40", "50", "6", "--agent", "1"}).at("acknowledged"), json::array({1}));
  const Ended outside = run_program(verb(swarm, {"goto", "40", "90", "6", "--agent", "1"}), 60.0);
  EXPECT_EQ(outside.exit_code, 1);
  EXPECT_THAT(outside.err, HasSubstr("outside the area"));
  EXPECT_EQ(answer_to(swarm, {"land", "--agent", "3"}).at("acknowledged"), json::array({3}));
  EXPECT_EQ(answer_to(swarm, {"hold", "--agent", "3"}, 1).at("result"), "not_live");
  EXPECT_EQ(answer_to(swarm, {"resume", "--agent", "5"}).at("acknowledged"), json::array({5}));
  EXPECT_EQ(answer_to(swarm, {"resume"}).at("result"), "accepted");
  EXPECT_EQ(answer_to(swarm, {"abort"}).at("result"), "accepted");
  const Ended ended = six.program().wait(60.0);
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  const json report = json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(report.is_object()) << ended.out;
  EXPECT_EQ(report.at("reason"), "aborted by command");
  EXPECT_EQ(report.at("commands").size(), 7U);
  EXPECT_EQ(report.at("collisions"), 0);
  expect_repeated(six, scenario, report);
}

TEST(Steer, AStoppedAgentDoesNotAcknowledge) {
  Swarm pair("steer-stopped");
  ASSERT_TRUE(pair.program().read_until("flight:", 60.0));
  EXPECT_EQ(answer_to("steer-stopped", {"pause", "--agent", "2"}).at("result"), "accepted");
  const Ended held = run_program(verb("steer-stopped", {"hold", "--deadline", "2"}), 60.0);
  EXPECT_EQ(held.exit_code, 1);
  EXPECT_THAT(held.err, HasSubstr("skein hold: not "));
  EXPECT_EQ(answer_to("steer-stopped", {"kill", "--agent", "2", "--deadline", "30"}).at("result"), "accepted");
  EXPECT_EQ(answer_to("steer-stopped", {"abort", "--deadline", "30"}).at("result"), "accepted");
  EXPECT_EQ(pair.program().wait(60.0).exit_code, 4);
}

TEST(Steer, WithoutASwarmItSaysSo) {
  const Ended ended = run_program(verb("steer-nobody", {"hold", "--startup-timeout", "1"}), 30.0);
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("no world of swarm steer-nobody"));
  EXPECT_EQ(run_program({binary("skein"), "goto", "1", "2"}, 30.0).exit_code, 2);
  EXPECT_EQ(run_program({binary("skein"), "inject", "obstacle", "cube", "--at", "1", "2", "3", "--radius", "1"}, 30.0)
                .exit_code,
            2);
}

}  // namespace
}  // namespace skein::e2e
