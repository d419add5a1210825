// The place of a zone that is nearest to a point.
//
// Source: elementary. Departs from source: none. Complexity: O(1).
#pragma once

#include "agent/controller/scene.hpp"

namespace skein {

/// @return a place on or in the shape (m); the point itself if it is inside
[[nodiscard]] inline Vec3 nearest_point(const Vec3& point_m, const Cylinder& cylinder) {
  const Vec2 offset_m = point_m.head<2>() - cylinder.centre_m;
  const double distance_m = offset_m.norm();
  Vec3 nearest_m = point_m;
  if (distance_m > cylinder.radius_m) {
    nearest_m.head<2>() = cylinder.centre_m + cylinder.radius_m / distance_m * offset_m;
  }
  if (point_m.z() < cylinder.z_min_m) nearest_m.z() = cylinder.z_min_m;
  if (point_m.z() > cylinder.z_max_m) nearest_m.z() = cylinder.z_max_m;
  return nearest_m;
}
[[nodiscard]] inline Vec3 nearest_point(const Vec3& point_m, const Box& box) {
  return point_m.cwiseMax(box.min_m).cwiseMin(box.max_m);
}
[[nodiscard]] inline Vec3 nearest_point(const Vec3& point_m, const ZoneShape& zone) {
  return std::visit([&](const auto& shape) { return nearest_point(point_m, shape); }, zone);
}

}  // namespace skein
