// What the radio of a transit carried, as the world reckons it from the samples and the positions: for the report.
//
// The same pure functions of planner/core/radio decide here and in the agents, so that both count the same: a sample
// composed in round k is heard, or lost, by who is in range when the next step opens. The least round in which all maps
// are equal counts from the last one in which they were not. Source: docs/report.md. Complexity of a step: O(N^2).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/radio/link_counts.hpp"
#include "planner/core/radio/radio_budget.hpp"

namespace skein {

/// A live agent at the end of a step: where it is, and what it sent.
struct OnAir {
  AgentId agent = 0;
  Vec3 position_m = Vec3::Zero();
  const ObstacleMapSample* sample = nullptr;  ///< composed in that step's round, or nothing
  std::uint64_t map_hash = 0;                 ///< of its map then
};

/// From a step on, how many groups no radio link joins.
struct PartitionChange {
  std::uint32_t step = 0;
  std::size_t groups = 0;
};

class RadioLog {
 public:
  /// @pre mission.transit
  explicit RadioLog(const Mission& mission);

  /// What was on air in step `step`, heard as the next one opens. @param agents by ascending id
  void add(std::uint32_t step, std::uint32_t round, std::span<const OnAir> agents);

  [[nodiscard]] const LinkCounts& counts() const { return counts_; }
  [[nodiscard]] const std::vector<PartitionChange>& partitions() const { return partitions_; }
  /// Bits that one UAV may send in a slot, and the most that any sent; samples that were over what they might hold.
  [[nodiscard]] double slot_bits() const { return slot_bits_; }
  [[nodiscard]] double peak_bits() const;
  [[nodiscard]] std::uint32_t over_budget() const { return over_budget_; }
  [[nodiscard]] std::uint64_t sent_bytes() const { return sent_bytes_; }
  [[nodiscard]] std::uint64_t sent_samples() const { return sent_samples_; }
  /// Since which step all agents' maps have been equal; nothing if they are not.
  [[nodiscard]] std::optional<std::uint32_t> equal_since() const { return equal_since_; }

 private:
  struct Link {
    std::uint32_t used_round = 0;                                ///< of the sample that the receiver uses; 0: none yet
    std::vector<std::pair<std::uint32_t, std::uint32_t>> due{};  ///< (round in which it is heard, its round)
  };
  void charge(std::uint32_t step, const ObstacleMapSample& sample);
  void carry(std::uint32_t step, const OnAir& from, const OnAir& to);
  void grow_old(std::uint32_t round);
  void note_partitions(std::uint32_t step, std::span<const OnAir> agents);

  RadioOptions options_;
  std::uint64_t seed_;
  std::uint32_t steps_per_decision_;
  double slot_bits_;
  std::map<AgentId, RadioBudget> budgets_;
  std::map<std::pair<AgentId, AgentId>, Link> links_;
  LinkCounts counts_;
  std::vector<PartitionChange> partitions_;
  std::uint32_t over_budget_ = 0;
  std::uint64_t sent_bytes_ = 0;
  std::uint64_t sent_samples_ = 0;
  std::optional<std::uint32_t> equal_since_;
};

}  // namespace skein
