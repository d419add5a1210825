#include "planner/core/geometry/frames.hpp"

#include "planner/core/math/det_math.hpp"

namespace skein {

Vec3 direction_of(const Pose& pose) {
  const math::SinCos chi = math::sincos(pose.heading_rad);
  const math::SinCos gamma = math::sincos(pose.climb_rad);
  return {gamma.cos * chi.cos, gamma.cos * chi.sin, gamma.sin};
}

Vec2 direction_of_heading(double heading_rad) {
  const math::SinCos chi = math::sincos(heading_rad);
  return {chi.cos, chi.sin};
}

double heading_of(const Vec2& direction) {
  return math::atan2(direction.y(), direction.x());
}

Vec2 rotated(const Vec2& v, double angle_rad) {
  const math::SinCos a = math::sincos(angle_rad);
  return {a.cos * v.x() - a.sin * v.y(), a.sin * v.x() + a.cos * v.y()};
}

}  // namespace skein
