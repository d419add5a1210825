#include "simworld/lockstep/barrier.hpp"

#include <algorithm>

namespace skein {

void Barrier::open(const Tick& tick, double now_s) {
  round_ = tick.round;
  opened_s_ = now_s;
  parts_.clear();
  for (const RosterEntry& entry : tick.roster) parts_[entry.agent].incarnation = entry.incarnation;
}

Barrier::Part* Barrier::part_of(AgentId agent, std::uint32_t incarnation, std::uint32_t round) {
  const auto found = parts_.find(agent);
  if (round != round_ || found == parts_.end() || found->second.incarnation != incarnation) return nullptr;
  return &found->second;
}

bool Barrier::accept(const Beacon& beacon) {
  Part* part = part_of(beacon.agent, beacon.incarnation, beacon.round);
  if (part == nullptr || !beacon.closes_round || part->answer.beacon) return false;
  part->answer.beacon = beacon;
  return true;
}

bool Barrier::accept(const Representative& sample) {
  Part* part = part_of(sample.agent, sample.incarnation, sample.round);
  if (part == nullptr || part->answer.representative) return false;
  part->answer.representative = sample;
  return true;
}

bool Barrier::accept(const ObstacleMapSample& sample) {
  Part* part = part_of(sample.agent, sample.incarnation, sample.round);
  if (part == nullptr || part->answer.obstacle_map) return false;
  part->answer.obstacle_map = sample;
  return true;
}

void Barrier::excuse(AgentId agent) {
  const auto found = parts_.find(agent);
  if (found != parts_.end()) found->second.excused = true;
}

bool Barrier::closed(const Part& part) {
  if (part.excused) return true;
  const Answer& answer = part.answer;
  return answer.beacon && (!answer.beacon->representative || answer.representative.has_value()) &&
         (!answer.beacon->obstacle_map || answer.obstacle_map.has_value());
}

bool Barrier::complete() const {
  return std::ranges::all_of(parts_, [](const auto& entry) { return closed(entry.second); });
}

std::vector<AgentId> Barrier::waiting_for() const {
  std::vector<AgentId> ids;
  for (const auto& [id, part] : parts_) {
    if (!closed(part)) ids.push_back(id);
  }
  return ids;
}

std::size_t Barrier::lacking_beacons() const {
  const auto lacks = [](const auto& entry) { return !entry.second.excused && !entry.second.answer.beacon; };
  return static_cast<std::size_t>(std::ranges::count_if(parts_, lacks));
}

const Answer* Barrier::answer_of(AgentId agent) const {
  const auto found = parts_.find(agent);
  return found == parts_.end() ? nullptr : &found->second.answer;
}

}  // namespace skein
