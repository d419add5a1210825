#include "agent/runtime/agent_session.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

constexpr double kIntroduce_s = 0.25;
constexpr double kNeeds_s = 1.0;
constexpr double kAway_s = 2.0;  ///< between two polls: this process was stopped

}  // namespace

AgentSession::AgentSession(AgentId id, std::uint64_t nonce, bus::AgentPort& port, double now_s)
    : id_(id), nonce_(nonce), port_(port), heard_world_s_(now_s) {}

template <typename Value>
void AgentSession::send(const Value& value, double now_s) {
  port_.publish(to_wire(value, {static_cast<std::int64_t>(now_s * 1e9), run_}));
  last_sent_s_ = now_s;
}

void AgentSession::poll(double now_s) {
  if (last_poll_s_ && now_s - *last_poll_s_ > kAway_s) heard_world_s_ += now_s - *last_poll_s_;
  last_poll_s_ = now_s;
  act(now_s);
  const bool live = state_ == State::Live && tick_;
  const bool owes = live && tick_->round > done_round_;
  port_.wake_after(owes ? lacking().size() : live ? bus::kOnTick : 0);
}

void AgentSession::act(double now_s) {
  take(now_s);
  if (tick_ && (state_ == State::Introducing || state_ == State::Live)) follow_roster();
  if (state_ == State::Introducing) introduce(now_s);
  if (state_ != State::Live || !tick_) return;
  if (tick_->round > done_round_) {
    const std::vector<Need> needs = lacking();
    if (needs.empty()) return answer(now_s);
    if (now_s - std::max(tick_heard_s_, last_sent_s_) < kNeeds_s) return;
    Beacon open = beacon();
    open.needs = needs;
    send(open, now_s);
  } else if (std::exchange(repeat_, false)) {
    publish_answer(now_s);
  }
}

double AgentSession::idle_s(double now_s) const {
  if (state_ == State::Introducing) return std::clamp(last_sent_s_ + kIntroduce_s - now_s, 0.0, kIntroduce_s);
  const bool owes = state_ == State::Live && tick_ && tick_->round > done_round_;
  if (!owes) return kNeeds_s;
  return std::clamp(std::max(tick_heard_s_, last_sent_s_) + kNeeds_s - now_s, 0.0, kNeeds_s);
}

void AgentSession::take(double now_s) {
  inbox_.clear();
  port_.take(inbox_);
  for (const bus::AgentInbound& sample : inbox_) {
    std::visit([&](const auto& typed) { on_sample(typed, now_s); }, sample);
  }
}

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
  sense_.reset();
  heard_.clear();
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
  if (tick_->round > 0) heard_.erase(heard_.begin(), heard_.lower_bound({tick_->round - 1, 0}));
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
  WireContext context;
  if (behaviour_ == nullptr) return faults_.add(WireFaultReason::WrongRun);  // no run is known yet
  context.known = ids_;
  context.run = run_;
  Checked<Representative> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  Representative value = std::move(checked).value();
  if (value.agent == id_ || value.round < done_round_) return;  // a copy of what was used already
  if (value.round > open_round() + 1) return faults_.add(WireFaultReason::OutOfRange);
  if (!may_count(value)) return faults_.add(WireFaultReason::WrongIncarnation);
  const bool usable = behaviour_->can_use(value);
  if (!usable) faults_.add(WireFaultReason::OutOfRange);
  const auto [place, fresh] = heard_.try_emplace({value.round, value.agent}, value);
  if (fresh) return;
  // the first one stands, unless a peer's own planner cannot have published it or the roster has overtaken it
  const bool stands = place->second.incarnation == value.incarnation && behaviour_->can_use(place->second);
  if (!stands && usable) place->second = std::move(value);
}

bool AgentSession::may_count(const Representative& sample) const {
  if (state_ != State::Live) return true;
  const auto entry = std::ranges::find(tick_->roster, sample.agent, &RosterEntry::agent);
  const bool ahead = sample.round > open_round();  // of a roster that is not here yet: who came back is newer
  if (entry == tick_->roster.end()) return ahead;
  return sample.incarnation == entry->incarnation || (ahead && sample.incarnation > entry->incarnation);
}

void AgentSession::introduce(double now_s) {
  std::vector<std::uint64_t> matched = port_.matched();
  if (now_s - last_sent_s_ < kIntroduce_s && matched == matched_) return;
  matched_ = std::move(matched);
  send(beacon(), now_s);
}

