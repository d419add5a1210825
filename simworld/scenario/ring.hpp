// Vehicles on a ring, generated: any number of them, all on their way across one another.
//
// Vehicle k of n (ids 1 to n) stands at angle 2 pi (k - 1) / n on the ring of starts about the formation's centre, and
// its slot lies opposite, at the same angle on the other side of the ring of slots. It starts `start_turn_rad` off the
// direction to the centre: headed straight to it, some vehicle's start heading, chord and end heading were collinear,
// and its path could not change length.
// Source: none; docs/families/rendezvous.md, 'Many UAVs'. Departs from source: none. Complexity: O(n).
#pragma once

#include <vector>

#include "planner/core/mission/mission.hpp"
#include "simworld/scenario/reader.hpp"

namespace skein::scenario {

/// The vehicles of the map `vehicles.ring`, by ascending id: `common` with start and slot. @throws ReadFault
[[nodiscard]] std::vector<VehicleSpec> read_ring(const MapReader& vehicles, const VehicleSpec& common,
                                                 const Pose& formation);

}  // namespace skein::scenario
