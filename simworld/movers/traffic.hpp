// What really happens at announced zones, and when: drawn by the seed, told to nobody before it happens.
//
// The occupation is the announced one, shifted by a delay that is uniform in [-early_s, late_s]. In the step from t to
// t + dt a zone is
//   occupied     if the occupation and the step overlap, and until one step after its end: then it is confirmed
//   clear        after that
//   unconfirmed  before the occupation, from the first step that reaches beyond from_s - early_s
//   ahead        before that
// Source: papers/000, section 2.3 (late and early take-offs). Departs from source: the paper's zones are airports.
// Complexity: O(1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "simworld/movers/mover.hpp"

namespace skein {

/// What flies through a zone while it is occupied: at one speed from one point to the other.
struct Aircraft {
  double radius_m = 0.0;
  Vec3 from_m = Vec3::Zero();
  Vec3 to_m = Vec3::Zero();

  bool operator==(const Aircraft&) const = default;
};

/// What agents are not told of an announcement.
struct Traffic {
  double late_s = 0.0;  ///< how much later the occupation may begin
  std::optional<Aircraft> aircraft;

  bool operator==(const Traffic&) const = default;
};

/// From and to (s): when the zone is really occupied.
struct Occupation {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// @param index of the announcement, from 0: it has a stream of its own, (seed, 0, Delay, index)
[[nodiscard]] Occupation occupation_of(const Announcement& announced, const Traffic& traffic, std::uint64_t seed,
                                       std::size_t index);

/// The state of a zone in flight step `step` (from 1).
[[nodiscard]] ZoneState state_in(const Announcement& announced, const Occupation& occupation, std::uint32_t step,
                                 double step_s);

/// Nobody may be in a zone of that state.
[[nodiscard]] inline bool is_closed(ZoneState state) {
  return state == ZoneState::Unconfirmed || state == ZoneState::Occupied;
}

/// The aircraft as a mover that is there during the occupation. @pre the occupation lasts
[[nodiscard]] Mover mover_of(const Aircraft& aircraft, const Occupation& occupation, std::string name);

}  // namespace skein
