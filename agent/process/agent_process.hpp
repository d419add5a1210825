// One UAV's agent as a process: from its id and the bus to the end of the run.
#pragma once

#include <optional>

#include "idl/process/common_flags.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

struct AgentArguments {
  CommonFlags common;
  AgentId id = 0;
  /// Without a tick of any phase; by default --startup-timeout before the first tick, and 30 s after it.
  std::optional<double> world_timeout_s = {};
};

/// Runs to the end. @return 0 after a run, 3 when refused or without a world, 4 when the world went on without it,
/// 128 + signal after a signal (docs/architecture.md)
[[nodiscard]] int run_agent(const AgentArguments& arguments);

}  // namespace skein
