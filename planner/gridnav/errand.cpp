#include "planner/gridnav/errand.hpp"

#include <algorithm>

#include "planner/gridnav/field/goal_field.hpp"

namespace skein::gridnav {
namespace {

constexpr double kThere_m = 1e-6;

std::vector<CellChange> occupied_cells(const KnownMap& map) {
  std::vector<CellChange> occupied;
  for (CellIndex cell = 0; cell < map.grid().size(); ++cell) {
    if (map.state(cell) == CellState::Occupied) occupied.push_back({cell, CellState::Occupied});
  }
  return occupied;
}

/// Of the cells that open moves join to `from`, the one whose centre is nearest to a point; of equal ones the first
/// met.
CellIndex nearest_reachable(const KnownMap& map, std::span<const CellIndex> held, CellIndex from, const Vec3& point_m) {
  const CellGrid& grid = map.grid();
  GoalField open(grid, grid.cell_at(from), grid.cell_at(from));
  for (const CellChange& change : occupied_cells(map)) open.set_blocked(change.cell, true);
  for (const CellIndex cell : held) open.set_blocked(cell, true);
  const auto off_m = [&](CellIndex cell) { return (grid.centre_m(grid.cell_at(cell)) - point_m).norm(); };
  std::vector<bool> met(grid.size(), false);
  std::vector<CellIndex> order{from};
  met[from] = true;
  CellIndex best = from;
  std::vector<GoalField::Step> steps;
  for (std::size_t head = 0; head < order.size(); ++head) {
    if (off_m(order[head]) < off_m(best)) best = order[head];
    open.steps_from(order[head], steps);
    for (const GoalField::Step& step : steps) {
      if (met[step.cell]) continue;
      met[step.cell] = true;
      order.push_back(step.cell);
    }
  }
  return best;
}

}  // namespace

Errand::Errand(const Task& task, const Vec3& point_m) : state_(ErrandState::UnderWay), task_(task), point_m_(point_m) {
  task_.options.name = "peach3d";
}

bool Errand::learn(const KnownMap& map, std::span<const CellChange> changed) {
  if (!guide_ || !guide_->learn(map, changed)) return false;
  stale_ = true;
  return true;
}

void Errand::look_around(const KnownMap& map, const Vec3& position_m) {
  if (stays() || !guide_) return;
  const Vec3 centre_m = task_.grid.centre_m(task_.grid.cell_of(task_.goal_m));
  const bool fits = map.motion_clear(centre_m, task_.goal_m, task_.radius_m, Need::NotOccupied);
  if ((position_m - (fits ? task_.goal_m : centre_m)).norm() > kThere_m) return;
  state_ = at_point() ? ErrandState::Stays : ErrandState::Short;
}

void Errand::choose(const Situation& at, std::span<const CellIndex> held) {
  const CellGrid& grid = task_.grid;
  const CellIndex own = grid.index_of(grid.cell_of(at.start_m));
  const Cell place = grid.cell_at(nearest_reachable(at.map, held, own, point_m_));
  if (guide_ && place == grid.cell_of(task_.goal_m)) return;
  task_.goal_m = place == grid.cell_of(point_m_) ? point_m_ : grid.centre_m(place);
  guide_.emplace(task_, grid.cell_at(own));
  guide_->learn(at.map, occupied_cells(at.map));
}

Guide::Around Errand::plan(const Situation& at, std::span<const CellIndex> held) {
  const Vec3 before_m = task_.goal_m;
  const bool changed = stale_ || !std::ranges::equal(held, held_);
  if (!guide_ || (changed && !at_point())) choose(at, held);
  Guide::Around around = guide_->plan(at, held);
  if (around.through || around.plan.to_go_m < 0) {
    choose(at, held);
    around = guide_->plan(at, held);
    if (around.plan.to_go_m < 0) state_ = ErrandState::Short;  // not even to its own cell: it stays where it is
  }
  stale_ = false;
  held_.assign(held.begin(), held.end());
  around.changed = around.changed || task_.goal_m != before_m;
  return around;
}

void Errand::add_to(StateHash& hash) const {
  hash.add(state_).add(point_m_).add(task_.goal_m).add(task_.step_m).add(stale_);
  for (const CellIndex cell : held_) hash.add(cell);
}

}  // namespace skein::gridnav
