// The sections of a scenario of each kind: each becomes its part of Scenario, value by value, with its range.
//
// Keys, units, ranges and defaults are those of docs/scenario.md; the planner's come from kRendezvousFields
// and kTransitFields.
// Source: papers/001, Tables 1 and 2; papers/004, section IV-B. Departs from source: none. Complexity: O(values).
#pragma once

#include <optional>
#include <vector>

#include "simworld/scenario/scenario.hpp"
#include "simworld/scenario/yaml_tree.hpp"

namespace skein::scenario {

/// Where the parts of a mission stand, for findings about several values.
struct Places {
  std::vector<Place> starts;  ///< by vehicle, as in Mission::vehicles
  std::vector<Place> slots;   ///< by vehicle; of a transit the goals
  Place cells = {};           ///< what divides a transit's area: planner.cell_m
  Place decision = {};        ///< planner.decision_s
};

/// Fills mission, lockstep and world options by the scenario's kind. @param seed replaces the file's; what is drawn at
/// random follows it. @throws ReadFault
[[nodiscard]] Places read_sections(const YamlNode& root, std::optional<std::uint64_t> seed, Scenario& into);

/// The same of one kind.
[[nodiscard]] Places read_rendezvous(const YamlNode& root, std::optional<std::uint64_t> seed, Scenario& into);
[[nodiscard]] Places read_transit(const YamlNode& root, std::optional<std::uint64_t> seed, Scenario& into);

}  // namespace skein::scenario
