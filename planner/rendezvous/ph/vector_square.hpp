// The 'square' of a vector in space, as w^2 is of a complex number: r' = A u A* of a pure quaternion A.
//
// With u the first axis: q(a) = 2 (a . u) a - |a|^2 u, its bilinear form product(a, b) = (a . u) b + (b . u) a
// - (a . b) u, and root(v) the vector a with a . u >= 0 and q(a) = v: it bisects u and v, and |a|^2 = |v|.
// Source: Farouki, al-Kandari, Sakkalis, Adv. Comput. Math. 17 (2002). Departs from source: none. Complexity: O(1).
#pragma once

#include <cmath>

#include "planner/core/geometry/types.hpp"

namespace skein::rendezvous::ph {

/// (x u y* + y u x*) / 2 of pure quaternions, u the first axis: half the change of r' with both factors.
[[nodiscard]] inline Vec3 product(const Vec3& x, const Vec3& y) {
  return {x[0] * y[0] - x[1] * y[1] - x[2] * y[2], x[0] * y[1] + x[1] * y[0], x[0] * y[2] + x[2] * y[0]};
}

[[nodiscard]] inline Vec3 square(const Vec3& a) {
  return 2.0 * a[0] * a - a.squaredNorm() * Vec3::UnitX();
}

/// a with square(a) = v and a1 not negative; of -e1 the one along the second axis.
[[nodiscard]] inline Vec3 root(const Vec3& v) {
  const double modulus = v.norm();
  if (modulus == 0.0) return Vec3::Zero();
  const double larger = std::sqrt(0.5 * (modulus + std::fabs(v[0])));
  if (v[0] >= 0.0) return {larger, 0.5 * v[1] / larger, 0.5 * v[2] / larger};
  const double across = std::sqrt(v[1] * v[1] + v[2] * v[2]);
  if (across == 0.0) return {0.0, larger, 0.0};
  return {0.5 * across / larger, larger * v[1] / across, larger * v[2] / across};
}

}  // namespace skein::rendezvous::ph
