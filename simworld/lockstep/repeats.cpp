#include "simworld/lockstep/repeats.hpp"

namespace skein {

void Repeats::keep(const Barrier& answers, const Tick& tick) {
  kept_.clear();
  for (const RosterEntry& entry : tick.roster) {
    const Answer* answer = answers.answer_of(entry.agent);
    if (answer->representative) kept_[entry.agent] = *answer->representative;
  }
}

std::vector<Representative> Repeats::asked_by(const Beacon& beacon) const {
  std::vector<Representative> samples;
  for (const Need& need : beacon.needs) {
    const auto found = kept_.find(need.agent);
    if (found != kept_.end() && found->second.round == need.round) samples.push_back(found->second);
  }
  return samples;
}

std::vector<Representative> Repeats::counted_by(const Tick& tick) const {
  std::vector<Representative> samples;
  for (const RosterEntry& entry : tick.roster) {
    const auto found = kept_.find(entry.agent);
    if (entry.representative && found != kept_.end()) samples.push_back(found->second);
  }
  return samples;
}

}  // namespace skein
