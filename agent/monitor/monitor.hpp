// The run-time monitor of one UAV: who has the say in this step, and why (papers/000, sections 2.2 and 2.3).
//
//   hold        it has no plan to fly: NoPlan, or waits for the one that the swarm is making: Replanning
//   controlled  a zone ahead is not confirmed (Unconfirmed); a peer will come too close within the horizon (Peer); the
//               controller steers off the plan (Obstacle); it is farther than deviation_m from where the plan says
//               (Deviation); a live peer is not heard (StalePeer)
//   autonomous  else
// The first that applies, in this order, is the reason. Predicted separation is that of straight lines at the present
// velocities, over controller.horizon_s. A pure function. Complexity: O(peers).
#pragma once

#include <optional>
#include <span>

#include "agent/controller/scene.hpp"

namespace skein {

/// What the monitor looks at, at the beginning of a step.
struct Situation {
  std::span<const Neighbour> neighbours = {};  ///< as heard
  std::span<const double> safe_m = {};         ///< by neighbour: the separation to be kept
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  std::optional<Vec3> reference_m;  ///< where its plan says that it is now; nothing without a plan
  bool has_plan = true;
  bool replanning = false;
  bool zone_unconfirmed = false;  ///< an announced zone ahead keeps it waiting
  bool stale_peer = false;        ///< a live peer is not heard
  Steering steering;              ///< of this step
};

/// The monitor's finding.
struct Watch {
  SafetyMode mode = SafetyMode::Autonomous;
  SafetyReason reason = SafetyReason::None;
  double deviation_m = 0.0;
  double predicted_separation_m = 1e6;

  bool operator==(const Watch&) const = default;
};

[[nodiscard]] Watch watch(const ControllerOptions& options, const Situation& now);

}  // namespace skein
