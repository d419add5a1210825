// Samples made by hand for the tests of the lockstep protocol: agent K has nonce 100 + K, the world has nonce 7.
#pragma once

#include <utility>
#include <vector>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein::test {

inline constexpr std::uint64_t kRun = 42;
inline constexpr std::uint64_t kWorldNonce = 7;

constexpr std::uint64_t nonce_of(AgentId id) {
  return 100 + id;
}

/// An introduction that says `matched` of its peers.
inline Beacon introduction(AgentId id, std::vector<std::uint64_t> matched, std::uint64_t nonce = 0) {
  Beacon beacon;
  beacon.run = kRun;
  beacon.agent = id;
  beacon.nonce = nonce == 0 ? nonce_of(id) : nonce;
  beacon.matched = std::move(matched);
  return beacon;
}

/// The beacon that closes a round.
inline Beacon closing(AgentId id, std::uint32_t round, AgentMode mode = AgentMode::Planning) {
  Beacon beacon;
  beacon.run = kRun;
  beacon.agent = id;
  beacon.incarnation = 1;
  beacon.nonce = nonce_of(id);
  beacon.round = round;
  beacon.closes_round = true;
  beacon.mode = mode;
  beacon.commanded_velocity_mps = Vec3(10.0, 0.0, 0.0);
  beacon.planned_length_m = 1000.0 + id;
  beacon.state_hash = 5000 + id;
  return beacon;
}

inline Representative representative(AgentId id, std::uint32_t round) {
  Representative sample;
  sample.run = kRun;
  sample.agent = id;
  sample.incarnation = 1;
  sample.round = round;
  sample.particle = {1.0 * id, 2.0};
  sample.own_length_m = sample.path_length_m = 900.0 + id;
  return sample;
}

/// An intent for the next decision, and the agent's own first contribution to `tiles` tiles.
inline ObstacleMapSample map_sample(AgentId id, std::uint32_t round, std::uint32_t tiles = 1) {
  ObstacleMapSample sample;
  sample.run = kRun;
  sample.agent = id;
  sample.incarnation = 1;
  sample.round = round;
  sample.intent.decision = round;
  sample.intent.on_behalf_of = id;
  for (std::uint32_t tile = 0; tile < tiles; ++tile) sample.tiles.push_back({id, tile, 0, tile + 1, {3, 0}});
  return sample;
}

inline std::vector<RosterEntry> roster_of(AgentId count) {
  std::vector<RosterEntry> roster;
  for (AgentId id = 1; id <= count; ++id) roster.push_back({id, 1, nonce_of(id), false, false});
  return roster;
}

/// A planning tick of the first `count` agents.
inline Tick tick_of(std::uint32_t round, AgentId count, Phase phase = Phase::Planning) {
  Tick tick;
  tick.run = kRun;
  tick.round = round;
  tick.phase = phase;
  tick.roster = roster_of(count);
  return tick;
}

}  // namespace skein::test
