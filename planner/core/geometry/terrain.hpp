// Terrain as a smooth function of place, and how high a point or a segment is above it.
//
//   H(x, y) = a sin(x + b) + c sin(y + d) + e cos(f sqrt(x^2 + y^2)) + g sin(h x + l y)              (Eq. 13)
// with x, y and H in units of `unit_m`. Its slope is nowhere more than
//   k = sqrt(a^2 + c^2) + |e f| + |g| sqrt(h^2 + l^2),
// its curvature along any line nowhere more than c = (max(|a|, |c|) + |e| f^2 + |g| (h^2 + l^2)) / unit_m. Hence a
// point at height v above the ground is at least v / sqrt(1 + k^2) away from it (its tilt is sqrt(1 + k^2)), and along
// a chord of length h the height is nowhere below the line through its ends by more than c h^2 / 8.
//
// Source: papers/001, Eq. 13. Departs from source: bounds between samples. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

/// The constants of Eq. 13; all 0 is level ground at height 0.
struct Terrain {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double d = 0.0;
  double e = 0.0;
  double f = 0.0;
  double g = 0.0;
  double h = 0.0;
  double l = 0.0;
  double unit_m = 1.0;

  bool operator==(const Terrain&) const = default;
};

/// Height (m) of the ground at a place (m).
[[nodiscard]] double ground_m(const Terrain& terrain, const Vec2& place_m);
/// At least the height (m) of the ground anywhere.
[[nodiscard]] double highest_m(const Terrain& terrain);
/// At least the slope of the ground anywhere.
[[nodiscard]] double slope_bound(const Terrain& terrain);
/// sqrt(1 + slope_bound^2): height above the ground that is enough for a distance of 1 from it.
[[nodiscard]] double tilt_of(const Terrain& terrain);
/// At least the second derivative (1/m) of the ground's height along any horizontal line.
[[nodiscard]] double bend_bound_per_m(const Terrain& terrain);

/// Height (m) of a point above the ground below it; negative under ground.
[[nodiscard]] double height_above_m(const Terrain& terrain, const Vec3& p);
/// At most the least height (m) of the segment from a to b above the ground, and at most bend * length^2 / 8 less.
[[nodiscard]] double least_height_above_m(const Terrain& terrain, const Vec3& a, const Vec3& b);

}  // namespace skein
