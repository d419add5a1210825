// One UAV's agent as a process, or several in one: from their ids and the bus to the end of the run.
//
// Each vehicle has its own session, nonce, beacon and behaviour; they share the process's port (idl/bus/dds_port.hpp).
// What is decided does not depend on who shares a process with whom.
#pragma once

#include <optional>

#include "idl/process/common_flags.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

struct AgentArguments {
  CommonFlags common;
  std::vector<AgentId> ids;  ///< ascending, each once; none: the world gives one
  /// Without a tick of any phase; by default --startup-timeout before the first tick, and 30 s after it.
  std::optional<double> world_timeout_s = {};
};

/// Runs to the end. @return 0 after a run, 3 when one of the ids is refused, none was free or without a world, 4 when
/// the world went on without one of them, 128 + signal after a signal (docs/architecture.md)
[[nodiscard]] int run_agent(const AgentArguments& arguments);

}  // namespace skein
