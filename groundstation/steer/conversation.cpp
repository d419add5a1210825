#include "groundstation/steer/conversation.hpp"

#include <algorithm>
#include <variant>

#include "idl/convert/convert.hpp"

namespace skein {

void Conversation::take(const bus::ObserverInbound& sample) {
  if (const auto* tick = std::get_if<wire::Tick>(&sample)) {
    const Checked<Tick> checked = from_wire(*tick, {});
    if (checked.ok()) on_tick(checked.value());
  } else if (const auto* beacon = std::get_if<wire::Beacon>(&sample)) {
    const Checked<Beacon> checked = from_wire(*beacon, {});
    if (checked.ok()) on_beacon(checked.value());
  }
}

void Conversation::on_tick(const Tick& tick) {
  run_ = tick.run;
  const bool takes_up = std::ranges::find(tick.orders, id_, &Order::id) != tick.orders.end();
  if (takes_up && !answer_) answer_ = OrderAnswer{id_, OrderResult::Accepted, tick.round, {}, ""};
  if (!knows_concerned_) {
    live_.clear();
    for (const RosterEntry& entry : tick.roster) live_.push_back(entry.agent);
    knows_concerned_ = takes_up;
  }
  const auto said = std::ranges::find(tick.answers, id_, &OrderAnswer::id);
  if (said == tick.answers.end()) return;
  answer_ = *said;
  acknowledged_.insert(said->acknowledged.begin(), said->acknowledged.end());
}

void Conversation::on_beacon(const Beacon& beacon) {
  if (std::ranges::find(beacon.acknowledged, id_) != beacon.acknowledged.end()) acknowledged_.insert(beacon.agent);
}

std::vector<AgentId> Conversation::missing() const {
  std::vector<AgentId> missing;
  if (!acknowledges_) return missing;
  const std::vector<AgentId> concerned = agent_ == kAllAgents ? live_ : std::vector<AgentId>{agent_};
  std::ranges::copy_if(concerned, std::back_inserter(missing),
                       [this](AgentId agent) { return !acknowledged_.contains(agent); });
  return missing;
}

bool Conversation::complete() const {
  return answer_ && (!accepted() || missing().empty());
}

}  // namespace skein
