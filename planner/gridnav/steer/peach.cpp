#include "planner/gridnav/steer/peach.hpp"

namespace skein::gridnav {

Plan Peach::plan(const Situation& at) {
  const CellGrid& grid = task_.grid;
  const Cell own = grid.cell_of(at.start_m);
  const Cell goal = grid.cell_of(task_.goal_m);
  Plan plan;
  plan.to_go_m = (task_.goal_m - at.start_m).norm();
  table_.avoid(at.start_m, at.others);
  if (own == goal) {
    if (at.map.motion_clear(at.start_m, task_.goal_m, task_.radius_m, at.need))
      plan.options.push_back({task_.goal_m, task_.goal_m});
    return plan;
  }
  table_.cells_around(own, around_);
  CellIndex best = grid.index_of(own);
  if (best != last_) {
    if (visited_[best] != 0) {
      table_.raise(best, table_.minimum_raise());
      plan.revisited.push_back(best);
    }
    visited_[best] = 1;
    last_ = best;
  }
  double least = table_.sum(best);
  for (const Cell& c : around_) {
    const double sum = table_.sum(grid.index_of(c));
    if (sum >= least) continue;
    const Vec3 centre = grid.centre_m(c);
    if ((centre - at.start_m).norm() > task_.step_m) continue;
    if (!at.map.motion_clear(at.start_m, centre, task_.radius_m, at.need)) continue;
    least = sum;
    best = grid.index_of(c);
  }
  if (best == grid.index_of(own)) {
    table_.raise(best, table_.minimum_raise());
    plan.revisited.push_back(best);
  } else {
    const Vec3 centre = grid.centre_m(grid.cell_at(best));
    plan.options.push_back({centre, task_.goal_m});
  }
  return plan;
}

std::array<CellIndex, 4> Peach::way_from(const KnownMap&, const Vec3& end_m) {
  std::array<CellIndex, 4> cells;
  cells.fill(task_.grid.index_of(task_.grid.cell_of(end_m)));
  return cells;
}

}  // namespace skein::gridnav
