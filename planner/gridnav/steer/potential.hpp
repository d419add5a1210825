// Potentials of papers/004: the goal attracts, obstacles repel within the cells around them.
//
//   Eq. 1: goal(c) = |c - g|, in cells;  Eq. 2: alpha in an obstacle's cell, alpha / 2 in the cells around it
// Overlapping alpha / 2 fields count once (maximum): summed, narrow passages close.
// Source: papers/004, Eq. 1 and 2. Departs from source: in space distances use real edges, in units of the base edge.
// Complexity: O(1), 9 or 27 look-ups.
#pragma once

#include "planner/gridnav/map/known_map.hpp"

namespace skein::gridnav {

/// Eq. 1 of a cell, in base edges.
[[nodiscard]] inline double goal_potential(const CellGrid& grid, const Cell& c, const Cell& goal) {
  const double h = grid.height_m / grid.cell_m;
  const double x = c.i - goal.i, y = c.j - goal.j, z = (c.k - goal.k) * h;
  return std::sqrt(x * x + y * y + z * z);
}

/// Whether an obstacle is known in one of the cells around c.
[[nodiscard]] inline bool beside_obstacle(const KnownMap& map, const Cell& c) {
  const CellGrid& grid = map.grid();
  const std::int32_t up = map.planar() ? 0 : 1;
  for (std::int32_t k = c.k - up; k <= c.k + up; ++k)
    for (std::int32_t j = c.j - 1; j <= c.j + 1; ++j)
      for (std::int32_t i = c.i - 1; i <= c.i + 1; ++i) {
        const Cell n{i, j, k};
        if (grid.contains(n) && map.state(grid.index_of(n)) == CellState::Occupied) return true;
      }
  return false;
}

}  // namespace skein::gridnav
