#include "simworld/collision/clearance.hpp"

#include <algorithm>
#include <limits>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/geometry/distance.hpp"

namespace skein {
namespace {

struct Heights {
  double min_m;
  double max_m;
};

Heights heights_of(const Cylinder& cylinder) {
  return {cylinder.z_min_m, cylinder.z_max_m};
}
Heights heights_of(const Box& box) {
  return {box.min_m.z(), box.max_m.z()};
}

/// Beside a shape that is taller than the segment is high, the nearest face is a side: the plane decides.
template <typename Shape>
double segment_clearance_m(const Vec3& a, const Vec3& b, const Shape& shape) {
  const Heights heights = heights_of(shape);
  if (std::min(a.z(), b.z()) >= heights.min_m && std::max(a.z(), b.z()) <= heights.max_m) {
    const double beside_m = signed_distance(Vec2(a.head<2>()), Vec2(b.head<2>()), shape);
    if (beside_m >= 0.0) return beside_m;
  }
  return signed_distance(a, b, shape);
}

}  // namespace

double separation_m(const Motion& a, const Motion& b) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    const Approach approach = closest_approach(a.points_m[p - 1], a.points_m[p], b.points_m[p - 1], b.points_m[p]);
    least_m = std::min(least_m, approach.distance_m);
  }
  return least_m;
}

double clearance_m(const Motion& motion, const Zone& zone) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    const double distance_m = std::visit(
        [&](const auto& shape) { return segment_clearance_m(motion.points_m[p - 1], motion.points_m[p], shape); },
        zone.shape);
    least_m = std::min(least_m, distance_m);
  }
  return least_m;
}

double clearance_m(const Motion& motion, const Terrain& terrain) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    least_m = std::min(least_m, least_height_above_m(terrain, motion.points_m[p - 1], motion.points_m[p]));
  }
  return least_m / tilt_of(terrain);
}

}  // namespace skein
