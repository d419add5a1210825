// A vector shortened to a length. Source, Departs from source: none. Complexity: O(1).
#pragma once

#include "planner/core/geometry/types.hpp"

namespace skein {

/// The same direction, at most so long.
[[nodiscard]] inline Vec3 clipped(const Vec3& v, double most) {
  const double size = v.norm();
  return size > most ? Vec3(v * (most / size)) : v;
}

}  // namespace skein
