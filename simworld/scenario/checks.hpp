// Checks of a whole mission: is there room for every vehicle where it starts and where it must arrive?
//
// Vehicles must start, and stand in formation, farther apart than their safety radii together (R_i + R_j of Eq. 17),
// outside every obstacle and no-fly zone by their own radius, and away from their own slot (a chord of length 0 has no
// path). Source: papers/001, Eq. 11 and 17. Departs from source: none. Complexity: O(vehicles^2 + vehicles * zones).
#pragma once

#include <string>
#include <vector>

#include "planner/core/mission/mission.hpp"
#include "simworld/scenario/sections.hpp"

namespace skein::scenario {

/// What may be meant, but seldom is, one line each: vehicles whose start heading, chord and end heading point the same
/// way. Their path is the straight line for every (m0, m1), so they cannot reach a common length that is longer.
[[nodiscard]] std::vector<std::string> notes_of(const Mission& mission);

/// @throws ReadFault at the start or slot that has no room
void check_mission(const Mission& mission, const Places& places);

}  // namespace skein::scenario
