// The samples that the open tick counts, kept for agents that lack them: the world publishes them again, unchanged.
#pragma once

#include <map>
#include <vector>

#include "simworld/lockstep/barrier.hpp"

namespace skein {

/// Samples to be published again.
struct Repeated {
  std::vector<Representative> representatives;
  std::vector<ObstacleMapSample> maps;
};

class Repeats {
 public:
  /// Keeps what the agents of `tick` have answered to it; all that was kept before is forgotten.
  void keep(const Barrier& answers, const Tick& tick);
  /// What an open beacon names as lacking, as far as it is kept.
  [[nodiscard]] Repeated asked_by(const Beacon& beacon) const;
  /// All that a tick counts.
  [[nodiscard]] Repeated counted_by(const Tick& tick) const;

 private:
  std::map<AgentId, Representative> representatives_;
  std::map<AgentId, ObstacleMapSample> maps_;
};

}  // namespace skein
