#include "simworld/sensing/shortest_paths.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>

namespace skein {
namespace {

constexpr double kFar_m = std::numeric_limits<double>::infinity();

struct Move {
  Cell by;
  double length_m;
};

std::vector<Move> moves_of(const CellGrid& grid) {
  std::vector<Move> moves;
  for (std::int32_t k = -1; k <= 1; ++k) {
    for (std::int32_t j = -1; j <= 1; ++j) {
      for (std::int32_t i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        if (grid.nz == 1 && k != 0) continue;
        moves.push_back({{i, j, k}, Vec3(i * grid.cell_m, j * grid.cell_m, k * grid.height_m).norm()});
      }
    }
  }
  return moves;
}

/// By cell, the way to the goal's cell.
std::vector<double> ways_to(const TruthGrid& truth, const Cell& goal) {
  const CellGrid& grid = truth.grid();
  std::vector<double> ways_m(grid.size(), kFar_m);
  if (truth.occupied(goal)) return ways_m;
  using Entry = std::pair<double, CellIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const std::vector<Move> moves = moves_of(grid);
  ways_m[grid.index_of(goal)] = 0.0;
  open.emplace(0.0, grid.index_of(goal));
  while (!open.empty()) {
    const auto [way_m, index] = open.top();
    open.pop();
    if (way_m > ways_m[index]) continue;
    const Cell at = grid.cell_at(index);
    for (const Move& move : moves) {
      const Cell next{at.i + move.by.i, at.j + move.by.j, at.k + move.by.k};
      if (!grid.contains(next)) continue;
      const CellIndex next_index = grid.index_of(next);
      const double there_m = way_m + move.length_m;
      if (there_m >= ways_m[next_index] || !truth.may_move(at, next)) continue;
      ways_m[next_index] = there_m;
      open.emplace(there_m, next_index);
    }
  }
  return ways_m;
}

void flood(const TruthGrid& truth, CellIndex seed, std::uint32_t number, std::vector<std::uint32_t>& regions) {
  constexpr Cell kSides[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const CellGrid& grid = truth.grid();
  std::vector<CellIndex> open{seed};
  regions[seed] = number;
  while (!open.empty()) {
    const Cell at = grid.cell_at(open.back());
    open.pop_back();
    for (const Cell& side : kSides) {
      const Cell next{at.i + side.i, at.j + side.j, at.k + side.k};
      if (truth.occupied(next) || regions[grid.index_of(next)] != 0) continue;
      regions[grid.index_of(next)] = number;
      open.push_back(grid.index_of(next));
    }
  }
}

}  // namespace

std::vector<std::optional<double>> shortest_paths_m(const TruthGrid& truth, std::span<const Vec3> starts_m,
                                                    std::span<const Vec3> goals_m) {
  if (starts_m.size() != goals_m.size()) throw std::invalid_argument("as many goals as starts are needed");
  const CellGrid& grid = truth.grid();
  std::vector<std::optional<double>> lengths_m(starts_m.size());
  std::vector<bool> done(starts_m.size());
  for (std::size_t i = 0; i < starts_m.size(); ++i) {
    if (done[i]) continue;
    const Cell goal = grid.cell_of(goals_m[i]);
    const std::vector<double> ways_m = ways_to(truth, goal);
    for (std::size_t j = i; j < starts_m.size(); ++j) {
      if (grid.cell_of(goals_m[j]) != goal) continue;
      done[j] = true;
      const Cell start = grid.cell_of(starts_m[j]);
      if (!grid.contains(start) || ways_m[grid.index_of(start)] == kFar_m) continue;
      lengths_m[j] = ways_m[grid.index_of(start)];
    }
  }
  return lengths_m;
}

std::vector<std::uint32_t> regions_of(const TruthGrid& truth) {
  std::vector<std::uint32_t> regions(truth.grid().size());
  std::uint32_t count = 0;
  for (CellIndex cell = 0; cell < regions.size(); ++cell) {
    if (!truth.occupied(cell) && regions[cell] == 0) flood(truth, cell, ++count, regions);
  }
  return regions;
}

}  // namespace skein
