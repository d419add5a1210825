// Only a second vendor's DDS can prove it: what a swarm says on its topics can be read with Skein's IDL alone, every
// field of it, by Cyclone DDS; and one that listens so disturbs nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/groundstation/e2e/skein.hpp"

namespace skein::e2e {
namespace {

using nlohmann::json;
using ::testing::Each;
using ::testing::Gt;
using ::testing::IsSubsetOf;
using ::testing::SizeIs;

const std::string kDomain = "95";
const std::string kData = std::string(SKEIN_SOURCE_DIR) + "/tests/data/";

/// A sample as text: integers alike whether they were written as numbers or as texts, and without the stamp and the
/// time left to a command, which a sample that is said again has anew: each reader may hear another copy.
json comparable(const json& value) {
  if (value.is_number_integer()) return value.dump();
  if (!value.is_structured()) return value;
  json out = value.is_array() ? json::array() : json::object();
  for (const auto& [key, inside] : value.items()) {
    if (value.is_array()) {
      out.push_back(comparable(inside));
    } else if (key != "stamp_ns" && key != "deadline_s") {
      out[key] = comparable(inside);
    }
  }
  return out;
}

/// Samples by topic, of the lines of a dump or of the listener.
std::map<std::string, std::vector<json>> by_topic(const std::string& lines) {
  std::map<std::string, std::vector<json>> samples;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const json parsed = json::parse(line);
    samples[parsed.at("topic")].push_back(parsed.at("sample"));
  }
  return samples;
}

/// Whether it belongs to the run: not what is said before it starts, which the recorder may be too late for.
bool is_of_run(const std::string& topic, const json& sample) {
  if (topic == "skein/tick") return sample.at("round") != 0;
  return topic != "skein/beacon" || sample.at("head").at("incarnation") != 0;
}

std::set<std::string> comparable_texts(const std::string& topic, const std::vector<json>& samples) {
  std::set<std::string> texts;
  for (const json& sample : samples) {
    if (is_of_run(topic, sample)) texts.insert(comparable(sample).dump());
  }
  return texts;
}

std::set<json> values_of(const std::vector<json>& samples, const std::string& field) {
  std::set<json> values;
  for (const json& sample : samples) values.insert(sample.at(field));
  return values;
}

struct Heard {
  json report;
  std::map<std::string, std::vector<json>> by_cyclone;
  std::map<std::string, std::vector<json>> recorded;
};

/// A run that is recorded whole while Cyclone DDS listens. @param flags pace the run: a best-effort reader that joins
/// at its start needs a moment
Heard hear(const std::string& scenario, const std::string& swarm, const std::vector<std::string>& flags) {
  const ScratchFolder out;
  const std::string file = out.path() + "/run.mcap";
  Program listener({SKEIN_CYCLONE_LISTENER, kDomain, swarm});
  EXPECT_TRUE(listener.read_until("listening", 30.0));
  std::vector<std::string> more{"--swarm", swarm, "--record", file};
  more.insert(more.end(), flags.begin(), flags.end());
  const SkeinRun run = skein_run(kData + scenario, static_cast<unsigned>(std::stoul(kDomain)), out.path() + "/a", more);
  EXPECT_EQ(run.ended.exit_code, 0) << run.ended.err;
  const Ended ended = listener.wait(90.0);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Ended dump = run_program({binary("skein"), "dump", file}, 60.0);
  EXPECT_EQ(dump.exit_code, 0) << dump.err;
  return {run.report, by_topic(ended.out), by_topic(dump.out)};
}

/// Of each topic something was heard, and with all its fields it is what the recorder, which decodes the bytes itself,
/// has of this run.
void expect_as_recorded(const Heard& heard, const std::vector<std::string>& topics) {
  for (const std::string& topic : topics) {
    SCOPED_TRACE(topic);
    ASSERT_TRUE(heard.by_cyclone.contains(topic));
    ASSERT_TRUE(heard.recorded.contains(topic));
    const std::set<std::string> said = comparable_texts(topic, heard.recorded.at(topic));
    const std::set<std::string> decoded = comparable_texts(topic, heard.by_cyclone.at(topic));
    EXPECT_FALSE(decoded.empty());
    EXPECT_THAT(decoded, IsSubsetOf(said));
    for (const json& sample : heard.by_cyclone.at(topic)) {
      EXPECT_GT(sample.at("head").at("stamp_ns").get<std::int64_t>(), 0);
    }
  }
}

/// What both missions are known to say.
void expect_mission_and_end(const Heard& heard, const std::string& name) {
  const json& mission = heard.by_cyclone.at("skein/mission").front();
  EXPECT_EQ(mission.at("name"), name);
  EXPECT_EQ(mission.at("seed"), 7);
  EXPECT_EQ(mission.at("step_s"), 0.5);
  EXPECT_THAT(mission.at("vehicles"), SizeIs(2));
  const json& last = heard.by_cyclone.at("skein/tick").back();
  EXPECT_EQ(last.at("reason"), heard.report.at("reason"));
  EXPECT_EQ(last.at("exit_code"), 0);
  for (const char* topic : {"skein/sense", "skein/beacon"}) {
    EXPECT_EQ(values_of(heard.by_cyclone.at(topic), "agent"), (std::set<json>{1, 2})) << topic;
  }
}

TEST(Cyclone, DecodesEveryTopicOfARendezvous) {
  const Heard heard = hear("small.yaml", "cyclone-small", {"--realtime", "40", "--set", "planner.round_s=4"});
  expect_as_recorded(heard, {"skein/mission", "skein/tick", "skein/sense", "skein/beacon", "skein/representative"});
  expect_mission_and_end(heard, "small");
  const auto& representatives = heard.by_cyclone.at("skein/representative");
  EXPECT_EQ(values_of(representatives, "agent"), (std::set<json>{1, 2}));
  EXPECT_THAT(values_of(representatives, "own_length_m"), Each(Gt(json(8000.0))));
}

TEST(Cyclone, DecodesEveryTopicOfATransit) {
  const Heard heard = hear("small-transit.yaml", "cyclone-transit", {"--realtime", "2"});
  expect_as_recorded(heard, {"skein/mission", "skein/tick", "skein/sense", "skein/beacon", "skein/obstacle_map"});
  expect_mission_and_end(heard, "small-transit");
  const auto& maps = heard.by_cyclone.at("skein/obstacle_map");
  EXPECT_EQ(values_of(maps, "agent"), (std::set<json>{1, 2}));
  EXPECT_TRUE(std::ranges::any_of(maps, [](const json& map) { return !map.at("tiles").empty(); }));
}

std::vector<std::string> steering(const std::string& swarm, const std::vector<std::string>& words) {
  std::vector<std::string> all{binary("skein")};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--domain", kDomain, "--swarm", swarm, "--deadline", "60"});
  return all;
}

pid_t agent_of(const std::string& swarm) {
  const std::vector<pid_t> members = processes_with(swarm);
  for (const pid_t agent : processes_with(binary("skein-agent"))) {
    if (std::ranges::find(members, agent) != members.end()) return agent;
  }
  return -1;
}

TEST(Cyclone, DecodesWhatIsCommandedAndInjected) {
  const ScratchFolder out;
  const std::string swarm = "cyclone-steered";
  const std::string file = out.path() + "/run.mcap";
  Program listener({SKEIN_CYCLONE_LISTENER, kDomain, swarm});
  ASSERT_TRUE(listener.read_until("listening", 30.0));
  Program run({binary("skein"), "run", kData + "small.yaml", "--domain", kDomain, "--swarm", swarm, "--realtime", "10",
               "--set", "lockstep.deadline_s=60", "--record", file, "--out", out.path() + "/a", "--json"});
  ASSERT_TRUE(run.read_until("flight:", 60.0));
  // A round that waits for an agent keeps both verbs waiting, and repeating: else each is over before Cyclone finds it.
  const pid_t agent = agent_of(swarm);
  ASSERT_GT(agent, 0);
  ASSERT_EQ(kill(agent, SIGSTOP), 0);
  Program hold(steering(swarm, {"hold", "--agent", "2"}));
  Program inject(steering(swarm, {"inject", "obstacle", "sphere", "--at", "-5000.5", "-5000", "500", "--radius", "3",
                                  "--velocity", "-1", "0", "0.25"}));
  EXPECT_TRUE(listener.read_until("heard skein/command", 30.0));
  EXPECT_TRUE(listener.read_until("heard skein/inject", 30.0));
  ASSERT_EQ(kill(agent, SIGCONT), 0);
  EXPECT_EQ(hold.wait(60.0).exit_code, 0);
  EXPECT_EQ(inject.wait(60.0).exit_code, 0);
  EXPECT_EQ(run_program(steering(swarm, {"abort"}), 60.0).exit_code, 0);
  const Ended ended = run.wait(60.0);
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  const Ended said = listener.wait(90.0);
  EXPECT_EQ(said.exit_code, 0) << said.err;
  const Ended dump = run_program({binary("skein"), "dump", file}, 60.0);
  Heard heard{json::parse(ended.out, nullptr, false), by_topic(said.out), by_topic(dump.out)};
  // The abort is answered at once: who reads may find its writer too late, and the recorder has its tick.
  std::erase_if(heard.by_cyclone.at("skein/command"), [](const json& sample) { return sample.at("agent") == 0; });
  expect_as_recorded(heard, {"skein/command", "skein/inject"});
  EXPECT_EQ(heard.by_cyclone.at("skein/command").front().at("agent"), 2);
  const json& obstacle = heard.by_cyclone.at("skein/inject").front();
  for (const char* topic : {"skein/command", "skein/inject"}) {
    const json& sample = heard.by_cyclone.at(topic).front();
    EXPECT_GT(sample.at("deadline_s"), 0.0) << sample;
    EXPECT_LE(sample.at("deadline_s"), 60.0) << sample;
    for (const json& copy : heard.recorded.at(topic)) {
      const bool same = comparable(copy.at("head").at("stamp_ns")) == comparable(sample.at("head").at("stamp_ns"));
      if (same) {
        EXPECT_EQ(sample.at("deadline_s"), copy.at("deadline_s"));
      }
    }
  }
  EXPECT_EQ(obstacle.at("radius_m"), 3.0) << obstacle;
}

}  // namespace
}  // namespace skein::e2e
