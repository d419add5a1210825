// What a report says of surprises: what moved or appeared, what the monitors said, and plans made under way.
#pragma once

#include <nlohmann/json.hpp>

#include "simworld/lockstep/run.hpp"

namespace skein {

/// Adds contacts with movers, entries into announced zones, movers, events and replans (docs/report.md).
void add_surprises(nlohmann::ordered_json& report, const Run& run);

}  // namespace skein
