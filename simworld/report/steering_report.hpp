// What a run was told and what was put in its way: the report's lists `commands` and `injections`, and back.
//
// Source: docs/report.md. Departs from source: none. Complexity: linear.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "simworld/lockstep/run.hpp"

namespace skein {

/// Adds both lists.
void add_steering(nlohmann::ordered_json& report, const Run& run);

/// What a report holds of them, for a replay; of a report without these lists nothing.
/// @throws std::runtime_error with one line that says what is wrong
[[nodiscard]] std::vector<OrderedAt> orders_of(const nlohmann::json& report);
[[nodiscard]] std::vector<InjectedAt> injections_of(const nlohmann::json& report);

}  // namespace skein
