// Signed distances of points and segments to upright cylinders and axis-aligned boxes.
//
// The signed distance is positive outside and the negative depth inside (the way to the nearest face). Of a segment it
// is the least over its points, so a negative value is the depth of its deepest point. Both shapes are convex, hence
// the signed distance is a convex function of the place on the segment:
//   circle            |centre - segment| - r
//   box, outside      sum of squares of piecewise linear terms: its derivative is piecewise linear, the root is exact
//   box, inside       the largest of 2 n linear terms: the least is at an end or where two of them cross
//   cylinder in space the terms mix a root and a line; golden section narrows the convex function to rounding
// Two-dimensional versions take the footprint and leave heights out.
// Source: elementary. Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

/// Distances (m) in the plane, of a point p or of the segment from a to b, to the footprint of a shape.
[[nodiscard]] double signed_distance(const Vec2& p, const Cylinder& cylinder);
[[nodiscard]] double signed_distance(const Vec2& p, const Box& box);
[[nodiscard]] double signed_distance(const Vec2& a, const Vec2& b, const Cylinder& cylinder);
[[nodiscard]] double signed_distance(const Vec2& a, const Vec2& b, const Box& box);

/// Distances (m) in space.
[[nodiscard]] double signed_distance(const Vec3& p, const Cylinder& cylinder);
[[nodiscard]] double signed_distance(const Vec3& p, const Box& box);
[[nodiscard]] double signed_distance(const Vec3& a, const Vec3& b, const Cylinder& cylinder);
[[nodiscard]] double signed_distance(const Vec3& a, const Vec3& b, const Box& box);

/// Distance (m) of a point to the segment from a to b; never negative.
[[nodiscard]] double point_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);
[[nodiscard]] double point_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

}  // namespace skein
