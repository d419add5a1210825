// How close two motions of one step come, and a motion and a zone: continuous between the ends of the step.
#pragma once

#include "planner/core/mission/mission.hpp"
#include "simworld/vehicles/constant_speed.hpp"

namespace skein {

/// Least distance in metres between the centres of two vehicles that move through one step together.
[[nodiscard]] double separation_m(const Motion& a, const Motion& b);

/// Least signed distance in metres from the motion of a centre to the zone's surface; negative inside.
[[nodiscard]] double clearance_m(const Motion& motion, const Zone& zone);

/// At most the least distance in metres from the motion of a centre to the ground, and, but for its curvature between
/// the points of the motion, at least that part of the height above it which its steepest slope leaves.
[[nodiscard]] double clearance_m(const Motion& motion, const Terrain& terrain);

}  // namespace skein
