#include "simworld/sensing/line_of_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace skein {
namespace {

constexpr double kSameTime = 1e-9;  // parts of a ray within which it crosses several faces at once

/// An end of a ray: its cell, and that cell's index.
struct End {
  std::array<std::int32_t, 3> cell;
  CellIndex index;
};

/// A ray on one axis: the part of it at which it next leaves a cell, what a cell takes, and the step of the index.
struct Axis {
  double next;
  double delta;
  std::int32_t stride;
};

Axis axis_of(double from, double to, std::int32_t cell, std::int32_t stride) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double way = to - from;
  if (way == 0.0) return {kNever, kNever, 0};
  const double delta = 1.0 / std::fabs(way);
  return way > 0.0 ? Axis{(cell + 1.0 - from) * delta, delta, stride} : Axis{(from - cell) * delta, delta, -stride};
}

/// Of cells beside a crossing of several faces at once, those reached over some of the faces but not over all: is one
/// occupied?
bool squeezes(const TruthGrid& truth, CellIndex at, const std::array<Axis, 3>& axes, unsigned crossed) {
  for (unsigned part = 1; part < crossed; ++part) {
    if ((part & ~crossed) != 0) continue;
    std::int32_t by = 0;
    for (unsigned a = 0; a < 3; ++a) by += (part >> a & 1U) != 0 ? axes[a].stride : 0;
    if (truth.occupied(at + static_cast<CellIndex>(by))) return true;
  }
  return false;
}

/// All cells on the way lie in the block that start and target span, so the grid has them.
bool ray_arrives(const TruthGrid& truth, const Vec3& from, const Vec3& to, const End& start, const End& target) {
  const CellGrid& grid = truth.grid();
  std::array<Axis, 3> axes{axis_of(from.x(), to.x(), start.cell[0], 1),
                           axis_of(from.y(), to.y(), start.cell[1], grid.nx),
                           axis_of(from.z(), to.z(), start.cell[2], grid.nx * grid.ny)};
  CellIndex at = start.index;
  while (at != target.index) {
    const double now = std::min(std::min(axes[0].next, axes[1].next), axes[2].next);
    if (now >= 1.0 - kSameTime) return true;  // at the near face of the target
    unsigned crossed = 0;
    std::int32_t by = 0;
    for (unsigned a = 0; a < 3; ++a) {
      if (axes[a].next > now + kSameTime) continue;
      crossed |= 1U << a;
      by += axes[a].stride;
    }
    if ((crossed & (crossed - 1)) != 0 && squeezes(truth, at, axes, crossed)) return false;
    for (unsigned a = 0; a < 3; ++a) axes[a].next += (crossed >> a & 1U) != 0 ? axes[a].delta : 0.0;
    at += static_cast<CellIndex>(by);
    if (at != target.index && truth.occupied(at)) return false;
  }
  return true;
}

/// No occupied cell but the own one and the target in the block that they span: every ray in it arrives.
bool open_between(const TruthGrid& truth, const Cell& own, const Cell& cell) {
  const std::uint32_t ends = (truth.occupied(own) ? 1U : 0U) + (!(own == cell) && truth.occupied(cell) ? 1U : 0U);
  return truth.occupied_between(own, cell) == ends;
}

}  // namespace

bool in_sight(const TruthGrid& truth, const Vec3& from_m, const Cell& cell) {
  const CellGrid& grid = truth.grid();
  const Cell own = grid.cell_of(from_m);
  if (!grid.contains(own)) return false;
  if (open_between(truth, own, cell)) return true;
  Vec3 from = (from_m - grid.origin_m).cwiseQuotient(Vec3(grid.cell_m, grid.cell_m, grid.height_m));
  if (grid.nz == 1) from.z() = 0.5;
  const End start{{own.i, own.j, own.k}, grid.index_of(own)};
  const End target{{cell.i, cell.j, cell.k}, grid.index_of(cell)};
  const Vec3 centre(cell.i + 0.5, cell.j + 0.5, cell.k + 0.5);
  if (ray_arrives(truth, from, centre, start, target)) return true;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const bool before = from[axis] < target.cell[a];
    if (!before && from[axis] <= target.cell[a] + 1.0) continue;  // beside the cell on this axis
    Vec3 face = centre;
    face[axis] = before ? target.cell[a] : target.cell[a] + 1.0;
    if (ray_arrives(truth, from, face, start, target)) return true;
  }
  return false;
}

}  // namespace skein