void AgentSession::follow_roster() {
  const Tick& tick = *tick_;
  if (state_ == State::Introducing && refused_) {
    state_ = State::TurnedAway;
    reason_ = fmt::format("the world refused agent {}: {}", id_, name_of(*refused_));
    return;
  }
  const bool over = tick.phase == Phase::Finished;
  const auto own = std::ranges::find(tick.roster, nonce_, &RosterEntry::nonce);
  const bool listed = own != tick.roster.end() && own->agent == id_;
  if (state_ == State::Introducing) {
    if (listed && behaviour_ != nullptr) {
      become_live(own->incarnation);
    } else if (over && tick.run == run_) {
      state_ = dropped_ ? State::Dropped : State::TurnedAway;
      reason_ = dropped_ ? fmt::format("the world went on without agent {}, and ended", id_)
                         : fmt::format("the world ended before agent {} took part", id_);
    }
  } else if (!listed && over) {
    state_ = State::Dropped;
    reason_ = fmt::format("the world went on without agent {}, and ended", id_);
  } else if (!listed) {
    start_over();
  }
}

void AgentSession::become_live(std::uint32_t incarnation) {
  state_ = State::Live;
  incarnation_ = incarnation;
  if (incarnation > 1) behaviour_ = make_rejoined_behaviour();
}

/// Dropped: nothing of its former life is left but the mission and the newest tick.
void AgentSession::start_over() {
  state_ = State::Introducing;
  dropped_ = true;
  incarnation_ = 0;
  behaviour_ = make_behaviour(mission_, id_);
  sense_.reset();
  heard_.clear();
  done_round_ = 0;
  last_ = {};
  sent_.reset();
  state_hash_ = 0;
  repeat_ = false;
  last_sent_s_ = -1e9;
}

std::vector<Need> AgentSession::lacking() const {
  std::vector<Need> needs;
  for (const RosterEntry& entry : tick_->roster) {
    if (entry.agent == id_) {
      const bool sensed = sense_ && sense_->round == tick_->round && sense_->incarnation == incarnation_;
      if (entry.sense && !sensed) needs.push_back({id_, tick_->round});
      continue;
    }
    if (!entry.representative) continue;
    const auto found = heard_.find({tick_->round - 1, entry.agent});
    if (found == heard_.end() || found->second.incarnation != entry.incarnation) {
      needs.push_back({entry.agent, tick_->round - 1});
    }
  }
  return needs;
}

void AgentSession::answer(double now_s) {
  const Tick& tick = *tick_;
  std::vector<Representative> peers;
  for (const RosterEntry& entry : tick.roster) {
    if (entry.agent == id_ || !entry.representative) continue;
    const Representative& heard = heard_.at({tick.round - 1, entry.agent});
    if (behaviour_->can_use(heard)) peers.push_back(heard);
  }
  const bool sensed = sense_ && sense_->round == tick.round;
  last_ = behaviour_->on_round({tick, sensed ? &*sense_ : nullptr, peers});
  done_round_ = tick.round;
  heard_.erase(heard_.begin(), heard_.lower_bound({tick.round, 0}));
  sent_ = std::exchange(last_.representative, std::nullopt);
  StateHash hash;
  behaviour_->add_to(hash);
  if (sent_) {
    sent_->run = run_;
    sent_->agent = id_;
    sent_->incarnation = incarnation_;
    sent_->round = tick.round;
    hash.add(sent_->stage).add(sent_->violated).add(std::span<const double>(sent_->particle)).add(sent_->cost);
    hash.add(sent_->own_length_m).add(sent_->path_length_m);
  }
  state_hash_ = hash.value();
  publish_answer(now_s);
  if (tick.phase == Phase::Finished) state_ = State::Finished;
}

void AgentSession::publish_answer(double now_s) {
  if (sent_) send(*sent_, now_s);
  Beacon closing = beacon();
  closing.closes_round = true;
  send(closing, now_s);
}

Beacon AgentSession::beacon() const {
  Beacon beacon;
  beacon.run = run_;
  beacon.agent = id_;
  beacon.incarnation = incarnation_;
  beacon.nonce = nonce_;
  beacon.round = state_ == State::Introducing ? open_round() : done_round_;
  beacon.step = step();
  beacon.representative = sent_.has_value();
  if (state_ == State::Introducing) beacon.matched = matched_;
  beacon.mode = last_.mode;
  beacon.constraint = last_.constraint;
  beacon.constraint_peer = last_.constraint_peer;
  if (sense_) beacon.pose = sense_->pose;
  beacon.commanded_velocity_mps = last_.commanded_velocity_mps;
  beacon.planned_length_m = last_.planned_length_m;
  beacon.cost = last_.cost;
  beacon.generation = last_.generation;
  beacon.state_hash = state_hash_;
  return beacon;
}

void AgentSession::leave(double now_s) {
  Beacon goodbye = beacon();
  goodbye.mode = AgentMode::Leaving;
  send(goodbye, now_s);
}

}  // namespace skein
