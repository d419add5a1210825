#include "planner/gridnav/traffic/back_off.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "planner/core/geometry/distance.hpp"

namespace skein::gridnav {
namespace {

/// Moves along axes first, so that a straight way is preferred.
std::vector<Cell> moves_of(bool planar) {
  std::vector<Cell> moves;
  for (std::int32_t axes = 1; axes <= 3; ++axes)
    for (std::int32_t k = planar ? 0 : -1; k <= (planar ? 0 : 1); ++k)
      for (std::int32_t j = -1; j <= 1; ++j)
        for (std::int32_t i = -1; i <= 1; ++i)
          if (i * i + j * j + k * k == axes) moves.push_back({i, j, k});
  return moves;
}

bool open_move(const KnownMap& map, const Cell& c, const Cell& move) {
  for (int part = 1; part < 8; ++part) {
    const Cell in{c.i + ((part & 1) != 0 ? move.i : 0), c.j + ((part & 2) != 0 ? move.j : 0),
                  c.k + ((part & 4) != 0 ? move.k : 0)};
    if (!map.good(in, Need::SeenFree)) return false;
  }
  return true;
}

/// Index of the other that stands too close to the motion from a to b, or -1.
int taken_by(const Vec3& a, const Vec3& b, std::span<const Other> others) {
  for (std::size_t n = 0; n < others.size(); ++n)
    if (point_to_segment(others[n].next_m, a, b) < others[n].clearance_m) return static_cast<int>(n);
  return -1;
}

bool off_ways(const Vec3& p, std::span<const Other> others, const std::vector<bool>& way_first) {
  for (std::size_t n = 0; n < others.size(); ++n)
    if (way_first[n] && on_way(p, others[n].way_m).distance_m < others[n].clearance_m) return false;
  return true;
}

/// How far along the ways on which p lies somebody must come before p is in the way.
double spared_m(const Vec3& p, std::span<const Other> others, const std::vector<bool>& way_first) {
  double least_m = 1e9;
  for (std::size_t n = 0; n < others.size(); ++n) {
    if (!way_first[n]) continue;
    const OnWay at = on_way(p, others[n].way_m);
    if (at.distance_m < others[n].clearance_m) least_m = std::min(least_m, at.along_m);
  }
  return least_m;
}

enum class Seek : std::uint8_t { OffWays, OffWaysPushing, Farthest };

BackOff search(const KnownMap& map, const Vec3& from_m, std::span<const Other> others,
               const std::vector<bool>& way_first, Seek seek) {
  const CellGrid& grid = map.grid();
  const std::vector<Cell> moves = moves_of(map.planar());
  std::map<CellIndex, CellIndex> parent;
  std::vector<CellIndex> order{grid.index_of(grid.cell_of(from_m))};
  parent[order.front()] = order.front();
  CellIndex farthest = order.front();
  double farthest_m = spared_m(from_m, others, way_first);
  const auto gives_way = [&](std::size_t n) { return !way_first[n] && !is_held(others[n]); };
  const auto trace = [&](CellIndex cell) {
    BackOff found;
    for (; cell != order.front(); cell = parent.at(cell)) found.cells.push_back(cell);
    std::reverse(found.cells.begin(), found.cells.end());
    Vec3 at = from_m;
    for (const CellIndex c : found.cells) {
      const Vec3 next = grid.centre_m(grid.cell_at(c));
      const int by = taken_by(at, next, others);
      if (by >= 0 && found.blocked_by == 0) found.blocked_by = others[static_cast<std::size_t>(by)].id;
      at = next;
    }
    return found;
  };
  for (std::size_t head = 0; head < order.size() && order.size() < kMostCells; ++head) {
    const Cell c = grid.cell_at(order[head]);
    const Vec3 here = head == 0 ? from_m : grid.centre_m(c);
    for (const Cell& move : moves) {
      const Cell next{c.i + move.i, c.j + move.j, c.k + move.k};
      if (!open_move(map, c, move) || parent.contains(grid.index_of(next))) continue;
      const Vec3 centre = grid.centre_m(next);
      const int by = taken_by(here, centre, others);
      if (by >= 0 && (seek != Seek::OffWaysPushing || !gives_way(static_cast<std::size_t>(by)))) continue;
      const CellIndex index = grid.index_of(next);
      parent[index] = order[head];
      order.push_back(index);
      if (seek != Seek::Farthest && off_ways(centre, others, way_first)) return trace(index);
      const double here_m = spared_m(centre, others, way_first);
      if (here_m <= farthest_m + 1e-6) continue;
      farthest_m = here_m;
      farthest = index;
    }
  }
  return seek == Seek::Farthest ? trace(farthest) : BackOff{};
}

}  // namespace

BackOff find_back_off(const KnownMap& map, const Vec3& from_m, std::span<const Other> others,
                      const std::vector<bool>& way_first) {
  for (const Seek seek : {Seek::OffWays, Seek::OffWaysPushing, Seek::Farthest}) {
    BackOff found = search(map, from_m, others, way_first, seek);
    if (!found.cells.empty()) return found;
  }
  return {};
}

}  // namespace skein::gridnav
