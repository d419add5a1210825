// Obstacles at random places that move at random: the section random_obstacles.
//
// Each is drawn uniformly in a box, with radius, speed and kind, until its surface is clear_m away from the bodies at
// all starts and goals; clear_m is by default the braking distance from full speed. `walk` turns now and then, `line`
// only at the walls of the box, `mixed` draws one of both each. Stream (seed, 0, Layout, 2). Source, Departs from
// source: none. Complexity: O(tries * vehicles).
#pragma once

#include "simworld/movers/mover.hpp"
#include "simworld/scenario/common.hpp"

namespace skein::scenario {

/// @pre the section is there; vehicles, goals and seed of the mission are set @throws ReadFault if no room is found
[[nodiscard]] std::vector<Mover> draw_movers(const MapReader& root, const std::optional<Box>& area,
                                             const Mission& mission);

}  // namespace skein::scenario
