// Tiles of 8 x 8 cells of one level: where a cell is in them, and the join of two of their states.
//
//   join((e, c), (f, d)) = the one of the higher epoch, whole; at equal epochs (e, cell-wise maximum of c and d)
// The lexicographic product of a chain and a semilattice: commutative, associative, idempotent.
// Source: Shapiro, Preguica, Baquero, Zawirski, 'Conflict-free replicated data types', SSS 2011; papers/004, section
// IV-B2, for 2 bits a cell. Departs from source: epochs, so that a cell can become free again. Complexity: O(1).
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstdint>

#include "planner/core/cells/cell_grid.hpp"

namespace skein {

inline constexpr std::int32_t kTileEdge = 8;

/// Cell n of a tile, row by row, is in bits 2n and 2n + 1 of the two words.
using TileCells = std::array<std::uint64_t, 2>;

struct TileState {
  std::uint32_t epoch = 0;
  TileCells cells{};

  bool operator==(const TileState&) const = default;
};

namespace tile_bits {

inline constexpr std::uint64_t kLow = 0x5555555555555555ULL;  ///< the lower bit of each cell

/// The larger of two cells, 32 at a time.
[[nodiscard]] constexpr std::uint64_t max_of(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t a_high = (a >> 1) & kLow;
  const std::uint64_t b_high = (b >> 1) & kLow;
  const std::uint64_t at_least = (a_high & ~b_high) | (~(a_high ^ b_high) & (a | ~b) & kLow);
  const std::uint64_t takes_a = at_least | (at_least << 1);
  return (a & takes_a) | (b & ~takes_a);
}

/// Both bits of each cell that is not Unknown.
[[nodiscard]] constexpr std::uint64_t known(std::uint64_t word) {
  const std::uint64_t low = (word | (word >> 1)) & kLow;
  return low | (low << 1);
}

}  // namespace tile_bits

[[nodiscard]] constexpr TileState join(const TileState& a, const TileState& b) {
  if (a.epoch != b.epoch) return a.epoch > b.epoch ? a : b;
  return {a.epoch, {tile_bits::max_of(a.cells[0], b.cells[0]), tile_bits::max_of(a.cells[1], b.cells[1])}};
}

/// The cells of `older` that `newer` does not know; the others Unknown.
[[nodiscard]] constexpr TileCells missing_in(const TileCells& newer, const TileCells& older) {
  return {older[0] & ~tile_bits::known(newer[0]), older[1] & ~tile_bits::known(newer[1])};
}

[[nodiscard]] constexpr int known_cells(const TileCells& cells) {
  return (std::popcount(tile_bits::known(cells[0])) + std::popcount(tile_bits::known(cells[1]))) / 2;
}

/// @pre n < 64
[[nodiscard]] constexpr CellState cell_in(const TileCells& cells, std::uint32_t n) {
  return static_cast<CellState>((cells[n / 32] >> (2 * (n % 32))) & 3U);
}
constexpr void set_cell(TileCells& cells, std::uint32_t n, CellState state) {
  const std::uint32_t shift = 2 * (n % 32);
  cells[n / 32] = (cells[n / 32] & ~(std::uint64_t{3} << shift)) | (static_cast<std::uint64_t>(state) << shift);
}

struct TilePlace {
  std::uint32_t tile = 0;
  std::uint32_t n = 0;  ///< of the cell in it, 0 to 63
};

/// The tiles over a grid of cells; those at the upper edges may stick out.
struct TileGrid {
  CellGrid cells;
  std::int32_t nx = 0;
  std::int32_t ny = 0;

  explicit TileGrid(const CellGrid& grid)
      : cells(grid), nx((grid.nx + kTileEdge - 1) / kTileEdge), ny((grid.ny + kTileEdge - 1) / kTileEdge) {}

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(cells.nz);
  }
  [[nodiscard]] TilePlace place_of(const Cell& c) const {
    const std::int32_t tile = (c.k * ny + c.j / kTileEdge) * nx + c.i / kTileEdge;
    return {static_cast<std::uint32_t>(tile),
            static_cast<std::uint32_t>((c.j % kTileEdge) * kTileEdge + c.i % kTileEdge)};
  }
  /// Also outside the grid, where the tile sticks out.
  [[nodiscard]] Cell cell_at(const TilePlace& place) const {
    const auto tile = static_cast<std::int32_t>(place.tile);
    const auto n = static_cast<std::int32_t>(place.n);
    return {tile % nx * kTileEdge + n % kTileEdge, tile / nx % ny * kTileEdge + n / kTileEdge, tile / (nx * ny)};
  }
  [[nodiscard]] Vec3 centre_m(std::uint32_t tile) const {
    const Cell low = cell_at({tile, 0});
    constexpr double kHalf = kTileEdge / 2.0;
    return cells.origin_m +
           Vec3((low.i + kHalf) * cells.cell_m, (low.j + kHalf) * cells.cell_m, (low.k + 0.5) * cells.height_m);
  }
};

}  // namespace skein
