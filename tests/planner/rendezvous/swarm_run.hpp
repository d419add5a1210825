// A whole swarm of planners in one process, round by round, as the runtime drives them.
#pragma once

#include <functional>
#include <vector>

#include "planner/rendezvous/planner.hpp"

namespace skein::test {

struct SwarmRun {
  std::vector<rendezvous::Planner> planners;  ///< of the live UAVs, by ascending id
  std::vector<rendezvous::PlanRound> last;    ///< their last round
  int rounds = 0;

  [[nodiscard]] bool all(rendezvous::PlanStatus status) const;
  [[nodiscard]] double longest_m() const;  ///< of the final paths
};

/// May change or drop planners and their samples before a round.
using Interfere = std::function<void(int round, SwarmRun& run)>;

/// Advances all planners until none is Planning, or for `max_rounds` rounds.
[[nodiscard]] SwarmRun run_swarm(const Mission& mission, int max_rounds = 200, const Interfere& interfere = {},
                                 const rendezvous::kernel::Kernel& kernel = rendezvous::kernel::chosen_kernel());

}  // namespace skein::test
