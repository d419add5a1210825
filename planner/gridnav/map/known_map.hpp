// What one UAV knows of the cells, and whether a body can move in a straight line through them.
//
// A body of radius r that flies from a to b sweeps the points within r of the segment (a capsule; in a plane its
// footprint). The motion is clear if every cell that the sweep enters is good enough: not known as occupied, when
// planning, or seen and free, before flying. Cells are tested by the exact distance of segment and box, never at
// sample points; what lies outside the grid is never clear.
// Source: papers/004, section III-B and C (matrix obs). Departs from source: continuous sweep.
// Complexity: O(cells near the segment), with exact distances only of cells that are not good.
#pragma once

#include <vector>

#include "planner/core/cells/cell_grid.hpp"

namespace skein::gridnav {

/// How much must be known of a swept cell.
enum class Need : std::uint8_t {
  NotOccupied = 1,  ///< unknown counts as free: for planning
  SeenFree = 2,     ///< seen, and free: for flying
};

class KnownMap {
 public:
  /// All cells unknown.
  explicit KnownMap(const CellGrid& grid) : grid_(grid), states_(grid.size(), CellState::Unknown) {}

  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  [[nodiscard]] bool planar() const { return grid_.nz == 1; }
  /// @pre the cell is in the grid
  [[nodiscard]] CellState state(CellIndex cell) const { return states_[cell]; }
  void set(CellIndex cell, CellState state) { states_[cell] = state; }
  [[nodiscard]] bool good(CellIndex cell, Need need) const {
    const CellState s = states_[cell];
    return need == Need::NotOccupied ? s != CellState::Occupied : s == CellState::Free || s == CellState::Revisited;
  }
  /// Whether c is in the grid and good.
  [[nodiscard]] bool good(const Cell& c, Need need) const { return grid_.contains(c) && good(grid_.index_of(c), need); }

  /// Whether a body of radius_m can fly straight from a to b (m) through good cells.
  [[nodiscard]] bool motion_clear(const Vec3& a, const Vec3& b, double radius_m, Need need) const;

 private:
  CellGrid grid_;
  std::vector<CellState> states_;
};

}  // namespace skein::gridnav
