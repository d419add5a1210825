// Waiting for a condition on the bus: polls the ports' descriptors with a deadline, never sleeps.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <vector>

#include "idl/bus/dds_port.hpp"
#include "tests/idl/convert/examples.hpp"

namespace skein::bus::testing {

inline constexpr std::uint32_t kDomain = 11;
inline constexpr std::chrono::seconds kPatience(30);

/// A swarm that no other test, nor this test run again, is in.
inline std::string unique_swarm(const std::string& name) {
  return name + "-" + std::to_string(::getpid());
}

/// True as soon as `holds()` is; false if it is not within `patience`. Looks again whenever a descriptor is readable,
/// and every 20 ms, since a condition may depend on another process.
template <typename Condition>
bool eventually(const std::vector<int>& descriptors, Condition holds, std::chrono::milliseconds patience = kPatience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  std::vector<pollfd> polled;
  for (const int fd : descriptors) polled.push_back({fd, POLLIN, 0});
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    ::poll(polled.data(), polled.size(), 20);
  }
  return true;
}

/// Everything that has arrived at a port so far.
template <typename Port, typename Inbound>
struct Collected {
  Port& port;
  std::vector<Inbound> samples{};

  template <typename Sample>
  std::vector<Sample> all() {
    port.take(samples);
    std::vector<Sample> found;
    for (const Inbound& sample : samples) {
      if (const auto* held = std::get_if<Sample>(&sample)) found.push_back(*held);
    }
    return found;
  }
};
using AtAgent = Collected<DdsAgentPort, AgentInbound>;
using AtWorld = Collected<DdsWorldPort, WorldInbound>;

inline wire::Tick tick(std::uint32_t round, Phase phase = Phase::Planning) {
  Tick t = examples::tick();
  t.round = round;
  t.phase = phase;
  return to_wire(t, examples::kStamp);
}

inline wire::Sense sense(AgentId agent) {
  Sense s = examples::sense();
  s.agent = agent;
  return to_wire(s, examples::kStamp);
}

inline wire::Representative representative(AgentId agent) {
  Representative r = examples::representative();
  r.agent = agent;
  return to_wire(r, examples::kStamp);
}

inline wire::ObstacleMap obstacle_map(AgentId agent) {
  ObstacleMapSample m = examples::obstacle_map();
  m.agent = agent;
  return to_wire(m, examples::kStamp);
}

inline wire::Beacon beacon(AgentId agent, std::uint32_t round) {
  Beacon b = examples::beacon();
  b.agent = agent;
  b.round = round;
  return to_wire(b, examples::kStamp);
}

}  // namespace skein::bus::testing
