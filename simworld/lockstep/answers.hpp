// Looks into the answers of a round: who is lost, and what an agent's beacon says.
//
// Source, Departs from source: none. Complexity: O(agents).
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include "simworld/lockstep/barrier.hpp"

namespace skein {

/// An agent that is gone, and why.
struct Loss {
  AgentId agent = 0;
  LossReason reason = LossReason::None;
};

[[nodiscard]] inline bool holds(std::span<const Loss> lost, AgentId agent) {
  return std::ranges::find(lost, agent, &Loss::agent) != lost.end();
}

/// @throws std::logic_error if there is none
[[nodiscard]] inline const Beacon& beacon_of(const Barrier& answers, AgentId agent) {
  const Answer* answer = answers.answer_of(agent);
  if (answer == nullptr || !answer->beacon) {
    throw std::logic_error("round decided without the beacon of agent " + std::to_string(agent));
  }
  return *answer->beacon;
}

/// The beacon of this very incarnation, if it answered.
[[nodiscard]] inline const Beacon* own_beacon(const Barrier& answers, const RosterEntry& entry) {
  const Answer* answer = answers.answer_of(entry.agent);
  const bool own = answer != nullptr && answer->beacon && answer->beacon->incarnation == entry.incarnation;
  return own ? &*answer->beacon : nullptr;
}

}  // namespace skein
