// Keeps a constant-speed vehicle on a planned path, with one command a step.
//
// The vehicle's place on the path is its arc length s, moved on by speed * dt a step and corrected by the along-track
// error. With e_y the offset to the left of the path, e_chi the heading error and D = speed * dt, the turn of a step is
//   d_chi = chi(s + D) - chi(s) - (1 - p)^2 e_y / D - (1 - p)(3 + p) / 2 e_chi,
// the path's own turn plus the feedback that puts both poles of the sampled error dynamics
//   e_y' = e_y + D e_chi + D d / 2,  e_chi' = e_chi + d   at p.
// In space the same law acts on directions: with the unit directions t of the path and v of the vehicle, and e the
// offset across the path, the direction to have at the end of the step is that of
//   v + t(s + D) - t(s) - (1 - p)^2 e / D - (1 - p)(3 + p) / 2 (v - t(s)).
// Source: own; pole placement of a sampled double integrator. Complexity: O(1) a step.
#pragma once

#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/ph/joined_path.hpp"

namespace skein {

class PathFollower {
 public:
  /// @pre spec.speed_mps > 0, step_s > 0
  PathFollower(const VehicleSpec& spec, double step_s);

  struct Command {
    Vec3 velocity_mps = Vec3::Zero();  ///< direction to have at the end of the step, times the speed
    bool path_flown = false;           ///< the path lies behind: straight on
  };

  /// The command of the next step for a vehicle at `pose` (world frame).
  [[nodiscard]] Command command(const rendezvous::ph::JoinedPlanarPath& path, const Pose& pose);
  [[nodiscard]] Command command(const rendezvous::ph::JoinedSpatialPath& path, const Pose& pose);

  /// Arc length (m) of the vehicle's place on the path, at the beginning of the next step.
  [[nodiscard]] double next_m() const { return under_way_ ? travelled_m_ + step_m_ : 0.0; }

  void add_to(StateHash& hash) const { hash.add(travelled_m_); }

 private:
  double speed_mps_;
  double step_m_;           ///< travelled in one step
  double max_turn_rad_;     ///< of one step
  double travelled_m_ = 0;  ///< arc length of the vehicle's place on the path
  bool under_way_ = false;
};

}  // namespace skein
