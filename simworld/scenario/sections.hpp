// The sections of a rendezvous scenario: each becomes its part of Scenario, value by value, with its range.
//
// Keys, units, ranges and defaults are those of docs/scenario.md; the planner's come from kRendezvousFields.
// Source: papers/001, Tables 1 and 2. Departs from source: none. Complexity: O(values).
#pragma once

#include <vector>

#include "simworld/scenario/scenario.hpp"
#include "simworld/scenario/yaml_tree.hpp"

namespace skein::scenario {

/// Where the parts of a mission stand, for findings about several values.
struct Places {
  std::vector<Place> starts;  ///< by vehicle, as in Mission::vehicles
  std::vector<Place> slots;   ///< by vehicle
};

/// Fills mission, lockstep and world options. @throws ReadFault
[[nodiscard]] Places read_sections(const YamlNode& root, Scenario& into);

}  // namespace skein::scenario
