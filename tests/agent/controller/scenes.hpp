// Random scenes for the closed loop.
#pragma once

#include "tests/agent/controller/closed_loop.hpp"

namespace skein::test {

/// What the guarantee is about: 1 to 8 UAVs of 10 m/s and 4 m/s2 cross 100 x 100 m among 10 obstacles of 0.5 to
/// `speed_mps`, radii 0.5 to 2 m, of all ways to move; sensor 24 m. Half the scenes are planar.
[[nodiscard]] Loop random_scene(std::uint64_t seed, double speed_mps = 5.0, double sensor_m = 24.0);

/// 6 UAVs cross 100 x 100 m among 10 things that never move, half of them seen only within 24 m, half of them zones.
[[nodiscard]] Loop static_scene(std::uint64_t seed);

/// N UAVs on a sphere swap places with the opposite ones, among N / 4 + 4 moving spheres.
[[nodiscard]] Loop sphere_swap(std::uint64_t seed, std::size_t uavs);

}  // namespace skein::test
