// Which cells are really occupied: those whose interior a known or hidden obstacle, a no-fly zone or the ground meets.
//
// Computed once, obstacle by obstacle over the cells of its bounding box. Exact for boxes, cylinders and spheres; a
// terrain and a mesh are as simworld/collision/obstacle.hpp says. What reaches into a cell by less than a nanometre
// does not count, so that a wall which ends at a cell's edge leaves the next cell free.
// Sums over the cells below, behind and left of each answer how many of a block are occupied by inclusion and
// exclusion. Source: papers/004, section III-A and its Fig. 4; Crow 1984 for the sums. Departs from source: none.
// Complexity: O(cells + sum over obstacles of the cells of their bounding boxes); a query O(1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"
#include "planner/core/mission/mission.hpp"
#include "simworld/collision/obstacle.hpp"

namespace skein {

class TruthGrid {
 public:
  /// @throws std::invalid_argument for a grid without cells
  TruthGrid(const CellGrid& grid, std::span<const Obstacle> obstacles);

  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  [[nodiscard]] bool occupied(CellIndex cell) const { return occupied_[cell] != 0; }
  /// Outside the grid everything is occupied: nobody flies there.
  [[nodiscard]] bool occupied(const Cell& c) const { return !grid_.contains(c) || occupied(grid_.index_of(c)); }
  /// How many cells of the block that a and b span are occupied. @pre the grid contains both
  [[nodiscard]] std::uint32_t occupied_between(const Cell& a, const Cell& b) const;
  /// A move to one of the 26 neighbours through free cells alone, cutting no corner: every cell of the block that the
  /// two span is free. @pre `to` differs from `from` by at most 1 in each index
  [[nodiscard]] bool may_move(const Cell& from, const Cell& to) const;

 private:
  void add(const Obstacle& obstacle);
  void sum_up();
  /// How many of the cells below i, j and k in each index are occupied.
  [[nodiscard]] std::uint32_t below(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return sums_[place_of_sum(i, j, k)];
  }
  [[nodiscard]] std::size_t place_of_sum(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const std::int32_t place = (k * (grid_.ny + 1) + j) * (grid_.nx + 1) + i;
    return static_cast<std::size_t>(place);
  }

  CellGrid grid_;
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint32_t> sums_;
};

/// All that stands in the way of a mission, hidden or known: `hidden`, then the mission's zones and terrain.
[[nodiscard]] std::vector<Obstacle> all_obstacles(const Mission& mission, std::span<const Obstacle> hidden);

}  // namespace skein
