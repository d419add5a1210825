// What the ground station may ask of a swarm in flight, and what it may do to the world, as plain values.
//
// A command is an order with an id and a deadline. The world takes it when it decides a round, and the next tick says
// it to the agents: from that round on they obey, and acknowledge in that round's beacon. An injection acts on the
// world alone. Ids are random, and in no hash. Source: docs/steering.md. Departs from source: none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planner/core/geometry/types.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

/// To all agents, in Order::agent.
inline constexpr AgentId kAllAgents = 0;

enum class OrderKind : std::uint8_t {
  Start = 1,   ///< the mission starts, if the world waits for this
  Hold = 2,    ///< wait where you are
  Resume = 3,  ///< back to the mission
  Abort = 4,   ///< the run ends
  Land = 5,    ///< go down, and end the mission
  Goto = 6,    ///< fly to a point, and wait there
};

struct Order {
  std::uint64_t id = 0;
  AgentId agent = kAllAgents;
  OrderKind kind = OrderKind::Hold;
  Vec3 to_m = Vec3::Zero();  ///< of a Goto
  double speed_mps = 0.0;    ///< of a Goto; 0: the vehicle's own

  bool operator==(const Order&) const = default;
};

[[nodiscard]] inline bool concerns(const Order& order, AgentId agent) {
  return order.agent == kAllAgents || order.agent == agent;
}

enum class OrderResult : std::uint8_t {
  Accepted = 0,      ///< it took effect in the round that is said
  UnknownAgent = 1,  ///< the mission has no such vehicle
  NotLive = 2,       ///< the agent is lost, or has landed
  NotFlying = 3,     ///< the swarm is not in flight yet
  Ended = 4,         ///< the run is over
  Started = 5,       ///< the mission has started already
  NoLauncher = 6,    ///< nobody can act on the agent's process
  Expired = 7,       ///< its deadline passed before a round was decided
  Refused = 8,       ///< the mission cannot do that
};

/// What became of a command or an injection.
struct OrderAnswer {
  std::uint64_t id = 0;
  OrderResult result = OrderResult::Accepted;
  std::uint32_t round = 0;            ///< in which it took effect; 0: in none
  std::vector<AgentId> acknowledged;  ///< ascending, as far as it is known
  std::string text;                   ///< why it was refused, in one line

  bool operator==(const OrderAnswer&) const = default;
};

/// As it is sent to the world.
struct Command {
  std::uint64_t run = 0;
  Order order;
  double deadline_s = 0.0;  ///< after which it must not take effect any more

  bool operator==(const Command&) const = default;
};

enum class InjectionKind : std::uint8_t { Obstacle = 1, Pause = 2, Kill = 3, Restart = 4 };

struct Injection {
  std::uint64_t id = 0;
  InjectionKind kind = InjectionKind::Obstacle;
  AgentId agent = 0;                 ///< of a fault
  Vec3 position_m = Vec3::Zero();    ///< of an obstacle, and all that follows
  Vec3 velocity_mps = Vec3::Zero();  ///< zero: it never moves
  double radius_m = 0.0;
  bool column = false;  ///< upright, without ends; else a sphere

  bool operator==(const Injection&) const = default;
};

/// As it is sent to the world.
struct Inject {
  std::uint64_t run = 0;
  Injection injection;
  double deadline_s = 0.0;

  bool operator==(const Inject&) const = default;
};

/// An order or an injection, and the round from which on it has effect.
struct OrderedAt {
  std::uint32_t round = 0;
  Order order;

  bool operator==(const OrderedAt&) const = default;
};
struct InjectedAt {
  std::uint32_t round = 0;
  Injection injection;

  bool operator==(const InjectedAt&) const = default;
};

}  // namespace skein
