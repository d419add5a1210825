// What one look of an obstacle sensor reports: a window of cells, unseen ones included.
//
// Cell (low.i + a, low.j + b, low.k + c) is entry (c * size[1] + b) * size[0] + a. Source: papers/004, section III-A.
// Departs from source: none. Complexity: O(1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"

namespace skein {

struct SeenWindow {
  Cell low;                            ///< the cell of the first entry
  std::array<std::int32_t, 3> size{};  ///< in i, j and k; all 0 if there was no look
  std::vector<CellState> cells;        ///< Unknown: not seen in this look; never Revisited

  [[nodiscard]] bool empty() const { return cells.empty(); }
  /// What is reported of a cell; Unknown outside the window.
  [[nodiscard]] CellState at(const Cell& c) const {
    const Cell d{c.i - low.i, c.j - low.j, c.k - low.k};
    if (d.i < 0 || d.j < 0 || d.k < 0 || d.i >= size[0] || d.j >= size[1] || d.k >= size[2]) return CellState::Unknown;
    return cells[static_cast<std::size_t>((d.k * size[1] + d.j) * size[0] + d.i)];
  }

  bool operator==(const SeenWindow&) const = default;
};

}  // namespace skein
