// Keeps a multirotor at a reference that moves along a planned path, from rest at its start to rest at its end.
//
// The reference's arc length follows the trapezoidal profile of speed v and tangential acceleration a,
//   s(t) = a t^2 / 2, then v t - v^2 / 2a, then L - a (T - t)^2 / 2,   T = L / v + v / a  (or, if L < v^2 / a,
//   without the middle part, T = 2 sqrt(L / a)),
// so that vehicles on paths of one length move, and arrive, in step. With p(t) the reference's position the velocity to
// have at the end of a step is that of the reference there plus the gain times the error at its start,
//   v_c = (p(t + 3/2 dt) - p(t + dt/2)) / dt + k (p(t) - x),   k = 1 / (2 dt).
// a is half of what the vehicle can do: the rest is left to the path's curvature and to corrections.
// Source: own; papers/002 and papers/004 attract to a goal, here the goal moves. Complexity: O(1) a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class MovingReference {
 public:
  /// @pre spec.speed_mps, spec.max_acceleration_mps2 and step_s are positive
  MovingReference(const VehicleSpec& spec, double step_s)
      : speed_mps_(spec.speed_mps), acceleration_mps2_(0.5 * spec.max_acceleration_mps2), step_s_(step_s) {}

  struct Command {
    Vec3 velocity_mps = Vec3::Zero();  ///< to have at the end of the step
    bool path_flown = false;           ///< the reference rests at the path's end
  };

  /// Arc length (m) of the reference `t_s` seconds after the start, on a path of `length_m`.
  [[nodiscard]] double travelled_m(double length_m, double t_s) const;

  /// The command of the next step for a vehicle at a position (m); one call a step. `position_at`: arc length (m) to
  /// position (m) on the path.
  template <typename PositionAt>
  [[nodiscard]] Command command(double length_m, const PositionAt& position_at, const Vec3& position_m) {
    const double t_s = static_cast<double>(steps_++) * step_s_;
    const auto reference = [&](double ahead) -> Vec3 {
      return position_at(travelled_m(length_m, std::max(0.0, t_s + ahead * step_s_)));
    };
    const Vec3 feed = (reference(1.5) - reference(0.5)) / step_s_;
    return {feed + 0.5 / step_s_ * (reference(0.0) - position_m), travelled_m(length_m, t_s) >= length_m};
  }

  void add_to(StateHash& hash) const { hash.add(steps_); }

 private:
  double speed_mps_;
  double acceleration_mps2_;
  double step_s_;
  std::uint32_t steps_ = 0;
};

}  // namespace skein
