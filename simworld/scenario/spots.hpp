// Points that a scenario lists by the ids of vehicles: starts and goals of a transit.
//
// Source, Departs from source: none. Complexity: O(points log points).
#pragma once

#include <map>
#include <vector>

#include "simworld/scenario/common.hpp"

namespace skein::scenario {

/// One point of the scenario by the id of its vehicle.
struct Spot {
  Vec3 point_m;
  Place place;
};
using Spots = std::map<AgentId, Spot>;

/// The items of a list of points with ids. @param z_m a height that is left out
[[nodiscard]] Spots read_spots(const MapReader& parent, std::string_view list, double z_m);

/// The goals are a list, one each.
[[nodiscard]] bool has_own_goals(const MapReader& root);

/// By vehicle: its own goal, or the one that all have in common.
[[nodiscard]] std::vector<Spot> read_goals(const MapReader& root, const std::vector<VehicleSpec>& vehicles, double z_m);

}  // namespace skein::scenario
