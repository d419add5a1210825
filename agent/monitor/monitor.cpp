#include "agent/monitor/monitor.hpp"

#include <algorithm>

#include "planner/core/geometry/closest_approach.hpp"

namespace skein {

Watch watch(const ControllerOptions& options, const Situation& now) {
  Watch found;
  bool close = false;
  for (std::size_t i = 0; i < now.neighbours.size(); ++i) {
    const Neighbour& other = now.neighbours[i];
    const Vec3 own_later_m = now.position_m + options.horizon_s * now.velocity_mps;
    const Vec3 its_later_m = other.position_m + options.horizon_s * other.velocity_mps;
    const double least_m = closest_approach(now.position_m, own_later_m, other.position_m, its_later_m).distance_m;
    found.predicted_separation_m = std::min(found.predicted_separation_m, least_m);
    close = close || least_m < now.safe_m[i];
  }
  if (now.reference_m) found.deviation_m = (*now.reference_m - now.position_m).norm();
  const auto conclude = [&](SafetyMode mode, SafetyReason reason) {
    found.mode = mode;
    found.reason = reason;
    return found;
  };
  if (!now.has_plan) return conclude(SafetyMode::Hold, SafetyReason::NoPlan);
  if (now.replanning) return conclude(SafetyMode::Hold, SafetyReason::Replanning);
  if (now.zone_unconfirmed) return conclude(SafetyMode::Controlled, SafetyReason::Unconfirmed);
  if (close) return conclude(SafetyMode::Controlled, SafetyReason::Peer);
  if (now.steering.repelled || now.steering.overruled) return conclude(SafetyMode::Controlled, SafetyReason::Obstacle);
  if (found.deviation_m > options.deviation_m) return conclude(SafetyMode::Controlled, SafetyReason::Deviation);
  if (now.stale_peer) return conclude(SafetyMode::Controlled, SafetyReason::StalePeer);
  return found;
}

}  // namespace skein
