// The two ends of the bus, over any carrier: what an agent and what the world can send and take.
//
// A port carries wire structs and knows nothing of their meaning. Over DDS one process owns one port
// (idl/bus/dds_port.hpp); in one process the in-memory bus hands out ports that exchange the same structs
// (idl/bus/memory_bus.hpp). Order holds within a topic and sender, never across topics.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "idl/wire.hpp"

namespace skein::bus {

using AgentInbound = std::variant<wire::Mission, wire::Tick, wire::Sense, wire::Representative, wire::ObstacleMap>;
using AgentOutbound = std::variant<wire::Representative, wire::ObstacleMap, wire::Beacon>;
using WorldInbound = std::variant<wire::Beacon, wire::Representative, wire::ObstacleMap, wire::Command, wire::Inject>;
using WorldOutbound = std::variant<wire::Mission, wire::Tick, wire::Sense, wire::Representative, wire::ObstacleMap>;

/// For AgentPort::wake_after: no sample before the next tick.
inline constexpr std::size_t kOnTick = SIZE_MAX;

class AgentPort {
 public:
  virtual ~AgentPort() = default;
  virtual void publish(const AgentOutbound& sample) = 0;
  /// Moves everything that has arrived to the end of `into`; returns at once.
  virtual void take(std::vector<AgentInbound>& into) = 0;
  /// A hint to carriers that wake their owner: how many samples of sense and peers it lacks, those included that
  /// arrived since the last take(); fewer need not wake it. Ticks, missions and matches always do; 0: any sample does.
  virtual void wake_after(std::size_t /*samples*/) {}
  /// Nonces, ascending, of the processes (world and agents) whose endpoints are all matched with this port's.
  [[nodiscard]] virtual std::vector<std::uint64_t> matched() const = 0;
};

class WorldPort {
 public:
  virtual ~WorldPort() = default;
  virtual void publish(const WorldOutbound& sample) = 0;
  /// Moves everything that has arrived to the end of `into`; returns at once.
  virtual void take(std::vector<WorldInbound>& into) = 0;
  /// A hint to carriers that wake their owner: how many beacons it lacks, those included that arrived since the last
  /// take(); fewer, and what agents share, need not wake it. Matches always do; 0: any sample does.
  virtual void wake_after(std::size_t /*beacons*/) {}
  /// Nonces, ascending, of the agents whose endpoints are all matched with this port's.
  [[nodiscard]] virtual std::vector<std::uint64_t> matched() const = 0;
};

}  // namespace skein::bus
