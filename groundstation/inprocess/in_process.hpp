// A whole run in one process, over the in-memory bus: the same sessions, behaviours and wire structs as over DDS.
//
// World and agents take turns; time is a manual clock that moves only when nobody has anything to do, so that lost
// samples are repeated without waiting. A world that is killed on purpose is made again from its checkpoint. The state
// hash equals that of the same scenario and seed over DDS.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>

#include "idl/bus/memory_bus.hpp"
#include "simworld/lockstep/world_session.hpp"

namespace skein {

struct InProcessOptions {
  std::vector<Fault> faults;
  std::vector<RosterChange> replay;
  std::vector<OrderedAt> orders;       ///< what the swarm is told, by round
  std::vector<InjectedAt> injections;  ///< obstacles, by round
  bool fail_fast = false;
  std::string checkpoint;                             ///< folder; without one the world cannot be killed
  bus::Tamper tamper;                                 ///< sees every sample in transit; empty for none
  bus::Tap tap;                                       ///< sees every sample as it is published; empty for none
  std::function<std::optional<int>()> signal;         ///< asked every turn: a signal that ends the run; empty for none
  std::function<void(const WorldSession&)> on_round;  ///< called after every round; empty for none
};

struct InProcessResult {
  nlohmann::ordered_json report;
  int exit_code = 0;
};

/// @throws std::invalid_argument for faults on a world without checkpoint
[[nodiscard]] InProcessResult run_in_process(const Scenario& scenario, const InProcessOptions& options);

}  // namespace skein
