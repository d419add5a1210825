// How far, and how long, a vehicle goes on until it stands, to the step.
//
// A multirotor that is told to stop loses a dt of its speed v in every step, and what is left, r <= a dt, in the last:
//   n = ceil(v / (a dt)) steps,  r = v - (n - 1) a dt,  B(v) = (v^2 - r^2) / 2a + r dt / 2,
// straight on; B exceeds v^2 / 2a by at most a dt^2 / 8. One step at v before it (the step in which something is seen
// for the first time) makes S(v) = v dt + B(v) and T(v) = dt + n dt. A vehicle without inertia (acceleration 0) stands
// at once: B = 0, n = 0.
// Source: simworld/vehicles/multirotor.hpp. Departs from source: none. Complexity: O(1).
#pragma once

#include <cmath>

namespace skein {

/// What a vehicle brakes with: its acceleration (m/s^2; 0: no inertia) and the length of a step (s), which is positive.
struct Brakes {
  double acceleration_mps2 = 0.0;
  double step_s = 0.0;
};

/// n: steps until a vehicle of a speed (m/s, not negative) stands.
[[nodiscard]] inline double braking_steps(const Brakes& brakes, double speed_mps) {
  if (brakes.acceleration_mps2 <= 0.0) return 0.0;
  return std::ceil(speed_mps / (brakes.acceleration_mps2 * brakes.step_s));
}

/// Metres that `steps` of braking from a speed (m/s) take; B(v) once it stands. @pre steps is whole, 0 <= steps
[[nodiscard]] inline double braked_m(const Brakes& brakes, double speed_mps, double steps) {
  const double a = brakes.acceleration_mps2;
  if (a <= 0.0 || speed_mps <= 0.0) return 0.0;
  const double all = braking_steps(brakes, speed_mps);
  const double t_s = brakes.step_s * steps;
  if (steps < all) return t_s * (speed_mps - 0.5 * a * t_s);
  const double last_mps = speed_mps - (all - 1.0) * a * brakes.step_s;
  return 0.5 * (speed_mps * speed_mps - last_mps * last_mps) / a + 0.5 * last_mps * brakes.step_s;
}

/// B(v): metres until it stands.
[[nodiscard]] inline double braking_distance_m(const Brakes& brakes, double speed_mps) {
  return braked_m(brakes, speed_mps, braking_steps(brakes, speed_mps));
}

/// S(v): metres of one step at a speed (m/s) and of full braking from it.
[[nodiscard]] inline double stopping_distance_m(const Brakes& brakes, double speed_mps) {
  return speed_mps * brakes.step_s + braking_distance_m(brakes, speed_mps);
}

/// Not less than S(v), and simpler.
[[nodiscard]] inline double stopping_bound_m(const Brakes& brakes, double speed_mps) {
  const double a = brakes.acceleration_mps2;
  if (a <= 0.0) return speed_mps * brakes.step_s;
  return speed_mps * brakes.step_s + 0.5 * speed_mps * speed_mps / a + 0.125 * a * brakes.step_s * brakes.step_s;
}

/// T(v): seconds of the same.
[[nodiscard]] inline double stopping_time_s(const Brakes& brakes, double speed_mps) {
  return brakes.step_s * (1.0 + braking_steps(brakes, speed_mps));
}

}  // namespace skein
