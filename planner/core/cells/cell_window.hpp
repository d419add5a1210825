// A block of cells and what a sensor saw of each, 2 bits a cell.
//
// Cell (low.i + i, low.j + j, low.k + k) is number n = (k * nj + j) * ni + i, in bits 2 (n mod 4) of byte n / 4;
// Unknown: it was not seen. Source: papers/004, section IV-B2 (2 bits a cell). Departs from source: a block of the map.
// Complexity: O(1) a cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"

namespace skein {

inline constexpr std::size_t kMaxSightBytes = 49152;  ///< of a window on the wire, within one datagram

struct CellWindow {
  Cell low;
  std::int32_t ni = 0;
  std::int32_t nj = 0;
  std::int32_t nk = 0;
  std::vector<std::uint8_t> packed;

  /// All Unknown. @pre no size under 0
  [[nodiscard]] static CellWindow of(const Cell& low, std::int32_t ni, std::int32_t nj, std::int32_t nk) {
    CellWindow window{low, ni, nj, nk, {}};
    window.packed.resize((window.size() + 3) / 4, 0);
    return window;
  }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(ni) * static_cast<std::size_t>(nj) * static_cast<std::size_t>(nk);
  }
  /// @pre n < size()
  [[nodiscard]] CellState at(std::size_t n) const {
    return static_cast<CellState>((packed[n / 4] >> (2 * (n % 4))) & 3U);
  }
  /// @pre n < size()
  void set(std::size_t n, CellState state) {
    const auto shift = 2 * (n % 4);
    const unsigned cleared = packed[n / 4] & ~(3U << shift);
    packed[n / 4] = static_cast<std::uint8_t>(cleared | (static_cast<unsigned>(state) << shift));
  }
  /// What was seen of a cell of the grid; Unknown outside the window.
  [[nodiscard]] CellState at(const Cell& c) const {
    const Cell d{c.i - low.i, c.j - low.j, c.k - low.k};
    if (d.i < 0 || d.j < 0 || d.k < 0 || d.i >= ni || d.j >= nj || d.k >= nk) return CellState::Unknown;
    const std::int32_t place = (d.k * nj + d.j) * ni + d.i;
    return at(static_cast<std::size_t>(place));
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Cell cell(std::size_t n) const {
    const auto place = static_cast<std::int32_t>(n);
    return {low.i + place % ni, low.j + place / ni % nj, low.k + place / (ni * nj)};
  }

  bool operator==(const CellWindow&) const = default;
};

}  // namespace skein
