// Planned paths point by point, as figures and tables show them: place, curvature and torsion along the arc.
//
// The points lie at equal arc distances s_k = L k / (n - 1), both ends included, each on its own length L.
//
// Source: papers/001, Eq. 2-6 and its figures. Departs from source: none. Complexity: O(n Newton) a path.
#pragma once

#include <vector>

#include "planner/rendezvous/point_separation.hpp"

namespace skein::rendezvous {

struct ProfilePoint {
  double arc_m = 0.0;  ///< from the start
  Vec3 position_m = Vec3::Zero();
  double curvature_per_m = 0.0;  ///< in the plane positive to the left, in space never negative
  double torsion_per_m = 0.0;    ///< 0 in the plane
};

/// The path of one plan at `points` points, by ascending arc. @throws std::invalid_argument as make_problem, for an
/// agent that the mission does not have, a particle that is that of no path, or less than two points.
[[nodiscard]] std::vector<ProfilePoint> path_profile(const Mission& mission, const PlannedPath& path,
                                                     std::size_t points);

}  // namespace skein::rendezvous
