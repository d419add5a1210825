// Keeps a multirotor at a reference that moves along a planned path, from rest at its start to rest at its end.
//
// The reference's arc length follows the trapezoidal profile of speed v and tangential acceleration a,
//   s(t) = a t^2 / 2, then v t - v^2 / 2a, then L - a (T - t)^2 / 2,   T = L / v + v / a  (or, if L < v^2 / a,
//   without the middle part, T = 2 sqrt(L / a)),
// so that vehicles on paths of one length move, and arrive, in step. With p(t) the reference's position the velocity to
// have at the end of a step is that of the reference there plus the gain times the error at its start,
//   v_c = (p(t + 3/2 dt) - p(t + dt/2)) / dt + k (p(t) - x),   k = 1 / (2 dt).
// a is half of what the vehicle can do: the rest is left to the path's curvature and to corrections. Who may fall
// behind flies with a share of its speed, so that it can catch up, and k shrinks with the error e to sqrt(2 a / |e|):
// from any distance it comes to rest without overshooting.
// A reference that brakes leaves the profile and comes to rest, s(t) = s0 + v0 t - b t^2 / 2; all that brake in one
// step with one b stay in step. From there it may draw back along the path, with the same profile from rest to rest.
// Source: own; papers/002 and papers/004 attract to a goal, here the goal moves. Complexity: O(1) a step.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class MovingReference {
 public:
  /// @param share of the speed that the reference has. @pre spec.speed_mps, spec.max_acceleration_mps2 and step_s are
  /// positive; 0 < share <= 1
  MovingReference(const VehicleSpec& spec, double step_s, double share = 1.0)
      : speed_mps_(share * spec.speed_mps),
        acceleration_mps2_(0.5 * spec.max_acceleration_mps2),
        step_s_(step_s),
        bounded_(share < 1.0) {}

  struct Command {
    Vec3 velocity_mps = Vec3::Zero();  ///< to have at the end of the step
    bool path_flown = false;           ///< the reference rests at the path's end
  };

  /// Arc length (m) of the reference `t_s` seconds after the start, on a path of `length_m`.
  [[nodiscard]] double travelled_m(double length_m, double t_s) const;
  /// Its speed (m/s) then, as long as it does not brake.
  [[nodiscard]] double speed_mps(double length_m, double t_s) const;
  /// When the next step begins, s after the start.
  [[nodiscard]] double now_s() const { return static_cast<double>(steps_) * step_s_; }
  /// When the reference comes to the path's end, s after the start.
  [[nodiscard]] double whole_s(double length_m) const;
  /// Speed (m/s) between speeding up and slowing down.
  [[nodiscard]] double cruise_mps() const { return speed_mps_; }

  /// From the next step on it comes to rest with a deceleration. Braking again is without effect.
  void brake(double length_m, double deceleration_mps2);
  [[nodiscard]] bool brakes() const { return braking_.has_value(); }
  /// Where it comes to rest (m). @pre brakes()
  [[nodiscard]] double rest_m() const { return rest_of(*braking_) - (back_ ? back_->by_m : 0.0); }
  /// When it does, s after the start. @pre brakes()
  [[nodiscard]] double rest_s() const;
  /// Once at rest, back to an arc length (m) that is not ahead of rest_m(). @pre brakes()
  void draw_back(double length_m, double to_m);

  /// The command of the next step for a vehicle at a position (m); one call a step. `position_at`: arc length (m) to
  /// position (m) on the path.
  template <typename PositionAt>
  [[nodiscard]] Command command(double length_m, const PositionAt& position_at, const Vec3& position_m) {
    const double t_s = static_cast<double>(steps_++) * step_s_;
    const auto reference = [&](double ahead) -> Vec3 {
      return position_at(travelled_m(length_m, std::max(0.0, t_s + ahead * step_s_)));
    };
    const Vec3 feed = (reference(1.5) - reference(0.5)) / step_s_;
    const Vec3 error_m = reference(0.0) - position_m;
    return {feed + gain_per_s(error_m) * error_m, travelled_m(length_m, t_s) >= length_m};
  }
  /// The same towards a reference that rests.
  [[nodiscard]] Vec3 towards(const Vec3& rest_m, const Vec3& position_m) const {
    const Vec3 error_m = rest_m - position_m;
    return gain_per_s(error_m) * error_m;
  }

  void add_to(StateHash& hash) const {
    hash.add(steps_);
    if (braking_) hash.add(braking_->from_s).add(braking_->from_m).add(braking_->speed_mps).add(braking_->by_mps2);
    if (back_) hash.add(back_->from_s).add(back_->by_m);
  }

 private:
  struct Braking {
    double from_s;
    double from_m;
    double speed_mps;
    double by_mps2;
  };
  struct Back {
    double from_s;
    double by_m;
  };

  [[nodiscard]] static double rest_of(const Braking& braking) {
    return braking.from_m + braking.speed_mps * braking.speed_mps / (2.0 * braking.by_mps2);
  }
  [[nodiscard]] double profile_m(double length_m, double t_s) const;

  [[nodiscard]] double reached_mps(double length_m) const {
    return std::min(speed_mps_, std::sqrt(length_m * acceleration_mps2_));
  }
  [[nodiscard]] double gain_per_s(const Vec3& error_m) const {
    const double gain = 0.5 / step_s_;
    if (!bounded_) return gain;
    const double off_m = error_m.norm();
    return gain * gain * off_m > 2.0 * acceleration_mps2_ ? std::sqrt(2.0 * acceleration_mps2_ / off_m) : gain;
  }

  double speed_mps_;
  double acceleration_mps2_;
  double step_s_;
  bool bounded_;
  std::uint32_t steps_ = 0;
  std::optional<Braking> braking_;
  std::optional<Back> back_;
};

}  // namespace skein
