// The cells into which a mission's area is divided: cuboids with square bases; one level stands for a plane.
//
//   cell (i, j, k) = origin + [i, i+1) x [j, j+1) * cell_m  and  [k, k+1) * height_m;  index = (k * ny + j) * nx + i
// A cell that the area does not cover whole is no cell: what is left over at the upper edges is out of bounds.
// Source: papers/004, section III-B. Departs from source: indices count from 0, x is i and y is j. Complexity: O(1).
#pragma once

#include <cmath>
#include <cstdint>

#include "planner/core/geometry/types.hpp"

namespace skein {

/// What is known of a cell. The order is that of the join: an obstacle outweighs free space of the same epoch.
enum class CellState : std::uint8_t {
  Unknown = 0,
  Free = 1,
  Revisited = 2,  ///< free, but a way that led nowhere (papers/004: 'has already been revisited')
  Occupied = 3,
};

struct Cell {
  std::int32_t i = 0;
  std::int32_t j = 0;
  std::int32_t k = 0;

  bool operator==(const Cell&) const = default;
};

using CellIndex = std::uint32_t;

struct CellChange {
  CellIndex cell = 0;
  CellState state = CellState::Unknown;

  bool operator==(const CellChange&) const = default;
};

struct CellGrid {
  Vec3 origin_m = Vec3::Zero();  ///< lower corner of cell (0, 0, 0)
  double cell_m = 1.0;           ///< edge of the square base
  double height_m = 1.0;
  std::int32_t nx = 1;
  std::int32_t ny = 1;
  std::int32_t nz = 1;  ///< 1: the plane

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
  }
  [[nodiscard]] bool contains(const Cell& c) const {
    return c.i >= 0 && c.i < nx && c.j >= 0 && c.j < ny && c.k >= 0 && c.k < nz;
  }
  /// @pre contains(c)
  [[nodiscard]] CellIndex index_of(const Cell& c) const { return static_cast<CellIndex>((c.k * ny + c.j) * nx + c.i); }
  [[nodiscard]] Cell cell_at(CellIndex index) const {
    const auto n = static_cast<std::int32_t>(index);
    return {n % nx, (n / nx) % ny, n / (nx * ny)};
  }
  /// The cell of a point, also outside the grid.
  [[nodiscard]] Cell cell_of(const Vec3& p) const {
    const auto at = [](double x, double edge) { return static_cast<std::int32_t>(std::floor(x / edge)); };
    const Vec3 d = p - origin_m;
    return {at(d.x(), cell_m), at(d.y(), cell_m), nz == 1 ? 0 : at(d.z(), height_m)};
  }
  [[nodiscard]] Vec3 centre_m(const Cell& c) const {
    return origin_m + Vec3((c.i + 0.5) * cell_m, (c.j + 0.5) * cell_m, (c.k + 0.5) * height_m);
  }
  [[nodiscard]] Box box_of(const Cell& c) const {
    const Vec3 low = origin_m + Vec3(c.i * cell_m, c.j * cell_m, c.k * height_m);
    return {low, low + Vec3(cell_m, cell_m, height_m)};
  }

  bool operator==(const CellGrid&) const = default;
};

/// The whole cells of an area; one level if its height is at least height_m and less than twice that;
/// an area smaller than a cell gives a grid without cells
[[nodiscard]] inline CellGrid grid_over(const Box& area, double cell_m, double height_m) {
  const auto count = [](double width, double edge) {
    return static_cast<std::int32_t>(std::floor(width / edge + 1e-9));
  };
  const Vec3 width = area.max_m - area.min_m;
  return {area.min_m, cell_m, height_m, count(width.x(), cell_m), count(width.y(), cell_m), count(width.z(), height_m)};
}

}  // namespace skein
