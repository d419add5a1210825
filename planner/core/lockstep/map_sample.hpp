// What agents of a transit put on air: their intent for the next decision, and tiles of their obstacle maps.
//
// Source: papers/004, section IV-B2 (maps of 2 bits a cell); docs/architecture.md for version vectors and tiles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"
#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

enum class NavStatus : std::uint8_t {
  Flying = 1,
  Arrived = 2,      ///< within goal_radius_m of its goal: it lands, and is no obstacle
  Unreachable = 3,  ///< no way to its goal through cells not known to be blocked; hovers and gives way
  Deadlock = 4,     ///< no way past the others, in bounded time
  Held = 5,         ///< by command: stays where it is, and gives way to nobody
};

/// What a UAV says in one decision of what it will do in the next: right of way follows from these alone.
struct Intent {
  std::uint32_t decision = 0;  ///< the decision for which it stands, from 1
  Vec3 from_m = Vec3::Zero();  ///< where that motion starts: where its sender is then, so that it is not sent
  Vec3 to_m = Vec3::Zero();    ///< where it ends, if nothing with right of way is in its way
  std::uint32_t waited = 0;    ///< decisions without progress, or what the rule makes of them
  double to_go_m = 0.0;        ///< along its field; infinite is sent as a negative number
  NavStatus status = NavStatus::Flying;
  AgentId asks = 0;                       ///< the UAV that stands in its way and must move aside; 0: nobody
  AgentId on_behalf_of = 0;               ///< whose right of way it inherits; its own id if nobody's
  std::array<CellIndex, 4> next_cells{};  ///< the first cells of its way from `to_m`; the last one repeated

  bool operator==(const Intent&) const = default;
};

/// 8 x 8 cells of one level, as one agent contributed them to the swarm's map. 2 bits a cell, cell n of the tile (row
/// by row) in bits 2n of the words.
struct MapTile {
  AgentId origin = 0;  ///< whose contribution it is, whoever sends it
  std::uint32_t tile = 0;
  std::uint32_t epoch = 0;
  std::uint32_t version = 0;  ///< of the tile in its origin's log
  std::array<std::uint64_t, 2> cells{};

  bool operator==(const MapTile&) const = default;
};

/// How far the sender holds an agent's log: every tile whose newest version is at most `version`.
struct Seen {
  AgentId agent = 0;
  std::uint32_t version = 0;
  std::uint64_t digest = 0;  ///< of (tile, version) of all that the sender holds of that log up to `version`

  bool operator==(const Seen&) const = default;
};

struct ObstacleMapSample {
  std::uint64_t run = 0;
  AgentId agent = 0;
  std::uint32_t incarnation = 0;
  std::uint32_t round = 0;
  Intent intent;
  std::vector<Seen> seen;  ///< version vector by ascending agent, or a part of it
  std::vector<MapTile> tiles;

  bool operator==(const ObstacleMapSample&) const = default;
};

/// Of everything in a sample but who sent it and when.
inline void add_to(StateHash& hash, const ObstacleMapSample& sample) {
  const Intent& intent = sample.intent;
  hash.add(intent.decision).add(intent.from_m).add(intent.to_m).add(intent.waited).add(intent.to_go_m);
  hash.add(intent.status).add(intent.asks).add(intent.on_behalf_of);
  for (const CellIndex cell : intent.next_cells) hash.add(cell);
  hash.add(sample.seen.size());
  for (const Seen& seen : sample.seen) hash.add(seen.agent).add(seen.version).add(seen.digest);
  hash.add(sample.tiles.size());
  for (const MapTile& tile : sample.tiles) {
    hash.add(tile.origin).add(tile.tile).add(tile.epoch).add(tile.version).add(tile.cells[0]).add(tile.cells[1]);
  }
}

// What a sample may hold at most: within one datagram.
inline constexpr std::size_t kMaxSeen = kMaxAgents;
inline constexpr std::size_t kMaxMapTiles = 1024;
/// Of an intent: more counts as much.
inline constexpr std::uint32_t kMaxWaited = 65535;
/// The last epoch of a tile: 65535 times a cell of it became free. After that obstacles in it stay.
inline constexpr std::uint32_t kMaxEpoch = 65535;

/// CDR bytes of a sample without serialising it (tests hold it to the wire); without tiles and vector its control part.
inline constexpr std::size_t kControlBytes = 100;
inline constexpr std::size_t kSeenBytes = 16;
inline constexpr std::size_t kMapTileBytes = 28;
[[nodiscard]] constexpr std::size_t payload_bytes(std::size_t n_tiles, std::size_t n_seen) {
  return kControlBytes + kSeenBytes * n_seen + kMapTileBytes * n_tiles;
}

}  // namespace skein
