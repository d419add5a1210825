// The way of a vehicle that cannot hover to a pose: a turn, straight on, and a turn to the same side, level.
//
// With R the radius, n the normal to the side of the turns, and the circles' centres c = p + R n at both ends, the
// straight part leads along c2 - c1 and is as long; such a way exists between any two poses. The shorter one of left
// and right is taken. Height is made up for at no more than 0.15 rad. Source: Dubins, On curves of minimal length
// (1957), the words LSL and RSR. Departs from source: only these two. Complexity: O(1).
#pragma once

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class WayBack {
 public:
  WayBack() = default;
  /// @param radius_m of its turns. @pre positive
  WayBack(const VehicleSpec& spec, double step_s, double radius_m, const Pose& from, const Pose& to);

  /// The direction of motion at the end of the next step, times the speed (m/s). @param height_m of the vehicle
  [[nodiscard]] Vec3 command_mps(double height_m);
  /// Whether what is left is less than half a step.
  [[nodiscard]] bool flown() const { return done_m_ + 0.5 * step_m_ >= length_m(); }
  [[nodiscard]] double length_m() const { return first_m_ + straight_m_ + last_m_; }

  void add_to(StateHash& hash) const { hash.add(done_m_).add(first_m_).add(straight_m_).add(last_m_); }

 private:
  [[nodiscard]] double heading_at(double way_m) const;

  double speed_mps_ = 0.0;
  double step_m_ = 0.0;
  double radius_m_ = 1.0;
  double side_ = 1.0;
  double from_rad_ = 0.0;
  double straight_rad_ = 0.0;
  double to_height_m_ = 0.0;
  double first_m_ = 0.0;
  double straight_m_ = 0.0;
  double last_m_ = 0.0;
  double done_m_ = 0.0;
};

}  // namespace skein
