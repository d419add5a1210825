// Whether the plan that a UAV flies still holds, from what it senses: is the way blocked, is it too slow, too late?
//
//   blocked   a fixed obstacle lies within its radius + the UAV's + the margin of the part of the path to come
//   slow      for a while it has not become faster although more was commanded: its speed then is what it can keep
//   late      it is farther from the moving reference than the limit, or than it can catch up until the end, while
//             nothing holds it off, for several steps in a row; than twice the limit even then. Who catches up in time
//             is not late
// Source: papers/000, Fig. 1c, for the vehicle that is slower than planned. Departs from source: own definitions.
// Complexity: blocked O(length / distance to the obstacle), the others O(1) a step.
#pragma once

#include <cstdint>
#include <optional>

#include "agent/controller/flight_path.hpp"
#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

/// @param from_m arc length from which on the path is still to be flown. @param keep_out_m of the UAV's centre from the
/// obstacle's surface. @param to_m arc length up to which it counts
[[nodiscard]] bool blocks(const FlightPath& path, double from_m, const Track& obstacle, double keep_out_m,
                          double to_m = 1e9);

/// What speed a UAV can keep, from what it reached while more was commanded.
class SpeedWatch {
 public:
  explicit SpeedWatch(double step_s);

  /// Once a step. @param reached_mps now, @param commanded_mps in the step before
  void note(double reached_mps, double commanded_mps);
  /// Speed (m/s) that it can keep; nothing if nothing speaks against what its data say.
  [[nodiscard]] std::optional<double> limit_mps() const { return limit_mps_; }

  void add_to(StateHash& hash) const;

 private:
  std::uint32_t needed_;
  std::uint32_t steps_ = 0;  ///< in a row in which more was commanded than reached, and the speed hardly changed
  double slowest_mps_ = 0.0;
  double fastest_mps_ = 0.0;
  std::optional<double> limit_mps_;
};

/// What LateWatch looks at in a step.
struct Lateness {
  double deviation_m = 0.0;  ///< from the moving reference
  double limit_m = 0.0;      ///< beyond which the plan does not hold
  double spare_mps = 0.0;    ///< of the UAV's speed beyond that of the reference
  double left_s = 0.0;       ///< until the reference comes to its end
  bool held_off = false;     ///< by something that it evades
};

class LateWatch {
 public:
  explicit LateWatch(double step_s);

  /// Once a step; whether the plan does not hold.
  [[nodiscard]] bool note(const Lateness& now);

  void add_to(StateHash& hash) const { hash.add(steps_).add(before_m_); }

 private:
  std::uint32_t needed_;
  std::uint32_t steps_ = 0;
  double before_m_ = 0.0;
};

}  // namespace skein
