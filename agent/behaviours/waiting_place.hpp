// Where a multirotor waits for a new plan, and which way it will leave from there.
//
//   first  on its path where its reference comes to rest with its usual deceleration, if all up to there is clear; else
//          as far as is clear, braking harder; else the nearest clear place behind. Off its path where it can stop, or
//          the nearest clear place around
//   then   once the swarm knows the longest of the ways to come: who has a shorter one draws back along its path until
//          its way is as long, and leaves along the path, which so far kept all constraints. Whose path is blocked
//          chooses the heading of a path of that length, and draws back too if there is none. Nobody draws back into
//          a peer or waits too near to one: who has the longest way chooses first. Who cannot draw back far enough
//          looks around for a place with a way of that length
// Clear is what keeps the planner's distance from zones and obstacles, and a little more. Peers that brake in step on
// paths that keep apart keep apart while they brake. Source, Departs from source: own; one PH segment reaches hardly
// more than 1.3 times its shortest length, so that lengths are made equal by the places. Complexity: O(samples * zones)
// and a few best_departure.
#pragma once

#include <optional>
#include <span>

#include "agent/controller/flight_path.hpp"
#include "agent/controller/moving_reference.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein {

struct WaitingPlace {
  /// On the path that it flew.
  struct Stop {
    double brake_mps2 = 0.0;  ///< with which the reference comes to rest
    double at_m = 0.0;        ///< arc length of the place, to which the reference draws back if it rests beyond
    bool blocked = false;     ///< the path to come from there
  };
  Pose pose;                 ///< at rest; level
  double to_come_m = 0.0;    ///< length of the way from there to its slot, as far as it knows
  std::optional<Stop> stop;  ///< nothing off the path
};

/// Where a peer is on its way to wait, and what must be kept from it.
struct PeerPlace {
  Vec3 from_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();
  double apart_m = 0.0;
};

/// What the choice looks at.
struct WaitingQuery {
  const Mission& mission;
  AgentId self = 0;
  std::span<const Track> obstacles = {};  ///< fixed ones that it knows
  std::span<const PeerPlace> peers = {};  ///< as far as they are known
};

/// On a path that a reference has come to, or rests on already.
[[nodiscard]] WaitingPlace place_on_path(const WaitingQuery& query, const FlightPath& path,
                                         const MovingReference& reference);

/// Off any path, for a vehicle at a position (m) with a velocity (m/s).
[[nodiscard]] WaitingPlace place_off_path(const WaitingQuery& query, const Vec3& position_m, const Vec3& velocity_mps);

/// The final place, for a way of a length (m). @param path that of first.stop; not looked at without one
[[nodiscard]] WaitingPlace place_for_length(const WaitingQuery& query, const WaitingPlace& first,
                                            const FlightPath& path, double length_m);

}  // namespace skein
