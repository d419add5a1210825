// Closest approach of two points that both move in a straight line at constant speed during one step.
//
// With d(f) = (a0 - b0) + f ((a1 - a0) - (b1 - b0)) and f in [0, 1], |d|^2 is a parabola in f; its minimum is at
// f = -d0 . dv / |dv|^2, clamped to the step. Points that keep their distance are closest at f = 0.
// Source: elementary. Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

struct Approach {
  double distance_m = 0.0;
  double fraction = 0.0;  ///< of the step, in [0, 1]; the first one if there are several
};

/// One point moves from a0 to a1 while the other moves from b0 to b1 (m, same frame).
[[nodiscard]] Approach closest_approach(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1);
[[nodiscard]] Approach closest_approach(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace skein
