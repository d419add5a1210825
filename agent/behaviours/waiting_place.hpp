// Where a multirotor waits for a new plan, and which way it will leave from there.
//
//   1. on its path where its reference comes to rest with its usual deceleration, if all up to there is clear
//   2. else as far as is clear, braking harder, if that is enough
//   3. else the nearest clear place of the path behind
//   without a path, or far off it: where it can stop; else the nearest clear place around
// Clear is what keeps the planner's distance from zones and obstacles, and a little more. Of the places behind, one
// from which a path of one segment leads to the slot is preferred. Peers that brake in step on paths that keep apart
// keep apart while they brake. Source, Departs from source: own. Complexity: O(samples * zones) and best_departure.
#pragma once

#include <optional>
#include <span>

#include "agent/controller/flight_path.hpp"
#include "agent/controller/moving_reference.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

struct WaitingPlace {
  Pose pose;                         ///< at rest; level
  double shortest_m = 0.0;           ///< of the ways from there to its slot, as far as it knows
  std::optional<double> brake_mps2;  ///< the reference comes to rest there with this deceleration
};

/// What the choice looks at.
struct WaitingQuery {
  const Mission& mission;
  AgentId self = 0;
  std::span<const Track> obstacles = {};  ///< fixed ones that it knows
};

/// The heading (rad) to leave its waiting place by on a way of at least a length (m).
[[nodiscard]] double heading_for(const WaitingQuery& query, const Vec3& place_m, double wanted_m);

/// On a path that a reference has come to.
[[nodiscard]] WaitingPlace place_on_path(const WaitingQuery& query, const FlightPath& path,
                                         const MovingReference& reference);

/// Off any path, for a vehicle at a position (m) with a velocity (m/s).
[[nodiscard]] WaitingPlace place_off_path(const WaitingQuery& query, const Vec3& position_m, const Vec3& velocity_mps);

}  // namespace skein
