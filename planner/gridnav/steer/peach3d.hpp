// peach3d: the complete planner of a transit, steered by potentials where ways are equally short.
//
// A field of distances to the goal over cells not known to be blocked (field/goal_field.hpp) gives a shortest way; the
// UAV flies straight to the farthest point of it that it could reach on the map as known, a waypoint, and keeps the
// waypoint until a farther one on the way is in line, or the map changes. A motion is offered only if its swept cells
// are clear; else shorter parts, else cells of the way, else the centre of the own cell.
// Promise: on a static map with correct sensing of the cells around, one UAV arrives if and only if a way through open
// cells without cut corners exists, else its field becomes infinite. For between two changes of the map the field at
// the waypoint falls with every new waypoint, and the distance to the waypoint with every motion; a cell changes at
// most once; and the next cell of the way is always seen, or found blocked, which is a change.
// Limits: a sensor that does not see the cells around it may never permit a motion.
// Source: papers/004, Eq. 1, 2 (tie-break); waypoints after section III-D2. Departs from source: complete, any angle.
// Complexity: O(repair + way cells x cells of a line).
#pragma once

#include <optional>

#include "planner/gridnav/field/goal_field.hpp"
#include "planner/gridnav/steer/steering.hpp"

namespace skein::gridnav {

class Peach3d final : public Steering {
 public:
  Peach3d(const Task& task, const Cell& start);

  bool learn(const KnownMap& map, std::span<const CellChange> changed) override;
  [[nodiscard]] Plan plan(const Situation& at) override;
  [[nodiscard]] std::vector<Option> detours(const Situation& at) override;
  [[nodiscard]] std::array<CellIndex, 4> way_from(const KnownMap& map, const Vec3& end_m) override;
  [[nodiscard]] bool complete() const override { return true; }

 private:
  /// Cells after `from` on a shortest way to the goal, as far as planned; empty if there is none.
  [[nodiscard]] std::vector<CellIndex> descend(const KnownMap& map, CellIndex from);
  [[nodiscard]] Vec3 point_of(const KnownMap& map, CellIndex cell) const;
  void choose_waypoint(const Situation& at, const std::vector<CellIndex>& way);
  [[nodiscard]] bool clear(const Situation& at, const Vec3& end_m) const;
  void offer_line(const Situation& at, std::vector<Option>& options);

  Task task_;
  Cell goal_;
  GoalField field_;
  std::optional<CellIndex> waypoint_;
  std::vector<GoalField::Step> steps_;
};

}  // namespace skein::gridnav
