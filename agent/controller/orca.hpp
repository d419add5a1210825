// Optimal reciprocal collision avoidance: the yardstick beside the potential field.
//
// A relative velocity w = v - v' brings two bodies at relative position x nearer than R (radii and margin) within tau
// if it lies in the cone of x and R, cut off by the ball of radius R / tau about x / tau. With u the least change that
// takes w to its boundary, outward normal n there, the own velocity shall be in  n . (v - v_own - s u) >= 0: s = 1/2
// for a neighbour, who does the other half; 1 for a track, which does nothing. Bodies already nearer than R shall be
// clear within one step. A zone is a body at rest at its nearest point. The answer is the velocity nearest to the wish
// in all half-spaces and up to the vehicle's speed; where there is none, the one of least violation (half_spaces.hpp).
// Where wish and motion are level, so is the answer. Columns count by their horizontal offset.
// Source: van den Berg, Guy, Lin, Manocha, 'Reciprocal n-body collision avoidance', ISRR 2009 / STAR 70, 2011, sections
// 4 and 5; own implementation. Departs from source: tau = horizon_s for all; tracks and zones in space as bodies; the
// wish is turned by 1e-3 to the right, about the vertical axis, which breaks the symmetry face to face.
// Complexity: O(bodies) but for crowds (half_spaces.hpp).
#pragma once

#include "agent/controller/half_spaces.hpp"
#include "agent/controller/scene.hpp"

namespace skein {

/// The half-space for a body at `apart_m` (its position less the own) with own and its velocity (m/s), `touch_m` the
/// distance to be kept, `share` of the change that is own. @pre horizon_s, step_s positive
[[nodiscard]] HalfSpace reciprocal(const Vec3& apart_m, const Vec3& own_mps, const Vec3& its_mps, double touch_m,
                                   double share, double horizon_s, double step_s);

/// The velocity (m/s) nearest to the wish that keeps clear for horizon_s; the wish itself, bit by bit, if it does.
[[nodiscard]] Vec3 orca_velocity(const ControllerOptions& options, const VehicleSpec& spec, double step_s,
                                 const Scene& scene, const Vec3& wish_mps);

}  // namespace skein
