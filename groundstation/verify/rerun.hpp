// A recorded run once more, in this process, from what the recording holds: scenario, seed, losses and returns.
//
// Source: none. Departs from source: none. Complexity: that of the run.
#pragma once

#include <functional>

#include "groundstation/verify/recorded_run.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein {

/// What a recording was made of. @throws std::runtime_error with one line if it does not hold its scenario, or the
/// scenario is none any more
[[nodiscard]] Scenario scenario_of(const mcap::Reader& file);

/// The run of that scenario with the recorded losses and returns, over the in-memory bus. @param interrupted says when
/// to give up; empty: never. @throws std::runtime_error as scenario_of()
[[nodiscard]] RecordedRun rerun(const mcap::Reader& file, const RecordedRun& recorded,
                                const std::function<std::optional<int>()>& interrupted);

}  // namespace skein
