// The obstacles that agents are not told of: listed one by one, and the trees of a generated forest.
//
// An item of hidden_obstacles is a mesh if it has `file`, a terrain if it has `terrain`, a box if it has `x_min_m`, a
// sphere if it has `z_m`, else a cylinder. Trees are upright cylinders at places and with radii that the stream (seed,
// 0, Layout, 0) draws uniformly; one that reaches into a cell that must stay free is left out. Source: papers/004,
// section IV; own forests. Departs from source: none. Complexity: O(items + trees * kept free).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "simworld/scenario/common.hpp"

namespace skein::scenario {

/// How many trees, and how thick.
struct Forest {
  std::uint64_t trees = 0;
  double radius_min_m = 0.0;
  double radius_max_m = 0.0;

  bool operator==(const Forest&) const = default;
};

/// The list hidden_obstacles. @param folder that of the scenario file: mesh files are named from there
[[nodiscard]] std::vector<Obstacle> read_hidden(const MapReader& root, const std::string& folder);

/// The section forest; none if it is left out. Its trees are given by number or by density in `area`.
[[nodiscard]] std::optional<Forest> read_forest(const MapReader& root, const Box& area);

/// @param kept_free boxes into which no tree reaches
[[nodiscard]] std::vector<Obstacle> grow(const Forest& forest, const Box& area, std::span<const Box> kept_free,
                                         std::uint64_t seed);

}  // namespace skein::scenario
