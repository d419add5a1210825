// What a report says of a run that was disturbed on purpose. Source: own. Complexity: a run in one process, the replay.
#pragma once

#include <nlohmann/json.hpp>

#include "groundstation/chaos/disturbed_run.hpp"

namespace skein::chaos {

/// Completes an outcome: result, reason, processes that ended without one, recovery, and whether the replay differs.
void judge(const nlohmann::json& report, const Scenario& scenario, RunOutcome& outcome);

}  // namespace skein::chaos
