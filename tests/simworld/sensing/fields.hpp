// Small fields of cells for the tests of sensing, drawn or drawn at random.
#pragma once

#include <string_view>
#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "simworld/sensing/truth_grid.hpp"

namespace skein::test {

/// A plane of 1 m cells as text, the northernmost row first: '#' is an obstacle of just that cell.
inline TruthGrid field(const std::vector<std::string_view>& rows) {
  const auto ny = static_cast<std::int32_t>(rows.size());
  const auto nx = static_cast<std::int32_t>(rows.front().size());
  const CellGrid grid{Vec3::Zero(), 1.0, 1.0, nx, ny, 1};
  std::vector<Obstacle> obstacles;
  for (std::int32_t j = 0; j < ny; ++j) {
    for (std::int32_t i = 0; i < nx; ++i) {
      const std::string_view row = rows[static_cast<std::size_t>(ny - 1 - j)];
      if (row[static_cast<std::size_t>(i)] == '#') obstacles.push_back({grid.box_of({i, j, 0}), "cell"});
    }
  }
  return {grid, obstacles};
}

/// Cells of 2 m by 1 m, each occupied with probability `density`.
inline TruthGrid random_field(std::uint64_t seed, std::int32_t n, std::int32_t levels, double density) {
  const CellGrid grid{Vec3(-3.0, 5.0, 1.0), 2.0, 1.0, n, n, levels};
  RandomStream stream(seed, 0, Purpose::Test, 0);
  std::vector<Obstacle> obstacles;
  for (CellIndex cell = 0; cell < grid.size(); ++cell) {
    if (stream.uniform() < density) obstacles.push_back({grid.box_of(grid.cell_at(cell)), "cell"});
  }
  return {grid, obstacles};
}

}  // namespace skein::test
