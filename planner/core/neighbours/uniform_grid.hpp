// Which of many points are near a place: a grid of cells, each with the points in it.
//
// Points are counted into cells of one size and sorted by cell, then by index; a query visits the cells that its ball
// meets. Cells are hashed into a table of at least as many slots as there are points, so that neither the extent of
// the points nor empty space costs anything; points of other cells that share a slot fail the distance test.
// Source: elementary. Departs from source: none. Complexity: O(n) to build; a query O(cells met + points in them).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planner/core/geometry/types.hpp"

namespace skein {

class UniformGrid {
 public:
  /// @param points_m copied. @param cell_m about the radius that will be asked for
  /// @throws std::invalid_argument if cell_m is not positive and finite, or a point is not finite
  UniformGrid(std::span<const Vec3> points_m, double cell_m);

  /// Indices of the points at most `radius_m` from a place, ascending; `found` is overwritten.
  /// A place or radius that is not finite finds nothing.
  void within(const Vec3& place_m, double radius_m, std::vector<std::uint32_t>& found) const;

  [[nodiscard]] std::size_t size() const { return order_.size(); }

 private:
  [[nodiscard]] std::size_t slot_of(std::int64_t i, std::int64_t j, std::int64_t k) const;

  double cell_m_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begin_;  ///< by slot, into order_; one more than slots
  std::vector<std::uint32_t> order_;  ///< indices of points, by slot
  std::vector<Vec3> sorted_m_;        ///< the points themselves, in that order
};

}  // namespace skein
