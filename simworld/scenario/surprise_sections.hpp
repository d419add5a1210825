// The sections of what nobody is told of, or not exactly: movers, announced zones, slow vehicles; sensor and
// controller.
//
// An item of moving_obstacles or sudden_obstacles is a sphere if it has z_m, else a column. It moves on a line if it
// has vx_mps, on a loop if it has waypoints, at random if it has turn_s, else not at all. It is sudden if it has at_s,
// near_m or ahead: then it waits until it may appear (simworld/movers/appearance.hpp). Obstacles at random are drawn
// from the stream (seed, 0, Layout, 2), uniform in their box, clear of starts and goals; they are reflected at its
// walls. Source: docs/scenario.md. Departs from source: none. Complexity: O(items + tries * vehicles).
#pragma once

#include "simworld/scenario/common.hpp"

namespace skein::scenario {

/// The section controller; sensor_range_m is not read here. @throws ReadFault
void read_controller(const MapReader& root, ControllerOptions& options);

/// Movers and announcements. @pre vehicles, goals and seed of the mission, and controller.sensor_range_m are set
/// @param area in which obstacles at random are, if their section does not say; none: it must
/// @throws ReadFault
void read_surprises(const MapReader& root, const std::optional<Box>& area, Scenario& into);

}  // namespace skein::scenario
