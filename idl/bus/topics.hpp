// The topics of the bus: the one table with their names, types, QoS, writers and readers (docs/wire.md).
//
// Every topic is reliable, KEEP_LAST and bounded; only the mission is latched. Which endpoints two processes must have
// matched follows from this table too: one for each topic that one of them writes and the other reads.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace skein::bus {

/// Who a process is. Observers have no part in a run; a process without USER_DATA is one.
enum class Role : std::uint8_t { Observer = 0, World = 1, Agent = 2 };

[[nodiscard]] constexpr std::uint8_t role_bit(Role role) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(role));
}

enum class TopicId : std::uint8_t {
  Mission = 0,
  Tick = 1,
  Sense = 2,
  Beacon = 3,
  Representative = 4,
  ObstacleMap = 5,
  Command = 6,
  Inject = 7
};

struct TopicSpec {
  TopicId id;
  std::string_view name;
  std::string_view type;  ///< name of the type on the wire; carries the wire version
  bool keyed;             ///< one instance per `agent`
  bool latched;           ///< transient local: late joiners get the last sample; otherwise volatile
  std::int32_t depth;     ///< samples kept of each instance
  bool per_agent;         ///< partition `<swarm>/<last part of name>/K`, one writer per agent K; otherwise `<swarm>`
  double heartbeat_s;     ///< period of a writer's heartbeats while readers owe it an acknowledgement
  std::uint8_t writers;   ///< role_bit()s
  std::uint8_t readers;   ///< role_bit()s
};

inline constexpr double kHeartbeat_s = 0.05;
/// Of the topics that all agents write to all: N^2 heartbeats a period, which at 25 agents and 50 ms are as many as
/// the samples. A lost one is repaired later for it.
inline constexpr double kSlowHeartbeat_s = 0.2;

inline constexpr std::uint8_t kWorldRole = role_bit(Role::World);
inline constexpr std::uint8_t kAgentRole = role_bit(Role::Agent);
inline constexpr std::uint8_t kObserverRole = role_bit(Role::Observer);

inline constexpr std::array<TopicSpec, 8> kTopics{{
    {TopicId::Mission, "skein/mission", "skein::v7::Mission", false, true, 1, false, kHeartbeat_s, kWorldRole,
     kAgentRole | kObserverRole},
    {TopicId::Tick, "skein/tick", "skein::v7::Tick", false, false, 16, false, kHeartbeat_s, kWorldRole,
     kAgentRole | kObserverRole},
    {TopicId::Sense, "skein/sense", "skein::v7::Sense", true, false, 16, true, kHeartbeat_s, kWorldRole, kAgentRole},
    {TopicId::Beacon, "skein/beacon", "skein::v7::Beacon", true, false, 16, false, kHeartbeat_s, kAgentRole,
     kWorldRole | kObserverRole},
    {TopicId::Representative, "skein/representative", "skein::v7::Representative", true, false, 16, false,
     kSlowHeartbeat_s, kAgentRole | kWorldRole, kAgentRole | kWorldRole},
    {TopicId::ObstacleMap, "skein/obstacle_map", "skein::v7::ObstacleMap", true, false, 16, false, kSlowHeartbeat_s,
     kAgentRole | kWorldRole, kAgentRole | kWorldRole},
    {TopicId::Command, "skein/command", "skein::v7::Command", false, false, 16, false, kHeartbeat_s, kObserverRole,
     kWorldRole},
    {TopicId::Inject, "skein/inject", "skein::v7::Inject", false, false, 16, false, kHeartbeat_s, kObserverRole,
     kWorldRole},
}};

[[nodiscard]] constexpr const TopicSpec& topic(TopicId id) {
  return kTopics[static_cast<std::size_t>(id)];
}

/// An endpoint of this process, as a bit: its writer or its reader of a topic.
[[nodiscard]] constexpr std::uint16_t endpoint_bit(TopicId id, bool writes) {
  return static_cast<std::uint16_t>(1U << (2U * static_cast<unsigned>(id) + (writes ? 1U : 0U)));
}

/// The endpoints of a process in role `own` that must be matched with those of a process in role `peer`.
[[nodiscard]] constexpr std::uint16_t expected_matches(Role own, Role peer) {
  std::uint16_t bits = 0;
  for (const TopicSpec& spec : kTopics) {
    const bool out = (spec.writers & role_bit(own)) != 0 && (spec.readers & role_bit(peer)) != 0;
    const bool in = (spec.readers & role_bit(own)) != 0 && (spec.writers & role_bit(peer)) != 0;
    if (out) bits = static_cast<std::uint16_t>(bits | endpoint_bit(spec.id, true));
    if (in) bits = static_cast<std::uint16_t>(bits | endpoint_bit(spec.id, false));
  }
  return bits;
}

}  // namespace skein::bus
