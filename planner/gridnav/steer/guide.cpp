#include "planner/gridnav/steer/guide.hpp"

#include <algorithm>
#include <utility>

namespace skein::gridnav {

bool Guide::learn(const KnownMap& map, std::span<const CellChange> changed) {
  const bool any = steering_->learn(map, changed);
  stale_ = stale_ || any;
  return any;
}

/// These cells, and no others of those that it blocked before. @return whether that is a change
bool Guide::block(const KnownMap& map, std::vector<CellIndex> cells) {
  std::vector<CellChange> changes;
  for (const CellIndex cell : blocked_) {
    if (!std::ranges::binary_search(cells, cell)) changes.push_back({cell, map.state(cell)});
  }
  for (const CellIndex cell : cells) changes.push_back({cell, CellState::Occupied});
  blocked_ = std::move(cells);
  return !changes.empty() && steering_->learn(map, changes);
}

/// Lines of sight too end at them.
Plan Guide::plan_off_blocked(const Situation& at) {
  if (blocked_.empty()) return steering_->plan(at);
  KnownMap map = at.map;
  for (const CellIndex cell : blocked_) map.set(cell, CellState::Occupied);
  return steering_->plan({map, at.start_m, at.need, at.others});
}

Guide::Around Guide::plan(const Situation& at, std::span<const CellIndex> held) {
  Around around;
  if (complete() && (stale_ || !std::ranges::equal(held, held_))) {
    held_.assign(held.begin(), held.end());
    around.changed = block(at.map, held_);
    stale_ = false;
  }
  around.plan = plan_off_blocked(at);
  if (around.plan.to_go_m < 0 && !blocked_.empty()) {
    around.changed = block(at.map, {}) || around.changed;
    around.plan = plan_off_blocked(at);
  }
  around.through = around.plan.to_go_m >= 0 && blocked_.empty() && !held_.empty();
  return around;
}

}  // namespace skein::gridnav
