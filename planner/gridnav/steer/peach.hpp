// Peach: in each decision to the one of 9 (27) cells with the smallest potential.
//
// If that is the own cell, a local minimum, its potential is raised and the cell marked as revisited; so is a cell to
// which the UAV comes back, else two that avoid each other swing between two cells for ever.
// Source: papers/004, Algorithm 1. Departs from source: readings of potential_table.hpp; corners are not cut, so that a
// body fits; a motion is flown only if right of way permits it. It may never arrive. Complexity: O(1) a decision.
#pragma once

#include "planner/gridnav/steer/potential_table.hpp"

namespace skein::gridnav {

class Peach final : public Steering {
 public:
  explicit Peach(const Task& task) : task_(task), table_(task), visited_(task.grid.size(), 0) {}

  bool learn(const KnownMap&, std::span<const CellChange> changed) override { return table_.learn(changed); }
  [[nodiscard]] Plan plan(const Situation& at) override;
  [[nodiscard]] std::array<CellIndex, 4> way_from(const KnownMap& map, const Vec3& end_m) override;

 private:
  Task task_;
  PotentialTable table_;
  std::vector<std::uint8_t> visited_;
  CellIndex last_ = ~CellIndex{0};
  std::vector<Cell> around_;
};

}  // namespace skein::gridnav
