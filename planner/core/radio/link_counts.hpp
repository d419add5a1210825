// What the radio carried on each link, for the report: samples, bytes, losses, and how old what a reader uses is.
//
// The age of a link in a round is the number of rounds since the sample that its receiver uses was composed; 1 is the
// least. Ages are counted, so that quantiles are exact: the least age that at least the share q of the rounds had.
// Source: docs/report.md. Complexity: O(log links) a sample or round; quantiles O(largest age).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein {

struct LinkCount {
  std::uint64_t samples = 0;  ///< heard
  std::uint64_t bytes = 0;    ///< of those, CDR payload
  std::uint64_t lost = 0;     ///< in range, and not heard

  void add_age(std::uint32_t rounds);
  /// In rounds; 0 if nothing was ever heard. @param q 0 to 1
  [[nodiscard]] std::uint32_t age_quantile(double q) const;
  /// Into the counts of several links.
  void add(const LinkCount& other);

  bool operator==(const LinkCount&) const = default;

 private:
  std::vector<std::uint64_t> ages_;  ///< rounds with that age; the last entry stands for it and over
};

class LinkCounts {
 public:
  void heard(AgentId sender, AgentId receiver, std::size_t payload_bytes);
  void lost(AgentId sender, AgentId receiver) { ++links_[{sender, receiver}].lost; }
  /// Once a round for each link of which something was heard.
  void age(AgentId sender, AgentId receiver, std::uint32_t rounds) { links_[{sender, receiver}].add_age(rounds); }

  /// By (sender, receiver).
  [[nodiscard]] const std::map<std::pair<AgentId, AgentId>, LinkCount>& links() const { return links_; }
  [[nodiscard]] LinkCount total() const;

 private:
  std::map<std::pair<AgentId, AgentId>, LinkCount> links_;
};

/// A link between two agents, in either direction.
using RadioLink = std::pair<AgentId, AgentId>;

/// How many groups the agents fall into that no radio link joins, directly or over others.
/// @param ids ascending; links of others are left out
[[nodiscard]] std::size_t count_partitions(std::span<const AgentId> ids, std::span<const RadioLink> links);

}  // namespace skein
