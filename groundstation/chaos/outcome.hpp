// A run of a campaign as JSON: for the table's `per_run`, and for a journal, from which it is read again to the last
// bit. Source: own. Departs from source: none. Complexity: O(bytes).
#pragma once

#include <nlohmann/json.hpp>

#include "groundstation/chaos/disturbed_run.hpp"

namespace skein::chaos {

/// Whether the run kept all invariants.
[[nodiscard]] bool is_sound(const RunOutcome& outcome);

/// {"seed", "kind", "fault", "befallen", "injected", "result", "exit_code", "reason", "state_hash", "replay_differs",
/// "sound", "wall_s", "recovery_steps" and "recovery_s" (null without a loss), "orphans", "leftovers", "unexplained",
/// "unaccepted_plans", "maps_due", "maps_differ"}.
[[nodiscard]] nlohmann::ordered_json json_of(const RunOutcome& outcome);

/// What json_of wrote. @throws std::runtime_error if it is no such object
[[nodiscard]] RunOutcome outcome_of(const nlohmann::ordered_json& run);

}  // namespace skein::chaos
