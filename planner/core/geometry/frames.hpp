// Directions of poses, and headings of directions.
//
// World ENU: heading chi turns counter-clockwise from east, climb gamma upwards;
// d = (cos gamma cos chi, cos gamma sin chi, sin gamma).
// Source: papers/001, section 2.1. Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

/// Unit vector of motion of a pose, world frame.
[[nodiscard]] Vec3 direction_of(const Pose& pose);

/// Unit vector of a heading (rad) in the horizontal plane.
[[nodiscard]] Vec2 direction_of_heading(double heading_rad);

/// Heading (rad, in [-pi, pi]) of a horizontal vector; 0 for the zero vector.
[[nodiscard]] double heading_of(const Vec2& direction);

/// A vector turned counter-clockwise by an angle (rad).
[[nodiscard]] Vec2 rotated(const Vec2& v, double angle_rad);

}  // namespace skein
