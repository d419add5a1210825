// The plane that keeps two vehicles apart which both know where either would stand after full braking.
//
// Of either vehicle's braking tail (the segment from where it is to where it would stand) the closest points a, b give
// the normal n = (a - b) / |a - b|; the plane lies midway between the tails' extents along n, `half_gap_m` from either.
// The result is the same, bit by bit, for both but for the sign of n: the tails are ordered before anything is
// computed. Source: own; elementary geometry (docs/safety.md). Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

struct Segment {
  Vec3 from_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();
};

/// A place x is `normal . x - offset_m` from the plane, positive on the own side.
struct Separation {
  Vec3 normal = Vec3::Zero();  ///< unit; zero if the tails touch
  double offset_m = 0.0;
  double half_gap_m = 0.0;  ///< of either tail to the plane
};

/// Midway between the own and another's tail.
[[nodiscard]] Separation separation(const Segment& own, const Segment& other);

/// Distance (m) of two segments.
[[nodiscard]] double distance_m(const Segment& a, const Segment& b);

}  // namespace skein
