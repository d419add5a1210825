// Vehicle that flies at one speed and turns with a bounded curvature: the UAV of papers/001.
//
// A step turns the direction of motion at a constant rate from the current one towards the commanded one, by at most
// max_curvature * speed * dt; the motion is a circular arc of length speed * dt. With unit directions u0, u1 and the
// angle theta between them the chord is (u0 + u1) / |u0 + u1| * speed * dt * sin(theta / 2) / (theta / 2).
// Departs from source: none; the paper assumes the same constant speed for all (section 2.1).
#pragma once

#include <array>

#include "planner/core/mission/mission.hpp"

namespace skein {

/// Position in metres and velocity in m/s, world frame.
struct VehicleState {
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();

  bool operator==(const VehicleState&) const = default;
};

/// Where a vehicle is at equal parts of a step, start and end included. Straight between them: an arc deviates from it
/// by at most curvature * (speed * dt / 4)^2 / 8.
inline constexpr std::size_t kMotionPoints = 5;

struct Motion {
  std::array<Vec3, kMotionPoints> points_m{};
  double curvature_per_m = 0.0;  ///< of the arc flown
  double length_m = 0.0;
};

struct VehicleStep {
  VehicleState after;
  Motion motion;
};

/// The state in which a vehicle starts its flight: at its start pose, at its speed, or hovering if it can.
[[nodiscard]] VehicleState initial_state(const VehicleSpec& spec);

/// Where the vehicle is and which way it moves; east if it hovers.
[[nodiscard]] Pose pose_of(const VehicleState& state);

/// One step of `dt_s` seconds.
/// @param commanded_velocity_mps only its direction counts; zero or near zero keeps the current direction.
/// @pre spec.speed_mps > 0, dt_s > 0; |state.velocity_mps| equals spec.speed_mps up to rounding.
[[nodiscard]] VehicleStep advance_constant_speed(const VehicleSpec& spec, const VehicleState& state,
                                                 const Vec3& commanded_velocity_mps, double dt_s);

}  // namespace skein
