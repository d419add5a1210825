#include "planner/gridnav/steer/peach3d.hpp"

#include <algorithm>

#include "planner/gridnav/steer/potential.hpp"

namespace skein::gridnav {
namespace {

constexpr std::size_t kLookAhead = 64;  ///< cells of the way among which a waypoint is sought
constexpr std::array<double, 3> kParts{1.0, 0.7, 0.4};

/// The point at most reach_m from `from` on the way to `to`.
Vec3 towards(const Vec3& from, const Vec3& to, double reach_m) {
  const double apart_m = (to - from).norm();
  return apart_m <= reach_m ? to : Vec3(from + (reach_m / apart_m) * (to - from));
}

}  // namespace

Peach3d::Peach3d(const Task& task, const Cell& start)
    : task_(task), goal_(task.grid.cell_of(task.goal_m)), field_(task.grid, goal_, start) {}

bool Peach3d::learn(const KnownMap&, std::span<const CellChange> changed) {
  bool any = false;
  for (const CellChange& change : changed) {
    const bool blocked = change.state == CellState::Occupied;
    if (field_.blocked(change.cell) == blocked) continue;
    field_.set_blocked(change.cell, blocked);
    any = true;
  }
  if (any) waypoint_.reset();
  return any;
}

std::vector<CellIndex> Peach3d::descend(const KnownMap& map, CellIndex from) {
  std::vector<CellIndex> way;
  if (field_.value(from) == kInfinite) return way;
  for (CellIndex cell = from; cell != field_.goal() && way.size() < kLookAhead;) {
    field_.steps_from(cell, steps_);
    Cost least = kInfinite;
    double least_potential = 0.0;
    CellIndex next = cell;
    for (const GoalField::Step& step : steps_) {
      const Cost cost = step.cost + field_.settled(step.cell);
      if (cost > least || cost >= kInfinite) continue;
      const Cell c = task_.grid.cell_at(step.cell);
      const double potential =
          goal_potential(task_.grid, c, goal_) + (beside_obstacle(map, c) ? task_.options.obstacle_potential / 2 : 0.0);
      if (cost == least && potential >= least_potential) continue;
      least = cost;
      least_potential = potential;
      next = step.cell;
    }
    if (next == cell) break;
    way.push_back(cell = next);
  }
  return way;
}

// The goal itself in its cell, if a body fits there, else the cell's centre.
Vec3 Peach3d::point_of(const KnownMap& map, CellIndex cell) const {
  const Vec3 centre = task_.grid.centre_m(task_.grid.cell_at(cell));
  const bool at_goal =
      cell == field_.goal() && map.motion_clear(centre, task_.goal_m, task_.radius_m, Need::NotOccupied);
  return at_goal ? task_.goal_m : centre;
}

void Peach3d::choose_waypoint(const Situation& at, const std::vector<CellIndex>& way) {
  const auto in_line = [&](CellIndex cell) {
    return at.map.motion_clear(at.start_m, point_of(at.map, cell), task_.radius_m, Need::NotOccupied);
  };
  if (waypoint_ && !in_line(*waypoint_)) waypoint_.reset();
  const std::vector<CellIndex> beyond = waypoint_ ? descend(at.map, *waypoint_) : way;
  const auto farthest = std::find_if(beyond.rbegin(), beyond.rend(), in_line);
  if (farthest != beyond.rend()) waypoint_ = *farthest;
}

bool Peach3d::clear(const Situation& at, const Vec3& end_m) const {
  return at.map.motion_clear(at.start_m, end_m, task_.radius_m, at.need);
}

void Peach3d::offer_line(const Situation& at, std::vector<Option>& options) {
  const Vec3 to = point_of(at.map, *waypoint_);
  const std::vector<CellIndex> beyond = descend(at.map, *waypoint_);
  const Vec3 after = beyond.empty() ? to : point_of(at.map, beyond[0]);
  const double reach_m = std::min(task_.step_m, (to - at.start_m).norm());
  for (const double part : kParts) {
    const Vec3 end = towards(at.start_m, to, part * reach_m);
    if (reach_m > 1e-9 && clear(at, end)) options.push_back({end, end == to ? after : to});
  }
}

Plan Peach3d::plan(const Situation& at) {
  const CellGrid& grid = task_.grid;
  const CellIndex own = grid.index_of(grid.cell_of(at.start_m));
  field_.move_start(own);
  const Cost value = field_.value(own);
  Plan plan;
  if (value == kInfinite) {
    plan.to_go_m = -1.0;
    return plan;
  }
  plan.to_go_m = field_.metres(value);
  const std::vector<CellIndex> way = descend(at.map, own);
  if (own == field_.goal()) waypoint_ = own;
  choose_waypoint(at, way);
  if (waypoint_) offer_line(at, plan.options);
  std::size_t near = 0;
  while (near < way.size() && near < 8 && (point_of(at.map, way[near]) - at.start_m).norm() <= task_.step_m) ++near;
  for (std::size_t n = near; n-- > 0;) {
    const Vec3 end = point_of(at.map, way[n]);
    if (clear(at, end)) plan.options.push_back({end, n + 1 < way.size() ? point_of(at.map, way[n + 1]) : end});
  }
  const Vec3 centre = grid.centre_m(grid.cell_at(own));
  if ((centre - at.start_m).norm() > 1e-6 && clear(at, centre))
    plan.options.push_back({centre, way.empty() ? centre : point_of(at.map, way[0])});
  return plan;
}

std::vector<Option> Peach3d::detours(const Situation& at) {
  const CellGrid& grid = task_.grid;
  const CellIndex own = grid.index_of(grid.cell_of(at.start_m));
  const Cost own_value = field_.value(own);
  field_.steps_from(own, steps_);
  std::vector<GoalField::Step> lower;
  for (const GoalField::Step& step : steps_) {
    const Cost value = field_.value(step.cell);
    if (value < own_value) lower.push_back({step.cell, value + step.cost});
  }
  std::sort(lower.begin(), lower.end(),
            [](const auto& a, const auto& b) { return a.cost != b.cost ? a.cost < b.cost : a.cell < b.cell; });
  std::vector<Option> options;
  for (const GoalField::Step& step : lower) {
    const Vec3 end = point_of(at.map, step.cell);
    if ((end - at.start_m).norm() > task_.step_m || !clear(at, end)) continue;
    const std::vector<CellIndex> way = descend(at.map, step.cell);
    options.push_back({end, way.empty() ? end : point_of(at.map, way[0])});
  }
  return options;
}

std::array<CellIndex, 4> Peach3d::way_from(const KnownMap& map, const Vec3& end_m) {
  const CellIndex at = task_.grid.index_of(task_.grid.cell_of(end_m));
  std::array<CellIndex, 4> ends;
  ends.fill(at);
  if (field_.value(at) == kInfinite) return ends;
  const std::vector<CellIndex> way = descend(map, at);
  Vec3 from = end_m;
  std::size_t next = 0;
  CellIndex last = at;
  for (CellIndex& end : ends) {
    for (const std::size_t first = next; next < way.size(); ++next) {
      const Vec3 to = point_of(map, way[next]);
      if (next > first &&
          ((to - from).norm() > task_.step_m || !map.motion_clear(from, to, task_.radius_m, Need::NotOccupied)))
        break;
      last = way[next];
    }
    end = last;
    from = point_of(map, last);
  }
  return ends;
}

}  // namespace skein::gridnav
