#include "simworld/lockstep/radio_log.hpp"

#include <algorithm>

#include "planner/core/radio/radio.hpp"

namespace skein {
namespace {

constexpr std::size_t kMaxChanges = 10'000;  ///< of partitions: later ones are left out

std::size_t size_of(const ObstacleMapSample& sample) {
  return payload_bytes(sample.tiles.size(), sample.seen.size());
}

}  // namespace

RadioLog::RadioLog(const Mission& mission)
    : options_(mission.transit->radio),
      seed_(mission.seed),
      steps_per_decision_(steps_per_decision(mission)),
      slot_bits_(0.0) {
  for (std::size_t rank = 0; rank < mission.vehicles.size(); ++rank) {
    const auto placed = budgets_.try_emplace(mission.vehicles[rank].id, options_, share_of(mission, rank));
    slot_bits_ = placed.first->second.slot_bits();
  }
}

void RadioLog::add(std::uint32_t step, std::uint32_t round, std::span<const OnAir> agents) {
  for (const OnAir& from : agents) {
    if (from.sample == nullptr) continue;
    charge(step, *from.sample);
    for (const OnAir& to : agents) {
      if (to.agent != from.agent) carry(step, from, to);
    }
  }
  grow_old(round + 1);
  note_partitions(step, agents);
  const bool equal = std::ranges::adjacent_find(agents, std::not_equal_to<>(), &OnAir::map_hash) == agents.end();
  if (!equal) {
    equal_since_.reset();
  } else if (!equal_since_) {
    equal_since_ = step;
  }
}

void RadioLog::charge(std::uint32_t step, const ObstacleMapSample& sample) {
  const std::size_t bytes = size_of(sample);
  const std::uint32_t decision = (step - 1) / steps_per_decision_ + 1;
  RadioBudget& budget = budgets_.at(sample.agent);
  sent_bytes_ += bytes;
  ++sent_samples_;
  if (bytes > budget.at(decision).payload_bytes) {
    ++over_budget_;
  } else {
    budget.sent(decision, bytes);
  }
}

void RadioLog::carry(std::uint32_t step, const OnAir& from, const OnAir& to) {
  if (!in_range(options_, from.position_m, to.position_m)) return;
  if (is_lost(options_, seed_, from.agent, to.agent, step, from.sample->round)) {
    return counts_.lost(from.agent, to.agent);
  }
  counts_.heard(from.agent, to.agent, size_of(*from.sample));
  Link& link = links_[{from.agent, to.agent}];
  link.due.emplace_back(from.sample->round + 1 + latency_of(options_), from.sample->round);
}

void RadioLog::grow_old(std::uint32_t round) {
  for (auto& [ends, link] : links_) {
    for (const auto& [due, composed] : link.due) {
      if (due <= round) link.used_round = std::max(link.used_round, composed);
    }
    std::erase_if(link.due, [round](const auto& entry) { return entry.first <= round; });
    if (link.used_round > 0) counts_.age(ends.first, ends.second, round - link.used_round);
  }
}

void RadioLog::note_partitions(std::uint32_t step, std::span<const OnAir> agents) {
  std::vector<AgentId> ids;
  std::vector<RadioLink> links;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    ids.push_back(agents[i].agent);
    for (std::size_t j = 0; j < i; ++j) {
      if (!in_range(options_, agents[i].position_m, agents[j].position_m)) continue;
      links.emplace_back(agents[j].agent, agents[i].agent);
    }
  }
  const std::size_t groups = count_partitions(ids, links);
  if (partitions_.size() == kMaxChanges || (!partitions_.empty() && partitions_.back().groups == groups)) return;
  partitions_.push_back({step, groups});
}

double RadioLog::peak_bits() const {
  double peak = 0.0;
  for (const auto& [agent, budget] : budgets_) peak = std::max(peak, budget.peak_bits());
  return peak;
}

}  // namespace skein
