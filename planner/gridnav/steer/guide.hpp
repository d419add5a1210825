// A planner on its way to one goal that also keeps off the cells in which others are held by command.
//
// To a planner that is complete such a cell is blocked, as long as there is a way around; without one they all are open
// again, and the UAV comes up and waits until its way is free. So nobody says `unreachable` because another is held.
// The map is not touched: held UAVs are no obstacles that last. Planners that promise nothing see others by their
// potentials alone. Source: own. Departs from source: none. Complexity: of the planner, twice where no way leads
// around.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "planner/gridnav/steer/steering.hpp"

namespace skein::gridnav {

class Guide {
 public:
  /// @param start the cell from which it plans first. @pre task.options.name is one of kTransitPlanners
  Guide(const Task& task, const Cell& start) : steering_(make_steering(task, start)) {}

  [[nodiscard]] Steering& steering() const { return *steering_; }
  [[nodiscard]] bool complete() const { return steering_->complete(); }

  /// As Steering::learn.
  bool learn(const KnownMap& map, std::span<const CellChange> changed);

  struct Around {
    Plan plan;
    bool changed = false;  ///< other cells count as blocked than before: earlier distances to go do not compare
    bool through = false;  ///< the only ways lead through cells in which others are held
  };
  /// @param held cells in which others are held, ascending
  [[nodiscard]] Around plan(const Situation& at, std::span<const CellIndex> held);

 private:
  [[nodiscard]] Plan plan_off_blocked(const Situation& at);
  bool block(const KnownMap& map, std::vector<CellIndex> cells);

  std::unique_ptr<Steering> steering_;
  std::vector<CellIndex> held_;     ///< as planned with last
  std::vector<CellIndex> blocked_;  ///< of them: all, or none
  bool stale_ = false;              ///< what is open changed since
};

}  // namespace skein::gridnav
