// The swarm's obstacle map as an observer can put it together from what agents put on air.
//
// The same join of tiles as in the agents, of every tile that anybody sent since the observer came; what was sent
// before is missing. Source: planner/core/obstacle_map/tile.hpp. Departs from source: no logs and no vectors, for an
// observer sends nothing. Complexity: O(1) a tile, O(cells) a picture.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "groundstation/watch/view.hpp"
#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/obstacle_map/tile.hpp"

namespace skein::watch {

class SwarmMap {
 public:
  explicit SwarmMap(const CellGrid& grid) : tiles_(grid), states_(tiles_.size()) {}

  /// Tiles that are not in the grid are left out.
  void merge(std::span<const MapTile> tiles);
  [[nodiscard]] const CellGrid& grid() const { return tiles_.cells; }
  [[nodiscard]] MappedCells cells() const;
  /// Of how many tiles a contribution of this agent was seen.
  [[nodiscard]] std::size_t tiles_of(AgentId origin) const;

 private:
  TileGrid tiles_;
  std::vector<TileState> states_;                     ///< by tile
  std::map<AgentId, std::vector<bool>> contributed_;  ///< by origin, by tile
};

}  // namespace skein::watch
