// Vehicle that flies in any direction at up to its speed, changes its velocity by at most its acceleration, and hovers.
//
// A step changes the velocity at a constant rate towards the commanded one,
//   v1 = v0 + clip(clip(v_c, v_max) - v0, a_max dt),   x(t) = x0 + v0 t + (v1 - v0) t^2 / (2 dt),
// clip shortening a vector to a length. Heading is left out: it faces the way it moves. The holonomic vehicle is its
// limit without inertia, v1 = clip(v_c, v_max) throughout the step: a straight motion.
// Source: the usual point-mass model of papers/002 and papers/004. Departs from source: none. Complexity: O(1).
#pragma once

#include "simworld/vehicles/constant_speed.hpp"

namespace skein {

/// One step of `dt_s` seconds. @pre spec.speed_mps, spec.max_acceleration_mps2 and dt_s are positive.
[[nodiscard]] VehicleStep advance_multirotor(const VehicleSpec& spec, const VehicleState& state,
                                             const Vec3& commanded_velocity_mps, double dt_s);

/// The same without inertia. @pre spec.speed_mps and dt_s are positive.
[[nodiscard]] VehicleStep advance_holonomic(const VehicleSpec& spec, const VehicleState& state,
                                            const Vec3& commanded_velocity_mps, double dt_s);

/// One step of a vehicle of any type.
[[nodiscard]] VehicleStep advance_vehicle(const VehicleSpec& spec, const VehicleState& state,
                                          const Vec3& commanded_velocity_mps, double dt_s);

}  // namespace skein
