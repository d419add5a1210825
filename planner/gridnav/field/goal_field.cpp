#include "planner/gridnav/field/goal_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace skein::gridnav {
namespace {

constexpr auto kLater = [](const auto& a, const auto& b) { return a.key != b.key ? a.key > b.key : a.place > b.place; };

}  // namespace

GoalField::GoalField(const CellGrid& grid, const Cell& goal, const Cell& start)
    : grid_(grid),
      row_(grid.nx + 2),
      level_((grid.nx + 2) * (grid.ny + 2)),
      goal_cell_(grid.index_of(goal)),
      start_(start) {
  const auto size = static_cast<std::size_t>(level_) * static_cast<std::size_t>(grid.nz + (grid.nz > 1 ? 2 : 0));
  g_.assign(size, kInfinite);
  rhs_.assign(size, kInfinite);
  queued_.assign(size, 0);
  blocked_.assign(size, 1);
  dirty_.assign(size, 1);  // of the border: never repaired
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const Place place = place_of(grid.cell_at(static_cast<CellIndex>(n)));
    blocked_[place] = 0;
    dirty_[place] = 0;
  }
  make_moves();
  goal_ = place_of(goal);
  rhs_[goal_] = 0;
  update(goal_);
}

void GoalField::make_moves() {
  const int up = grid_.nz > 1 ? 1 : 0;
  const double h = grid_.height_m / grid_.cell_m;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c) {
        const double length = std::sqrt(a + b + c * h * h);
        edge_[a][b][c] = static_cast<Cost>(std::floor(length * kCellCost + 0.5));
      }
  for (int k = -up; k <= up; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) around_.push_back(k * level_ + j * row_ + i);
  const auto bit = [up](int i, int j, int k) { return 1u << ((k + up) * 9 + (j + 1) * 3 + i + 1); };
  for (int k = -up; k <= up; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        std::uint32_t needs = 0;
        for (int part = 0; part < 8; ++part)
          needs |= bit((part & 1) != 0 ? i : 0, (part & 2) != 0 ? j : 0, (part & 4) != 0 ? k : 0);
        moves_.push_back({k * level_ + j * row_ + i, edge_[std::abs(i)][std::abs(j)][std::abs(k)], needs});
      }
}

GoalField::Place GoalField::place_of(const Cell& c) const {
  return static_cast<Place>((grid_.nz > 1 ? c.k + 1 : 0) * level_ + (c.j + 1) * row_ + c.i + 1);
}

Cell GoalField::cell_at(Place place) const {
  const auto n = static_cast<std::int32_t>(place);
  const std::int32_t in_level = n % level_;
  return {in_level % row_ - 1, in_level / row_ - 1, n / level_ - (grid_.nz > 1 ? 1 : 0)};
}

Cost GoalField::heuristic(const Cell& a, const Cell& b) const {
  const auto apart = [](std::int32_t p, std::int32_t q) { return static_cast<Cost>(std::abs(p - q)); };
  const Cost x = apart(a.i, b.i), y = apart(a.j, b.j), z = apart(a.k, b.k);
  const Cost all = std::min({x, y, z});
  const Cost flat = std::min(x, y) - all;                  // diagonal in the plane
  const Cost steep = std::min(std::max(x, y), z) - all;    // diagonal in an upright plane
  const Cost along = std::max(x, y) - all - flat - steep;  // along x or y
  return all * edge_[1][1][1] + flat * edge_[1][1][0] + steep * edge_[1][0][1] + along * edge_[1][0][0] +
         (z - all - steep) * edge_[0][0][1];
}

std::uint64_t GoalField::key_of(Place place) const {
  const Cost value = std::min(g_[place], rhs_[place]);
  const std::uint64_t first = std::uint64_t{value} + heuristic(start_, cell_at(place)) + moved_;
  return ((first << 31) | value) + 1;
}

std::uint32_t GoalField::blocked_around(Place place) const {
  std::uint32_t word = 0;
  for (std::size_t n = 0; n < around_.size(); ++n)
    word |= static_cast<std::uint32_t>(blocked_[place + static_cast<Place>(around_[n])]) << n;
  return word;
}

