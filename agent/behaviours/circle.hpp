// The circle of a vehicle that cannot hover: of the least radius that closes in whole steps.
//
// A step turns by at most r = kappa v dt, so that the least circle that ends where it began has n = ceil(2 pi / r)
// steps of the angle a = 2 pi / n, in the plane of the direction of motion d and the horizontal l to its side:
//   d(k) = cos(k a) d + sin(k a) l,   radius v dt / a <= (1 + r / (2 pi - r)) / kappa.
// After n steps position and direction are those of the beginning, up to rounding. All that begin in one step with
// parallel directions keep their places to one another. Source: own. Departs from source: none. Complexity: O(1).
#pragma once

#include <cstdint>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

class Circle {
 public:
  Circle() = default;
  /// @param from where it begins; straight up or down there is no side to turn to: then east is
  /// @param side 1: to the left; -1: to the right
  /// @pre spec has a speed and a curvature, step_s is positive
  Circle(const VehicleSpec& spec, double step_s, const Pose& from, double side);

  /// The direction of motion at the end of the next step, times the speed (m/s).
  [[nodiscard]] Vec3 command_mps();
  /// Whether the vehicle is where the circle began, and a step is about to begin.
  [[nodiscard]] bool closed() const { return done_ == 0; }
  [[nodiscard]] std::uint32_t steps() const { return steps_; }
  [[nodiscard]] double radius_m() const;
  /// Where it will be after a step `k` of the circle.
  [[nodiscard]] Vec3 place_m(std::uint32_t k) const;

  void add_to(StateHash& hash) const { hash.add(done_).add(along_).add(aside_); }

 private:
  double speed_mps_ = 0.0;
  double step_m_ = 0.0;
  Vec3 from_m_ = Vec3::Zero();
  Vec3 along_ = Vec3::UnitX();
  Vec3 aside_ = Vec3::UnitY();
  std::uint32_t steps_ = 1;
  std::uint32_t done_ = 0;
};

}  // namespace skein
