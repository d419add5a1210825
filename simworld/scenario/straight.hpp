// Starts and goals of a transit without cells (planner.name straight): given, drawn, or a swarm that swaps places.
//
// Given and drawn places are points, not centres of cells; drawn ones come from the stream (seed, 0, Layout, 1), starts
// and own goals each farther apart than two safety radii, clear of obstacles by the safety radius.
//
// vehicles.swap spreads N starts evenly over a sphere: N / 2 points of a spiral on its upper half,
//   z_i = (2 i + 1) / N,  angle_i = i pi / phi,  phi the golden section,
// and their antipodes, the whole turned by the seed (stream (seed, 0, Layout, 3)). Each goal is the start of the
// antipode, moved by up to 1 % of the radius on each axis, so that no two UAVs meet exactly face to face. Vehicle
// i + N / 2 is the antipode of vehicle i. Source: none; the usual spiral lattice. Departs from source: antipodes are
// pairs, so that all swap. Complexity: O(N), drawn places O(tries * N).
#pragma once

#include "simworld/scenario/common.hpp"
#include "simworld/scenario/sections.hpp"

namespace skein::scenario {

/// Fills vehicles and goals of the mission. @pre area, zones and goal radius are set @throws ReadFault
void place_straight(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                    Places& places);

}  // namespace skein::scenario
