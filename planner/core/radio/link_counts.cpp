#include "planner/core/radio/link_counts.hpp"

#include <algorithm>
#include <numeric>

namespace skein {
namespace {

constexpr std::size_t kOldest = 4095;

}  // namespace

void LinkCount::add_age(std::uint32_t rounds) {
  const std::size_t age = std::min<std::size_t>(rounds, kOldest);
  if (ages_.size() <= age) ages_.resize(age + 1, 0);
  ++ages_[age];
}

std::uint32_t LinkCount::age_quantile(double q) const {
  const std::uint64_t rounds = std::accumulate(ages_.begin(), ages_.end(), std::uint64_t{0});
  std::uint64_t up_to = 0;
  for (std::size_t age = 0; age < ages_.size(); ++age) {
    up_to += ages_[age];
    if (up_to > 0 && static_cast<double>(up_to) >= q * static_cast<double>(rounds)) {
      return static_cast<std::uint32_t>(age);
    }
  }
  return 0;
}

void LinkCount::add(const LinkCount& other) {
  samples += other.samples;
  bytes += other.bytes;
  lost += other.lost;
  if (ages_.size() < other.ages_.size()) ages_.resize(other.ages_.size(), 0);
  for (std::size_t age = 0; age < other.ages_.size(); ++age) ages_[age] += other.ages_[age];
}

void LinkCounts::heard(AgentId sender, AgentId receiver, std::size_t payload_bytes) {
  LinkCount& link = links_[{sender, receiver}];
  ++link.samples;
  link.bytes += payload_bytes;
}

LinkCount LinkCounts::total() const {
  LinkCount sum;
  for (const auto& [link, count] : links_) sum.add(count);
  return sum;
}

std::size_t count_partitions(std::span<const AgentId> ids, std::span<const RadioLink> links) {
  std::vector<std::size_t> group(ids.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto group_of = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  const auto rank_of = [&](AgentId id) {
    return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
  };
  for (const auto& [a, b] : links) {
    const std::size_t i = rank_of(a);
    const std::size_t j = rank_of(b);
    if (i < ids.size() && j < ids.size() && ids[i] == a && ids[j] == b) group[group_of(i)] = group_of(j);
  }
  std::size_t groups = 0;
  for (std::size_t i = 0; i < group.size(); ++i) groups += group[i] == i ? 1 : 0;
  return groups;
}

}  // namespace skein
