#include "groundstation/watch/swarm_map.hpp"

#include <gtest/gtest.h>

#include <array>

namespace skein::watch {
namespace {

MapTile tile_of(AgentId origin, std::uint32_t tile, std::uint32_t epoch, std::uint32_t n, CellState state) {
  MapTile out;
  out.origin = origin;
  out.tile = tile;
  out.epoch = epoch;
  out.version = 1;
  set_cell(out.cells, n, state);
  return out;
}

const CellGrid kGrid{Vec3::Zero(), 4.0, 4.0, 10, 10, 1};  // 2 x 2 tiles, which stick out

TEST(SwarmMap, JoinsWhatAgentsSay) {
  SwarmMap map(kGrid);
  map.merge(std::array{tile_of(1, 0, 0, 9, CellState::Free), tile_of(2, 0, 0, 9, CellState::Occupied),
                       tile_of(2, 1, 0, 0, CellState::Free)});
  const MappedCells cells = map.cells();
  EXPECT_EQ(cells.known, 2U);
  EXPECT_EQ(cells.states[kGrid.index_of({1, 1, 0})], CellState::Occupied);
  EXPECT_EQ(cells.states[kGrid.index_of({8, 0, 0})], CellState::Free);
  EXPECT_EQ(map.tiles_of(1), 1U);
  EXPECT_EQ(map.tiles_of(2), 2U);
  EXPECT_EQ(map.tiles_of(3), 0U);
}

TEST(SwarmMap, ALaterEpochFreesACell) {
  SwarmMap map(kGrid);
  map.merge(std::array{tile_of(1, 0, 1, 0, CellState::Free), tile_of(2, 0, 0, 0, CellState::Occupied)});
  EXPECT_EQ(map.cells().states[0], CellState::Free);
}

TEST(SwarmMap, LeavesOutWhatIsNotInTheArea) {
  SwarmMap map(kGrid);
  map.merge(std::array{tile_of(1, 99, 0, 0, CellState::Occupied), tile_of(1, 1, 0, 7, CellState::Occupied)});
  EXPECT_EQ(map.cells().known, 0U);
}

}  // namespace
}  // namespace skein::watch
