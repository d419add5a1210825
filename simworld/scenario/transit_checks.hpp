// Checks of a whole transit: can every vehicle fly from its start, and is its goal a place to fly to?
//
// Starts and goals stand at centres of cells already. They must lie in the area, in cells that are really free, each
// start in a cell of its own and away from the others by the sum of both safety radii. Whether a path joins a start
// with its goal is not checked: a swarm must find that out. Source: papers/004, section III-A (cells at least as large
// as a UAV). Departs from source: none. Complexity: O(cells + vehicles^2).
#pragma once

#include "simworld/scenario/scenario.hpp"
#include "simworld/scenario/sections.hpp"

namespace skein::scenario {

/// @pre the mission is a transit @throws ReadFault at the start, goal or option that does not fit
void check_transit(const Scenario& scenario, const Places& places);

}  // namespace skein::scenario
