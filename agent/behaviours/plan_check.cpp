#include "agent/behaviours/plan_check.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/distance.hpp"
#include "planner/rendezvous/replan.hpp"

namespace skein {
namespace {

constexpr double kStep_m = 0.25;      ///< least distance of two places at which a path is looked at
constexpr double kSlow_s = 1.0;       ///< without becoming faster
constexpr double kFar_limits = 2.0;   ///< beyond which nothing excuses
constexpr double kLate_s = 0.5;       ///< too late
constexpr double kSame_part = 0.02;   ///< of a speed: no difference
constexpr double kAllowance_s = 3.0;  ///< in which the end of the way is caught up by slowing down later

std::uint32_t steps_of(double time_s, double step_s) {
  return std::max<std::uint32_t>(3, static_cast<std::uint32_t>(std::ceil(time_s / step_s)));
}

}  // namespace

bool blocks(const FlightPath& path, double from_m, const Track& obstacle, double keep_out_m, double to_m) {
  const Cylinder column = rendezvous::column_of(obstacle);
  const double length_m = std::min(to_m, path.length_m());
  for (double s_m = from_m;;) {
    const double spare_m = signed_distance(path.position_at(s_m), column) - keep_out_m;
    if (spare_m < 0.0) return true;
    if (s_m >= length_m) return false;
    s_m = std::min(length_m, s_m + std::max(kStep_m, spare_m));
  }
}

SpeedWatch::SpeedWatch(double step_s) : needed_(steps_of(kSlow_s, step_s)) {}

void SpeedWatch::note(double reached_mps, double commanded_mps) {
  if (limit_mps_ && reached_mps > *limit_mps_) limit_mps_ = reached_mps;
  const double same_mps = kSame_part * commanded_mps;
  if (commanded_mps - reached_mps <= same_mps) {
    steps_ = 0;
    return;
  }
  if (steps_ == 0) slowest_mps_ = fastest_mps_ = reached_mps;
  slowest_mps_ = std::min(slowest_mps_, reached_mps);
  fastest_mps_ = std::max(fastest_mps_, reached_mps);
  if (fastest_mps_ - slowest_mps_ > same_mps) {
    steps_ = 1;
    slowest_mps_ = fastest_mps_ = reached_mps;
  } else if (++steps_ >= needed_) {
    limit_mps_ = fastest_mps_;
  }
}

void SpeedWatch::add_to(StateHash& hash) const {
  hash.add(steps_).add(slowest_mps_).add(fastest_mps_).add(limit_mps_.value_or(-1.0));
}

LateWatch::LateWatch(double step_s) : needed_(steps_of(kLate_s, step_s)) {}

bool LateWatch::note(const Lateness& now) {
  const bool catches_up = now.spare_mps > 0.0 && now.deviation_m < before_m_;
  const bool in_time = now.deviation_m <= now.spare_mps * (now.left_s + kAllowance_s);
  const bool late = catches_up ? !in_time : now.deviation_m > now.limit_m;
  before_m_ = now.deviation_m;
  const bool excused = now.held_off && now.deviation_m <= kFar_limits * now.limit_m;
  steps_ = late && !excused ? steps_ + 1 : 0;
  return steps_ >= needed_;
}

}  // namespace skein
