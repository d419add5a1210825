// Storage of a kernel table: rows of lanes, each row at a multiple of 64 bytes.
//
// Source: none. Departs from source: none. Complexity: O(rows) to copy a lane.
#pragma once

#include <algorithm>
#include <vector>

#include "planner/rendezvous/kernel/kernel.hpp"

namespace skein::rendezvous::kernel {

class LaneTable {
 public:
  LaneTable() = default;
  LaneTable(std::size_t rows, std::size_t lanes) { resize(rows, lanes); }

  /// All numbers become 0. Allocates only beyond the largest size so far.
  void resize(std::size_t rows, std::size_t lanes) {
    rows_ = rows;
    stride_ = padded(lanes);
    lines_.assign(rows * stride_ / kLaneMultiple, Line{});
  }

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] double* row(std::size_t r) { return data() + r * stride_; }
  [[nodiscard]] const double* row(std::size_t r) const { return data() + r * stride_; }
  [[nodiscard]] Table table() { return {data(), stride_}; }
  [[nodiscard]] ConstTable view() const { return {data(), stride_}; }

  /// Copies a lane of a table of as many rows.
  void copy_lane(const LaneTable& from, std::size_t from_lane, std::size_t to_lane) {
    const double* source = from.row(0) + from_lane;
    double* target = row(0) + to_lane;
    for (std::size_t r = 0; r < rows_; ++r) target[r * stride_] = source[r * from.stride_];
  }

  /// Fills the lanes from `used` (at least 1) up to the next multiple of kLaneMultiple with copies of lane 0.
  void pad(std::size_t used) {
    for (std::size_t r = 0; r < rows_; ++r) std::fill(row(r) + used, row(r) + padded(used), row(r)[0]);
  }

 private:
  struct alignas(kLaneMultiple * sizeof(double)) Line {
    double values[kLaneMultiple] = {};
  };

  [[nodiscard]] double* data() { return lines_.empty() ? nullptr : lines_.front().values; }
  [[nodiscard]] const double* data() const { return lines_.empty() ? nullptr : lines_.front().values; }

  std::size_t rows_ = 0;
  std::size_t stride_ = 0;
  std::vector<Line> lines_;
};

}  // namespace skein::rendezvous::kernel
