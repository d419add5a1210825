#include "simworld/lockstep/repeats.hpp"

namespace skein {
namespace {

template <typename Sample>
void add_kept(const std::map<AgentId, Sample>& kept, AgentId agent, std::vector<Sample>& samples) {
  const auto found = kept.find(agent);
  if (found != kept.end()) samples.push_back(found->second);
}

template <typename Sample>
void add_of_round(const std::map<AgentId, Sample>& kept, const Need& need, std::vector<Sample>& samples) {
  const auto found = kept.find(need.agent);
  if (found != kept.end() && found->second.round == need.round) samples.push_back(found->second);
}

}  // namespace

void Repeats::keep(const Barrier& answers, const Tick& tick) {
  representatives_.clear();
  maps_.clear();
  for (const RosterEntry& entry : tick.roster) {
    const Answer* answer = answers.answer_of(entry.agent);
    if (answer->representative) representatives_[entry.agent] = *answer->representative;
    if (answer->obstacle_map) maps_[entry.agent] = *answer->obstacle_map;
  }
}

Repeated Repeats::asked_by(const Beacon& beacon) const {
  Repeated samples;
  for (const Need& need : beacon.needs) {
    if (need.topic == NeedTopic::ObstacleMap) {
      add_of_round(maps_, need, samples.maps);
    } else {
      add_of_round(representatives_, need, samples.representatives);
    }
  }
  return samples;
}

Repeated Repeats::counted_by(const Tick& tick) const {
  Repeated samples;
  for (const RosterEntry& entry : tick.roster) {
    if (entry.representative) add_kept(representatives_, entry.agent, samples.representatives);
    if (entry.obstacle_map) add_kept(maps_, entry.agent, samples.maps);
  }
  return samples;
}

}  // namespace skein
