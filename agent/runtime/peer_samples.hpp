// What an agent heard of its peers on one topic, the last two rounds, by (round, agent).
//
// The first sample of an agent and round stands, unless the peer's own program cannot have published it or the roster
// has overtaken its incarnation. Source: docs/architecture.md, 'Steps and rounds'. Complexity: O(log samples).
#pragma once

#include <map>
#include <utility>

#include "planner/core/mission/mission.hpp"

namespace skein {

template <typename Sample>
class PeerSamples {
 public:
  /// @param usable whether the peer's own program can have published a sample
  template <typename Usable>
  void put(Sample sample, const Usable& usable) {
    const auto [place, fresh] = heard_.try_emplace({sample.round, sample.agent}, sample);
    if (fresh) return;
    const bool stands = place->second.incarnation == sample.incarnation && usable(place->second);
    if (!stands && usable(sample)) place->second = std::move(sample);
  }
  /// That of an agent's incarnation, or nullptr.
  [[nodiscard]] const Sample* find(std::uint32_t round, AgentId agent, std::uint32_t incarnation) const {
    const auto found = heard_.find({round, agent});
    return found != heard_.end() && found->second.incarnation == incarnation ? &found->second : nullptr;
  }
  void forget_before(std::uint32_t round) { heard_.erase(heard_.begin(), heard_.lower_bound({round, 0})); }
  void clear() { heard_.clear(); }

 private:
  std::map<std::pair<std::uint32_t, AgentId>, Sample> heard_;
};

}  // namespace skein
