#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "agent/runtime/agent_session.hpp"

namespace skein {

void AgentSession::on_sample(const wire::Mission& sample, double /*now_s*/) {
  if (sample.head().run() == run_ && behaviour_ != nullptr) return;
  // who waits may hear of a world that died, and then of its successor
  if (state_ != State::Introducing) return faults_.add(WireFaultReason::WrongRun);
  const Checked<Mission> checked = from_wire(sample, {});
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  run_ = sample.head().run();
  if (tick_ && tick_->run != run_) tick_.reset();  // heard before it was known whose mission this is
  mission_ = checked.value();
  ids_ = ids_of(mission_);
  grid_.reset();
  if (mission_.transit) grid_ = grid_of(*mission_.transit);
  sense_.reset();
  forget_peers();
  if (!std::ranges::binary_search(ids_, id_)) {
    state_ = State::TurnedAway;
    reason_ = fmt::format("the mission has no vehicle {}", id_);
    return;
  }
  behaviour_ = make_behaviour(mission_, id_);
  last_sent_s_ = -1e9;  // the world waits to hear that the mission is here
}

void AgentSession::on_sample(const wire::Tick& sample, double now_s) {
  WireContext context;
  context.known = ids_;
  if (run_ != 0) context.run = run_;
  Checked<Tick> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  heard_world_s_ = now_s;
  ever_heard_ = true;
  const Tick& tick = checked.value();
  if (tick_ && tick.round < tick_->round) return;
  repeat_ = tick_ && tick.round == tick_->round && tick.round == done_round_;
  if (!tick_ || tick.round > tick_->round) tick_heard_s_ = now_s;
  const auto refused = std::ranges::find(tick.refused, nonce_, &Refusal::nonce);
  if (state_ == State::Introducing && refused != tick.refused.end()) refused_ = refused->reason;
  tick_ = std::move(checked).value();
  if (tick_->round == 0) return;
  heard_.forget_before(tick_->round - 1);
  heard_maps_.forget_before(tick_->round - 1);
}

void AgentSession::on_sample(const wire::Sense& sample, double /*now_s*/) {
  WireContext context;
  context.known = ids_;
  context.run = run_;
  Checked<Sense> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  const Sense& sense = checked.value();
  if (sense.agent != id_) return faults_.add(WireFaultReason::UnknownAgent);
  if (state_ == State::Live && sense.incarnation != incarnation_) {
    return faults_.add(WireFaultReason::WrongIncarnation);
  }
  if (tick_ && sense.round > open_round() + 1) return faults_.add(WireFaultReason::OutOfRange);
  if (sense_ && sense.round < sense_->round) return;  // a late copy
  sense_ = std::move(checked).value();
}

void AgentSession::on_sample(const wire::Representative& sample, double /*now_s*/) {
  hear(sample, heard_, [this](const Representative& value) { return behaviour_->can_use(value); });
}

void AgentSession::on_sample(const wire::ObstacleMap& sample, double /*now_s*/) {
  hear(sample, heard_maps_, [](const ObstacleMapSample&) { return true; });
}

template <typename Sample, typename Wire, typename Usable>
void AgentSession::hear(const Wire& sample, PeerSamples<Sample>& heard, const Usable& usable) {
  WireContext context;
  if (behaviour_ == nullptr) return faults_.add(WireFaultReason::WrongRun);  // no run is known yet
  context.known = ids_;
  context.run = run_;
  context.grid = grid_;
  Checked<Sample> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  Sample value = std::move(checked).value();
  if (value.agent == id_ || value.round < done_round_) return;  // a copy of what was used already
  if (value.round > open_round() + 1) return faults_.add(WireFaultReason::OutOfRange);
  if (!may_count(value)) return faults_.add(WireFaultReason::WrongIncarnation);
  if (!usable(value)) faults_.add(WireFaultReason::OutOfRange);
  heard.put(std::move(value), usable);
}

template <typename Sample>
bool AgentSession::may_count(const Sample& sample) const {
  if (state_ != State::Live) return true;
  const auto entry = std::ranges::find(tick_->roster, sample.agent, &RosterEntry::agent);
  const bool ahead = sample.round > open_round();  // of a roster that is not here yet: who came back is newer
  if (entry == tick_->roster.end()) return ahead;
  return sample.incarnation == entry->incarnation || (ahead && sample.incarnation > entry->incarnation);
}

}  // namespace skein
