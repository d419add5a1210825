// What stands in the way, seen from above: corners and heights of zones and hidden obstacles, for figures and CSV.
//
// A round shape is a closed polygon of 72 corners, a box its rectangle, a mesh its bounding box; the ground has none.
// Source: none. Departs from source: none. Complexity: O(corners).
#pragma once

#include <vector>

#include "planner/core/geometry/bounds.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein::figure {

/// What agents make of it: they know obstacles, no-fly zones and announced zones, and are not told of hidden ones.
enum class ZoneKind : std::uint8_t { Obstacle, NoFly, Announced, Hidden };

struct Outline {
  ZoneKind kind = ZoneKind::Obstacle;
  std::vector<Vec2> corners_m;  ///< closed: the last is the first; empty of the ground
  Interval heights_m;           ///< from lowest to highest; +-kUnboundedZ_m where there is no end
};

[[nodiscard]] Outline outline_of(const Zone& zone);
[[nodiscard]] Outline outline_of(const Obstacle& hidden);
[[nodiscard]] Outline outline_of(const Announcement& announced);

}  // namespace skein::figure
