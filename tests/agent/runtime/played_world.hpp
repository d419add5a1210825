// An agent session whose world and peers are played by the test: agent 1 of the scenario tests/data/small.yaml, or of
// another one there.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "agent/runtime/agent_session.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein::test {

inline constexpr std::uint64_t kRun = 42;
inline constexpr std::uint64_t kNonce = 101;
inline constexpr std::uint64_t kPeerNonce = 102;

/// @param name of a file in tests/data
inline Mission small_mission(const std::string& name = "small") {
  ScenarioResult result = load_scenario(SKEIN_SOURCE_DIR "/tests/data/" + name + ".yaml", {}, std::nullopt);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(result).mission;
}

class FakeAgentPort final : public bus::AgentPort {
 public:
  void publish(const bus::AgentOutbound& sample) override { sent.push_back(sample); }
  void take(std::vector<bus::AgentInbound>& into) override {
    into.insert(into.end(), arrived.begin(), arrived.end());
    arrived.clear();
  }
  [[nodiscard]] std::vector<std::uint64_t> matched() const override { return sees; }

  std::vector<bus::AgentOutbound> sent;
  std::vector<bus::AgentInbound> arrived;
  std::vector<std::uint64_t> sees;
};

class PlayedWorld {
 public:
  explicit PlayedWorld(AgentId id = 1, Mission told = small_mission())
      : mission(std::move(told)), session(id, kNonce, port, 0.0) {}

  void at(double now_s) { session.poll(now_s); }
  template <typename Value>
  void say(const Value& value) {
    port.arrived.push_back(to_wire(value, {0, kRun}));
  }
  void say_mission(std::uint64_t run = kRun) { port.arrived.push_back(to_wire(mission, {0, run})); }

  /// A tick whose roster is agents 1 and 2, which counts agent 2's representative if asked.
  static Tick tick(std::uint32_t round, Phase phase, bool counts = false) {
    Tick tick;
    tick.run = kRun;
    tick.round = round;
    tick.phase = phase;
    if (round > 0) tick.roster = {{1, 1, kNonce, counts, phase == Phase::Flying}, {2, 1, kPeerNonce, counts, false}};
    return tick;
  }
  /// What agent 2 might publish in a round.
  static Representative peer(std::uint32_t round) {
    Representative sample;
    sample.run = kRun;
    sample.agent = 2;
    sample.incarnation = 1;
    sample.round = round;
    sample.particle = {9000.0, 9000.0};
    sample.cost = 9.0;
    sample.own_length_m = sample.path_length_m = 9100.0;
    return sample;
  }

  /// Admits the agent and lets it answer the first round, at time 0.
  void start() {
    say_mission();
    say(tick(1, Phase::Planning));
    at(0.0);
    EXPECT_EQ(session.state(), AgentSession::State::Live) << session.reason();
    EXPECT_EQ(session.round(), 1U);
    port.sent.clear();
  }

  /// The beacons published since the last call; representatives are in `samples`, obstacle maps in `maps` in the same
  /// way.
  std::vector<Beacon> take_beacons() {
    std::vector<Beacon> beacons;
    samples.clear();
    maps.clear();
    for (const auto& sample : port.sent) {
      if (const auto* beacon = std::get_if<wire::Beacon>(&sample)) {
        beacons.push_back(from_wire(*beacon, {}).value());
      } else if (const auto* map = std::get_if<wire::ObstacleMap>(&sample)) {
        maps.push_back(from_wire(*map, {}).value());
      } else {
        samples.push_back(from_wire(std::get<wire::Representative>(sample), {}).value());
      }
    }
    port.sent.clear();
    return beacons;
  }

  Mission mission;
  FakeAgentPort port;
  AgentSession session;
  std::vector<Representative> samples;
  std::vector<ObstacleMapSample> maps;
};

}  // namespace skein::test
