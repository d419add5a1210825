// Maps for tests of navigators: mazes, forests, the power station.
#pragma once

#include "tests/planner/gridnav/swarm_world.hpp"

namespace skein::gridnav {

/// A plane of nx x ny cells, each occupied with a probability; starts and goals in distinct free cells.
[[nodiscard]] Layout forest(std::uint64_t seed, std::int32_t nx, std::int32_t ny, double density, double cell_m,
                            std::size_t uavs);
/// The same in space.
[[nodiscard]] Layout forest_in_space(std::uint64_t seed, const CellGrid& grid, double density, std::size_t uavs);
/// The power station, a cell occupied if any box overlaps it; the first `uavs` starts, one goal.
[[nodiscard]] Layout power_station(double cell_m, std::size_t uavs);

}  // namespace skein::gridnav
