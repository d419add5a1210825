#include "planner/gridnav/steer/peach3d_paper.hpp"

#include <algorithm>

#include "planner/core/geometry/distance.hpp"

namespace skein::gridnav {

Peach3dPaper::Peach3dPaper(const Task& task)
    : task_(task), goal_(task.grid.cell_of(task.goal_m)), table_(task), visited_(task.grid.size(), 0) {}

bool Peach3dPaper::clear(const KnownMap& map, const Vec3& a, const Vec3& b) const {
  return map.motion_clear(a, b, task_.radius_m, Need::NotOccupied);
}

bool Peach3dPaper::goal_in_line(const Situation& at) const {
  const double apart_m = (task_.goal_m - at.start_m).norm();
  const double look_m = task_.options.known_line != 0.0 ? apart_m : std::min(apart_m, task_.sensor_range_m);
  if (apart_m < 1e-9) return true;
  return clear(at.map, at.start_m, at.start_m + (look_m / apart_m) * (task_.goal_m - at.start_m));
}

bool Peach3dPaper::leg_obstructed(const Situation& at) const {
  if (waypoints_m_.empty()) return true;
  Vec3 from = at.start_m;
  for (const Vec3& to : waypoints_m_) {
    if (!clear(at.map, from, to)) return true;
    from = to;
  }
  return std::any_of(at.others.begin(), at.others.end(), [&](const Other& other) {
    return point_to_segment(other.next_m, at.start_m, waypoints_m_.front()) < other.clearance_m;
  });
}

void Peach3dPaper::visit(const Cell& c) {
  const CellIndex index = task_.grid.index_of(c);
  visited_[index] = 1;
  if (trail_.empty() || trail_.back() != index) trail_.push_back(index);
}

bool Peach3dPaper::dead_end(const Cell& own) {
  table_.cells_around(own, around_);
  return std::all_of(around_.begin(), around_.end(),
                     [&](const Cell& c) { return visited_[task_.grid.index_of(c)] != 0; });
}

void Peach3dPaper::retrace(std::vector<CellIndex>& revisited) {
  waypoints_m_.clear();
  while (trail_.size() > 1) {
    table_.raise(trail_.back(), table_.alpha());
    revisited.push_back(trail_.back());
    trail_.pop_back();
    const Cell c = task_.grid.cell_at(trail_.back());
    waypoints_m_.push_back(task_.grid.centre_m(c));
    if (!dead_end(c)) return;
  }
}

CellIndex Peach3dPaper::least_around(CellIndex from) {
  const CellGrid& grid = task_.grid;
  table_.cells_around(grid.cell_at(from), around_);
  CellIndex best = from;
  double least = table_.sum(from);
  for (const Cell& c : around_) {
    const double sum = table_.sum(grid.index_of(c));
    if (sum >= least) continue;
    least = sum;
    best = grid.index_of(c);
  }
  return best;
}

// Algorithm 3.
void Peach3dPaper::walk(const Situation& at) {
  const CellGrid& grid = task_.grid;
  waypoints_m_.clear();
  const CellIndex goal = grid.index_of(goal_);
  CellIndex cell = grid.index_of(grid.cell_of(at.start_m));
  std::vector<Vec3> way_m{at.start_m};
  const Vec3 centre = grid.centre_m(grid.cell_at(cell));
  if ((centre - at.start_m).norm() > 1e-6) way_m.push_back(centre);
  for (int step = 0; cell != goal && step < kMostSteps; ++step) {
    const CellIndex next = least_around(cell);
    if (next == cell) {
      table_.raise(cell, table_.minimum_raise());
      continue;
    }
    cell = next;
    const Vec3 to = cell == goal ? task_.goal_m : grid.centre_m(grid.cell_at(cell));
    if (way_m.size() > 1 && clear(at.map, way_m[way_m.size() - 2], to)) way_m.pop_back();
    way_m.push_back(to);
  }
  waypoints_m_.assign(way_m.begin() + 1, way_m.end());
}

// Too little of the leg has been seen: to the centre of the own cell, or from there to the next cell of a walk.
void Peach3dPaper::offer_near(const Situation& at, Plan& plan) {
  const CellGrid& grid = task_.grid;
  waypoints_m_.clear();
  const CellIndex own = grid.index_of(grid.cell_of(at.start_m));
  const CellIndex next = least_around(own);
  if (next == own) {
    table_.raise(own, table_.minimum_raise());
    plan.revisited.push_back(own);
  }
  for (const CellIndex cell : {next, own}) {
    const Vec3 end = grid.centre_m(grid.cell_at(cell));
    const double apart_m = (end - at.start_m).norm();
    if (apart_m > 1e-6 && apart_m <= task_.step_m && at.map.motion_clear(at.start_m, end, task_.radius_m, at.need))
      plan.options.push_back({end, task_.goal_m});
  }
}

Plan Peach3dPaper::plan(const Situation& at) {
  Plan plan;
  plan.to_go_m = (task_.goal_m - at.start_m).norm();
  const Cell own = task_.grid.cell_of(at.start_m);
  table_.avoid(at.start_m, at.others);
  visit(own);
  while (!waypoints_m_.empty() && (waypoints_m_.front() - at.start_m).norm() < 1e-6) waypoints_m_.pop_front();
  const bool retracing = mode_ == Mode::DeadEnd && !waypoints_m_.empty() && !leg_obstructed(at);
  if (!retracing) {
    const Mode before = mode_;
    mode_ = goal_in_line(at) ? Mode::Free : dead_end(own) ? Mode::DeadEnd : Mode::Obstacle;
    if (mode_ == Mode::Free) {
      waypoints_m_.assign(1, task_.goal_m);
    } else if (mode_ != before || leg_obstructed(at)) {
      mode_ == Mode::DeadEnd ? retrace(plan.revisited) : walk(at);
    }
  }
  if (waypoints_m_.empty()) return plan;
  const Vec3 to = waypoints_m_.front();
  const double apart_m = (to - at.start_m).norm();
  for (const double part : {1.0, 0.5}) {
    const double reach_m = part * std::min(task_.step_m, apart_m);
    const Vec3 end = reach_m >= apart_m ? to : Vec3(at.start_m + (reach_m / apart_m) * (to - at.start_m));
    if (apart_m > 1e-9 && at.map.motion_clear(at.start_m, end, task_.radius_m, at.need))
      plan.options.push_back({end, to});
  }
  if (plan.options.empty()) offer_near(at, plan);
  return plan;
}

std::array<CellIndex, 4> Peach3dPaper::way_from(const KnownMap&, const Vec3& end_m) {
  const CellGrid& grid = task_.grid;
  std::array<CellIndex, 4> cells;
  CellIndex last = grid.index_of(grid.cell_of(end_m));
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (n < waypoints_m_.size()) last = grid.index_of(grid.cell_of(waypoints_m_[n]));
    cells[n] = last;
  }
  return cells;
}

}  // namespace skein::gridnav
