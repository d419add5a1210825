// The radio, as pure functions: who hears whom, what gets lost, and when a sample is heard.
//
//   heard = distance <= range  and  uniform(seed, sender, receiver, step, round) >= loss;  in round + 1 + latency
// Both carriers, agents and world derive the same from the same samples. A reader keeps of each agent the newest sample
// that it heard. Source: papers/004, appendix (range 90 m, 250 kbit/s, a send every 2 s). Departs from source: loss and
// latency. Complexity: O(1); a receiver O(log senders) a sample.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/mission/mission.hpp"

namespace skein {

/// @param from_m, to_m where sender and receiver are, in the world frame
[[nodiscard]] bool in_range(const RadioOptions& options, const Vec3& from_m, const Vec3& to_m);

/// Whether `receiver` misses the sample that `sender` composed in this step and round.
[[nodiscard]] bool is_lost(const RadioOptions& options, std::uint64_t seed, AgentId sender, AgentId receiver,
                           std::uint32_t step, std::uint32_t round);

/// Whole rounds beyond the next one after which a sample is heard; options.latency_rounds, rounded down.
[[nodiscard]] std::uint32_t latency_of(const RadioOptions& options);

/// What one agent has on its radio: samples that are due later, and the newest heard of each agent. `Sample` has
/// `agent` and `round`.
template <typename Sample>
class RadioReceiver {
 public:
  /// A sample that reaches this agent, neither out of range nor lost; it is due in its round + 1 + latency.
  void receive(Sample sample, std::uint32_t latency_rounds) {
    const Key key{sample.round + 1 + latency_rounds, sample.agent};
    due_.insert_or_assign(key, std::move(sample));
  }
  /// Those due in this round or before and not heard yet, by round, then agent; from now on they are heard.
  [[nodiscard]] std::vector<Sample> hear(std::uint32_t round) {
    std::vector<Sample> heard;
    while (!due_.empty() && due_.begin()->first.first <= round) {
      auto node = due_.extract(due_.begin());
      heard.push_back(std::move(node.mapped()));
      const auto [known, is_new] = last_.try_emplace(heard.back().agent, heard.back());
      if (!is_new && heard.back().round >= known->second.round) known->second = heard.back();
    }
    return heard;
  }
  /// The newest sample heard of an agent, or nothing if it was never heard.
  [[nodiscard]] const Sample* last_of(AgentId agent) const {
    const auto known = last_.find(agent);
    return known == last_.end() ? nullptr : &known->second;
  }
  /// Of an agent that is lost, or came back under a new incarnation.
  void forget(AgentId agent) {
    last_.erase(agent);
    std::erase_if(due_, [agent](const auto& entry) { return entry.first.second == agent; });
  }
  void add_to(StateHash& hash) const {
    hash.add(due_.size());
    for (const auto& [key, sample] : due_) hash.add(key.first).add(key.second);
    hash.add(last_.size());
    for (const auto& [agent, sample] : last_) hash.add(agent).add(sample.round);
  }

 private:
  using Key = std::pair<std::uint32_t, AgentId>;  ///< round in which it is due, sender
  std::map<Key, Sample> due_;
  std::map<AgentId, Sample> last_;
};

}  // namespace skein
