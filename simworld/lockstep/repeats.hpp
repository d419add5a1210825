// The representatives that the open tick counts, kept for agents that lack them: the world publishes them again,
// unchanged.
#pragma once

#include <map>
#include <vector>

#include "simworld/lockstep/barrier.hpp"

namespace skein {

class Repeats {
 public:
  /// Keeps what the agents of `tick` have answered to it; all that was kept before is forgotten.
  void keep(const Barrier& answers, const Tick& tick);
  /// What an open beacon names as lacking, as far as it is kept.
  [[nodiscard]] std::vector<Representative> asked_by(const Beacon& beacon) const;
  /// All that a tick counts.
  [[nodiscard]] std::vector<Representative> counted_by(const Tick& tick) const;

 private:
  std::map<AgentId, Representative> kept_;
};

}  // namespace skein
