// One UAV's agent as a process: from its id and the bus to the end of the run.
#pragma once

#include "idl/process/common_flags.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

struct AgentArguments {
  CommonFlags common;
  AgentId id = 0;
  double world_timeout_s = 30.0;  ///< without a tick of any phase
};

/// Runs to the end. @return 0 after a run, 3 when refused or without a world, 4 when the world went on without it,
/// 128 + signal after a signal (docs/architecture.md)
[[nodiscard]] int run_agent(const AgentArguments& arguments);

}  // namespace skein
