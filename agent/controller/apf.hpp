// The artificial potential field: attraction to what the plan wants, repulsion from what will come too near.
//
//   v = wish + sum over bodies of  v_max F(x / 3) (1 - t_c / H) g  e,    clipped to v_max
// t_c is when own and other's straight motions are closest, within the horizon H; c the offset from the other then, x =
// |c| / D_safe, D_safe the sum of radii and margin. F is Eq. 6: 1 - 9/20 x up to 2, (3 - x) / 10 up to 3, then 0; g
// rises from 0 to 1 with the closing speed, up to 1 m/s. So who rests among resting others is left alone. Only nearer
// than D_safe rest does not count: then 1 - |q| / D_safe pushes along the present offset q.
// Face to face c says nothing of where to go, and two that push alike stay so. The rule that breaks the symmetry:
// everybody gives way to the right. e is the direction of c + 0.3 D_safe r, with r to the right of the motion relative
// to the other, about the vertical axis; if that motion is vertical, r is east. What moves by itself besides is kept
// at a distance, and evaded (evasion.hpp). A zone is a body at its nearest point, with no radius of its own; for zones
// and bodies that never move x is not divided by 3. Peers push in proportion to the speed of the wish: who is about to
// arrive gives less way to those that mind it too, so that several can close in on one goal.
// Where wish and motion are level, so is the answer: planar scenes stay planar.
// Source: papers/002, Eq. 4 and 6. Departs from source: a sum instead of the weighted average; forces are velocities;
// repulsion from the predicted closest approach instead of the present distance, and with a wider reach, so that what
// moves is evaded early; the rule of the right hand. Complexity: O(bodies).
#pragma once

#include "agent/controller/scene.hpp"

namespace skein {

/// The velocity (m/s) that draws a vehicle to a goal `to_goal_m` away (m): constant far, on the way such that half its
/// acceleration brakes, linear within one second's acceleration (Eq. 4). @pre speed_mps, acceleration_mps2 positive
[[nodiscard]] Vec3 attraction(const Vec3& to_goal_m, double speed_mps, double acceleration_mps2);

/// Eq. 6: the repulsion at x = distance / D_safe, from 1 to 0. @pre x >= 0
[[nodiscard]] double repulsion(double x);

/// What the field makes of a wish (m/s): the wish itself, bit by bit, with nothing within reach.
/// @pre spec.speed_mps > 0, of a multirotor max_acceleration_mps2 as well, horizon_s not negative
[[nodiscard]] Vec3 apf_velocity(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene,
                                const Vec3& wish_mps);

}  // namespace skein
