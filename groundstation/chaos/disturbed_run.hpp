// One run of a campaign: real processes, a fault, and what the system and the run's own report say afterwards.
//
// Invariants that hold in every run, whatever its outcome: it ends; no two vehicles and no obstacle touch; each process
// ends with a reason; no process and no file is left; nobody flies a plan that a live peer did not accept; shared maps
// are equal as soon as the radio allows; and one process repeats the run from its roster changes to the same state
// hash, which without a change is that of the undisturbed run. Source: own. Departs from source: none.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "groundstation/chaos/injection.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein::chaos {

enum class Result : std::uint8_t {
  Completed,  ///< the mission succeeded
  Degraded,   ///< it ended with a reason, without a collision
  Unsafe,     ///< a collision
  Hung,       ///< it had to be killed
  Stopped,    ///< the campaign was interrupted
};

struct RunOutcome {
  std::uint64_t seed = 0;
  Kind kind = Kind::Kill;
  std::string fault;
  std::vector<AgentId> befallen{};  ///< the agents whose processes the fault stops, ends or cuts off
  bool injected = false;            ///< it really happened; a run may be over before
  Result result = Result::Completed;
  int exit_code = -1;
  std::string reason;
  std::string state_hash;
  std::vector<std::string> orphans;      ///< processes that were left, with what was left of them
  std::vector<std::string> leftovers;    ///< files that were left
  std::vector<std::string> unexplained;  ///< processes that ended without a reason, or a report that is missing
  bool replay_differs = false;
  std::size_t maps_due = 0;                     ///< agents whose maps had the time to become equal (map_watch.hpp)
  std::size_t maps_differ = 0;                  ///< those of them whose maps are not
  std::vector<std::string> unaccepted{};        ///< plans flown that live peers did not accept
  std::optional<std::uint32_t> recovery_steps;  ///< from a loss to the return
  std::optional<double> recovery_s;             ///< of the world: wall time; of an agent: simulated
  double wall_s = 0.0;
};

/// What a campaign needs to know to start a run.
struct RunPlan {
  std::string binaries;                ///< folder of the three programs
  std::string folder;                  ///< of this run alone
  Scenario scenario;                   ///< with this run's seed
  std::vector<std::string> arguments;  ///< of skein run, the last ones
  double limit_s = 120.0;              ///< after which it hangs
  std::function<bool()> interrupted;   ///< asked all the time
};

[[nodiscard]] RunOutcome run_disturbed(const RunPlan& plan, const Injection& injection);

}  // namespace skein::chaos
