// The matrices pot and avoid of papers/004: potentials of cells, as one UAV sums them.
//
//   sum(c) = goal(c) + alpha / 2 beside obstacles + raises(c) + alpha beside neighbours
// Readings, where the paper leaves it open: overlapping alpha / 2 fields count once; cells of obstacles are shut, not
// merely high; a cell that another UAV has marked as revisited counts as raised once; the anticipation of reference
// [10] is not known, and left out. Source: papers/004, Eq. 1 and 2, section III-C. Departs from source: the readings.
// Complexity: O(1) a cell; 9 or 27 a change; O(neighbours) for avoid.
#pragma once

#include <span>
#include <vector>

#include "planner/gridnav/steer/steering.hpp"

namespace skein::gridnav {

class PotentialTable {
 public:
  explicit PotentialTable(const Task& task);

  /// Takes changes in. @return whether any cell became blocked or open
  bool learn(std::span<const CellChange> changed);
  /// The matrix avoid, anew: alpha in the cells around each neighbour that a sensor reaches.
  void avoid(const Vec3& own_m, std::span<const Other> others);
  [[nodiscard]] double sum(CellIndex cell) const;
  void raise(CellIndex cell, double by) { raised_[cell] += by; }
  [[nodiscard]] double alpha() const { return alpha_; }
  [[nodiscard]] double minimum_raise() const { return minimum_raise_; }
  [[nodiscard]] bool occupied(const Cell& c) const { return !grid_.contains(c) || occupied_[grid_.index_of(c)] != 0; }
  /// Cells that one move without a cut corner leads to.
  void cells_around(const Cell& c, std::vector<Cell>& cells) const;
  /// Whether the cell is one of those around a neighbour.
  [[nodiscard]] bool near_neighbour(const Cell& c) const;

 private:
  template <typename Visit>
  void for_around(const Cell& c, Visit visit) const;

  CellGrid grid_;
  Cell goal_;
  double alpha_;
  double minimum_raise_;
  double detected_m_;  ///< within which a neighbour is avoided
  std::vector<double> raised_;
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint8_t> beside_;  ///< occupied cells around
  std::vector<std::uint8_t> revisited_;
  std::vector<Cell> neighbours_;
};

}  // namespace skein::gridnav
