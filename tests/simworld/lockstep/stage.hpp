// A world session on a stage: a port whose agents are played by the test, and a clock that the test turns.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "simworld/lockstep/world_session.hpp"
#include "tests/simworld/lockstep/samples.hpp"
#include "tests/simworld/missions.hpp"

namespace skein::test {

class FakeWorldPort final : public bus::WorldPort {
 public:
  void publish(const bus::WorldOutbound& sample) override { sent.push_back(sample); }
  void take(std::vector<bus::WorldInbound>& into) override {
    into.insert(into.end(), arrived.begin(), arrived.end());
    arrived.clear();
  }
  [[nodiscard]] std::vector<std::uint64_t> matched() const override { return sees; }

  std::vector<bus::WorldOutbound> sent;
  std::vector<bus::WorldInbound> arrived;
  std::vector<std::uint64_t> sees;
};

/// Notes what it was asked to do; the test says what came of it.
class FakeControl final : public ProcessControl {
 public:
  void kill(AgentId agent) override { killed.push_back(agent); }
  void stop(AgentId agent) override { stopped.push_back(agent); }
  void cont(AgentId agent) override { continued.push_back(agent); }
  void restart(AgentId agent) override { restarted.push_back(agent); }
  std::vector<AgentId> killed, stopped, continued, restarted;
};

class Stage {
 public:
  explicit Stage(AgentId count, SessionOptions options = {}, ProcessControl* control = nullptr)
      : Stage(scenario(count), std::move(options), control) {}
  /// @pre the vehicles are 1 to their count
  explicit Stage(const Scenario& scenario, SessionOptions options = {}, ProcessControl* control = nullptr)
      : count_(static_cast<AgentId>(scenario.mission.vehicles.size())),
        session(scenario, with_ids(std::move(options)), port, control, 0.0) {}

  /// Everything of one kind that was published since the last call.
  template <typename Wire>
  std::vector<Wire> take_sent() {
    std::vector<Wire> samples;
    for (const auto& sample : port.sent) {
      if (const auto* typed = std::get_if<Wire>(&sample)) samples.push_back(*typed);
    }
    port.sent.clear();
    return samples;
  }
  std::vector<Tick> take_ticks() {
    std::vector<Tick> ticks;
    for (const wire::Tick& sample : take_sent<wire::Tick>()) ticks.push_back(from_wire(sample, {}).value());
    return ticks;
  }

  void at(double time_s) { session.poll(now_s = time_s); }
  /// Polls every half second until `time_s`, as a process does.
  void until(double time_s) {
    while (now_s + 0.5 < time_s) at(now_s + 0.5);
    at(time_s);
  }
  template <typename Value>
  void say(const Value& value) {
    port.arrived.push_back(to_wire(value, {}));
  }
  void introduce(AgentId id) { say(introduction(id, all())); }
  /// All introduce themselves, and the first round is open. @return its tick
  Tick start() {
    port.sees = all();
    for (AgentId id = 1; id <= count_; ++id) introduce(id);
    at(now_s);
    return last_tick();
  }
  Tick last_tick() {
    const auto ticks = take_ticks();
    EXPECT_FALSE(ticks.empty());
    return ticks.empty() ? Tick{} : ticks.back();
  }
  /// All agents of the tick answer it. @return the next tick
  Tick round(const Tick& tick, AgentMode mode) {
    for (const RosterEntry& entry : tick.roster) say(closing(entry.agent, tick.round, mode));
    at(now_s);
    return last_tick();
  }

 private:
  static Scenario scenario(AgentId count) {
    Scenario scenario;
    scenario.mission = abreast(count);
    return scenario;
  }
  static SessionOptions with_ids(SessionOptions options) {
    options.run = kRun;
    options.nonce = kWorldNonce;
    return options;
  }
  [[nodiscard]] std::vector<std::uint64_t> all() const {
    std::vector<std::uint64_t> nonces{kWorldNonce};
    for (AgentId id = 1; id <= count_; ++id) nonces.push_back(nonce_of(id));
    return nonces;
  }

  AgentId count_;

 public:
  FakeWorldPort port;
  double now_s = 0.0;
  WorldSession session;
};

}  // namespace skein::test
