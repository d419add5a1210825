// What the safety filter judges: one step towards a command, then full braking straight to rest.
//
//   x(t) = p + v0 t + (v1 - v0) t^2 / 2dt in the step, to p1 = p + dt (v0 + v1) / 2; then along v1, B(v1) far, to rest.
// The step is a parabola: it lies in the triangle p, p + v0 dt / 2, p1 and leaves its chord by at most
// |component of v1 - v0 across the chord| dt / 8. Braking along v0 at once is the manoeuvre whose step is the first of
// the braking: hence the rest of a manoeuvre, once its step is flown, is a manoeuvre again.
// Source: own; simworld/vehicles/multirotor.hpp for the motion. Departs from source: none. Complexity: O(1).
#pragma once

#include <Eigen/Geometry>

#include "planner/core/geometry/braking.hpp"
#include "planner/core/geometry/clipped.hpp"

namespace skein {

struct Manoeuvre {
  Vec3 start_m = Vec3::Zero();    ///< p
  Vec3 turn_m = Vec3::Zero();     ///< p1: where the braking begins
  Vec3 end_m = Vec3::Zero();      ///< where it stands
  Vec3 direction = Vec3::Zero();  ///< of v1; zero if that is
  double speed_mps = 0.0;         ///< |v1|
  double bow_m = 0.0;             ///< by which the step leaves its chord at most
  double length_m = 0.0;          ///< no less than the way
  double steps = 1.0;             ///< until it stands
};

/// The velocity (m/s) at the end of a step in which a vehicle at v0 is told `command_mps`.
[[nodiscard]] inline Vec3 after_step(const Brakes& brakes, double speed_limit_mps, const Vec3& v0_mps,
                                     const Vec3& command_mps) {
  Vec3 wanted = clipped(command_mps, speed_limit_mps);
  if (brakes.acceleration_mps2 <= 0.0) return wanted;
  return v0_mps + clipped(wanted - v0_mps, brakes.acceleration_mps2 * brakes.step_s);
}

/// The manoeuvre that begins with a step from v0 to v1 (m/s), at a position (m).
[[nodiscard]] inline Manoeuvre manoeuvre(const Brakes& brakes, const Vec3& position_m, const Vec3& v0_mps,
                                         const Vec3& v1_mps) {
  const double dt_s = brakes.step_s;
  const bool inert = brakes.acceleration_mps2 > 0.0;
  const Vec3 change_mps = inert ? Vec3(v1_mps - v0_mps) : Vec3::Zero();
  const Vec3 way_m = dt_s * (v1_mps - 0.5 * change_mps);
  Manoeuvre m;
  m.start_m = position_m;
  m.turn_m = position_m + way_m;
  m.speed_mps = v1_mps.norm();
  if (m.speed_mps > 0.0) m.direction = v1_mps / m.speed_mps;
  const double steps = braking_steps(brakes, m.speed_mps);
  const double braking_m = braked_m(brakes, m.speed_mps, steps);
  m.end_m = m.turn_m + braking_m * m.direction;
  const double way_squared = way_m.squaredNorm();
  if (inert) {
    const double across =
        way_squared > 0.0 ? std::sqrt(way_m.cross(change_mps).squaredNorm() / way_squared) : change_mps.norm();
    m.bow_m = across * dt_s / 8.0;
  }
  m.length_m = 0.5 * dt_s * ((v1_mps - change_mps).norm() + m.speed_mps) + braking_m;
  m.steps = 1.0 + steps;
  return m;
}

}  // namespace skein