Cost GoalField::least(Place place) const {
  const std::uint32_t word = blocked_around(place);
  Cost best = kInfinite;
  for (const Move& move : moves_)
    if ((word & move.needs) == 0) best = std::min(best, g_[place + static_cast<Place>(move.offset)] + move.cost);
  return best;
}

void GoalField::update(Place place) {
  if (g_[place] == rhs_[place]) {
    queued_[place] = 0;
    return;
  }
  const std::uint64_t key = key_of(place);
  if (queued_[place] == key) return;
  queued_[place] = key;
  queue_.push_back({key, place});
  std::push_heap(queue_.begin(), queue_.end(), kLater);
}

void GoalField::pop() {
  std::pop_heap(queue_.begin(), queue_.end(), kLater);
  queue_.pop_back();
}

void GoalField::settle(Place target) {
  while (true) {
    while (!queue_.empty() && queued_[queue_.front().place] != queue_.front().key) pop();
    if (queue_.empty()) return;
    const Entry top = queue_.front();
    if (g_[target] == rhs_[target] && top.key >= key_of(target)) return;
    pop();
    queued_[top.place] = 0;
    ++expanded_;
    expand(top.place, top.key);
  }
}

void GoalField::expand(Place place, std::uint64_t key) {
  if (key < key_of(place)) {
    update(place);
  } else if (g_[place] > rhs_[place]) {
    g_[place] = rhs_[place];
    const std::uint32_t word = blocked_around(place);
    for (const Move& move : moves_) {
      if ((word & move.needs) != 0) continue;
      const Place next = place + static_cast<Place>(move.offset);
      if (next == goal_ || g_[place] + move.cost >= rhs_[next]) continue;
      rhs_[next] = g_[place] + move.cost;
      update(next);
    }
  } else {
    raise(place);
  }
}

// An under-consistent cell: it loses its value, and so does whoever took it from there.
void GoalField::raise(Place place) {
  const Cost old = g_[place];
  g_[place] = kInfinite;
  const std::uint32_t word = blocked_around(place);
  for (const Move& move : moves_) {
    if ((word & move.needs) != 0) continue;
    const Place next = place + static_cast<Place>(move.offset);
    if (next == goal_ || rhs_[next] != old + move.cost) continue;
    rhs_[next] = least(next);
    update(next);
  }
  update(place);
}

void GoalField::set_blocked(CellIndex cell, bool blocked) {
  const Place place = place_of(grid_.cell_at(cell));
  if ((blocked_[place] != 0) == blocked) return;
  blocked_[place] = blocked ? 1 : 0;
  for (const std::int32_t offset : around_) {
    const Place near = place + static_cast<Place>(offset);
    if (dirty_[near] != 0 || (blocked && g_[near] == kInfinite && rhs_[near] == kInfinite)) continue;
    dirty_[near] = 1;
    changed_.push_back(near);
  }
}

void GoalField::repair() {
  for (const Place place : changed_) {
    dirty_[place] = 0;
    if (place == goal_) continue;
    rhs_[place] = blocked_[place] != 0 ? kInfinite : least(place);
    update(place);
  }
  changed_.clear();
}

void GoalField::move_start(CellIndex start) {
  const Cell to = grid_.cell_at(start);
  moved_ += heuristic(start_, to);
  start_ = to;
}

Cost GoalField::value(CellIndex cell) {
  repair();
  const Place place = place_of(grid_.cell_at(cell));
  settle(place);
  return std::min(g_[place], kInfinite);
}

void GoalField::steps_from(CellIndex cell, std::vector<Step>& steps) const {
  steps.clear();
  const Place place = place_of(grid_.cell_at(cell));
  const std::uint32_t word = blocked_around(place);
  for (const Move& move : moves_)
    if ((word & move.needs) == 0)
      steps.push_back({grid_.index_of(cell_at(place + static_cast<Place>(move.offset))), move.cost});
}

}  // namespace skein::gridnav
