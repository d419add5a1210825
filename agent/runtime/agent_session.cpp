#include "agent/runtime/agent_session.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "agent/behaviours/commanded.hpp"
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
  if (incarnation > 1) behaviour_ = make_rejoined_behaviour(mission_, id_);
}

/// Dropped: nothing of its former life is left but the mission and the newest tick.
void AgentSession::start_over() {
  state_ = State::Introducing;
  dropped_ = true;
  incarnation_ = 0;
  behaviour_ = make_behaviour(mission_, id_);
  sense_.reset();
  acknowledged_.clear();
  forget_peers();
  done_round_ = 0;
  last_ = {};
  sent_.reset();
  sent_map_.reset();
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
    const std::uint32_t before = tick_->round - 1;
    if (entry.representative && heard_.find(before, entry.agent, entry.incarnation) == nullptr) {
      needs.push_back({entry.agent, before});
    }
    if (entry.obstacle_map && heard_maps_.find(before, entry.agent, entry.incarnation) == nullptr) {
      needs.push_back({entry.agent, before, NeedTopic::ObstacleMap});
    }
  }
  return needs;
}

/// What the open tick orders, from this round on.
void AgentSession::obey() {
  acknowledged_.clear();
  for (const Order& order : tick_->orders) {
    if (!concerns(order, id_)) continue;
    acknowledged_.push_back(order.id);
    if (order.kind == OrderKind::Start || order.kind == OrderKind::Abort) continue;
    if (behaviour_->obey(order)) continue;
    behaviour_ = std::make_unique<CommandedBehaviour>(mission_, id_, std::move(behaviour_));
    behaviour_->obey(order);
  }
}

void AgentSession::answer(double now_s) {
  const Tick& tick = *tick_;
  std::vector<Representative> peers;
  std::vector<ObstacleMapSample> maps;
  for (const RosterEntry& entry : tick.roster) {
    if (entry.agent == id_) continue;
    if (entry.representative) {
      const Representative& heard = *heard_.find(tick.round - 1, entry.agent, entry.incarnation);
      if (behaviour_->can_use(heard)) peers.push_back(heard);
    }
    if (entry.obstacle_map) maps.push_back(*heard_maps_.find(tick.round - 1, entry.agent, entry.incarnation));
  }
  obey();
  const bool sensed = sense_ && sense_->round == tick.round;
  last_ = behaviour_->on_round({tick, sensed ? &*sense_ : nullptr, peers, maps});
  done_round_ = tick.round;
  heard_.forget_before(tick.round);
  heard_maps_.forget_before(tick.round);
  sent_ = std::exchange(last_.representative, std::nullopt);
  sent_map_ = std::exchange(last_.obstacle_map, std::nullopt);
  StateHash hash;
  behaviour_->add_to(hash);
  if (sent_) {
    sign(*sent_);
    hash.add(sent_->stage).add(sent_->violated).add(std::span<const double>(sent_->particle)).add(sent_->cost);
    hash.add(sent_->own_length_m).add(sent_->path_length_m);
    if (sent_->revision) add_to(hash, *sent_->revision);
  }
  if (sent_map_) {
    sign(*sent_map_);
    add_to(hash, *sent_map_);
  }
  state_hash_ = hash.value();
  publish_answer(now_s);
  if (tick.phase == Phase::Finished) state_ = State::Finished;
}

template <typename Sample>
void AgentSession::sign(Sample& sample) const {
  sample.run = run_;
  sample.agent = id_;
  sample.incarnation = incarnation_;
  sample.round = tick_->round;
}

void AgentSession::forget_peers() {
  heard_.clear();
  heard_maps_.clear();
}

void AgentSession::publish_answer(double now_s) {
  if (sent_) send(*sent_, now_s);
  if (sent_map_) send(*sent_map_, now_s);
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
  beacon.obstacle_map = sent_map_.has_value();
  if (state_ == State::Introducing) beacon.matched = matched_;
  beacon.mode = last_.mode;
  beacon.constraint = last_.constraint;
  beacon.constraint_peer = last_.constraint_peer;
  if (sense_) beacon.pose = sense_->pose;
  beacon.commanded_velocity_mps = last_.commanded_velocity_mps;
  beacon.planned_length_m = last_.planned_length_m;
  beacon.cost = last_.cost;
  beacon.generation = last_.generation;
  beacon.map_hash = last_.map_hash;
  beacon.plan_view = last_.plan_view;
  beacon.safety_mode = last_.safety_mode;
  beacon.safety_reason = last_.safety_reason;
  beacon.deviation_m = last_.deviation_m;
  beacon.predicted_separation_m = last_.predicted_separation_m;
  beacon.state_hash = state_hash_;
  beacon.acknowledged = acknowledged_;
  return beacon;
}

void AgentSession::leave(double now_s) {
  Beacon goodbye = beacon();
  goodbye.mode = AgentMode::Leaving;
  send(goodbye, now_s);
}

}  // namespace skein
