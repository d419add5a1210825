#include "planner/core/geometry/closest_approach.hpp"

#include <algorithm>

namespace skein {
namespace {

template <typename Vec>
Approach approach(const Vec& a0, const Vec& a1, const Vec& b0, const Vec& b1) {
  const Vec d0 = a0 - b0;
  const Vec change = (a1 - a0) - (b1 - b0);
  const double speed_squared = change.squaredNorm();
  const double fraction = speed_squared > 0.0 ? std::clamp(-d0.dot(change) / speed_squared, 0.0, 1.0) : 0.0;
  const Vec nearest = d0 + fraction * change;
  return {nearest.norm(), fraction};
}

}  // namespace

Approach closest_approach(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  return approach(a0, a1, b0, b1);
}

Approach closest_approach(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  return approach(a0, a1, b0, b1);
}

}  // namespace skein
