#include "groundstation/watch/swarm_map.hpp"

#include <algorithm>

namespace skein::watch {

void SwarmMap::merge(std::span<const MapTile> tiles) {
  for (const MapTile& tile : tiles) {
    if (tile.tile >= states_.size()) continue;
    states_[tile.tile] = join(states_[tile.tile], TileState{tile.epoch, tile.cells});
    std::vector<bool>& seen = contributed_[tile.origin];
    seen.resize(states_.size());
    seen[tile.tile] = true;
  }
}

MappedCells SwarmMap::cells() const {
  MappedCells cells{tiles_.cells, std::vector<CellState>(tiles_.cells.size(), CellState::Unknown), 0};
  for (std::uint32_t tile = 0; tile < states_.size(); ++tile) {
    if (known_cells(states_[tile].cells) == 0) continue;
    for (std::uint32_t n = 0; n < kTileEdge * kTileEdge; ++n) {
      const CellState state = cell_in(states_[tile].cells, n);
      const Cell cell = tiles_.cell_at({tile, n});
      if (state == CellState::Unknown || !tiles_.cells.contains(cell)) continue;
      cells.states[tiles_.cells.index_of(cell)] = state;
      ++cells.known;
    }
  }
  return cells;
}

std::size_t SwarmMap::tiles_of(AgentId origin) const {
  const auto known = contributed_.find(origin);
  return known == contributed_.end() ? 0 : static_cast<std::size_t>(std::ranges::count(known->second, true));
}

}  // namespace skein::watch
