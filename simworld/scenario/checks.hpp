// Checks of a whole mission: is there room for every vehicle where it starts and where it must arrive?
//
// Vehicles must start, and stand in formation, farther apart than their safety radii together (R_i + R_j of Eq. 17),
// outside every obstacle and no-fly zone by their own radius, and away from their own slot (a chord of length 0 has no
// path). Source: papers/001, Eq. 11 and 17. Departs from source: none. Complexity: O(vehicles^2 + vehicles * zones).
#pragma once

#include "planner/core/mission/mission.hpp"
#include "simworld/scenario/sections.hpp"

namespace skein::scenario {

/// @throws ReadFault at the start or slot that has no room
void check_mission(const Mission& mission, const Places& places);

}  // namespace skein::scenario
