#include "agent/behaviours/replanning.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "planner/core/lockstep/plan_view.hpp"

namespace skein {
namespace {

constexpr double kSettle_s = 1.5;  ///< after braking, until a multirotor stands
constexpr double kBreak_s = 1.0;   ///< after the first failure; longer after each

std::uint32_t steps_of(double time_s, double step_s) {
  return static_cast<std::uint32_t>(std::ceil(time_s / step_s));
}

}  // namespace

Replanning::Replanning(const Mission& mission, AgentId self) : mission_(mission), self_(self) {}

bool Replanning::may_call(std::uint32_t step) const {
  if (engaged() || failures_ >= kMaxAttempts) return false;
  return failures_ == 0 || step >= failed_step_ + failures_ * steps_of(kBreak_s, mission_.step_s);
}

/// Enough for a multirotor to come to rest, and for the planning; a failure asks for more of both.
std::uint32_t Replanning::steps_to_switch() const {
  const VehicleSpec& own = vehicle_of(mission_, self_);
  const RendezvousOptions& options = mission_.planner;
  const double braking_s =
      own.type == VehicleType::Multirotor ? own.speed_mps / (0.5 * own.max_acceleration_mps2) + kSettle_s : 0.0;
  const std::uint32_t stages = std::min(failures_ + 2, static_cast<std::uint32_t>(options.max_segments));
  const auto rounds = static_cast<std::uint32_t>(options.generations + options.equalise_rounds + 2) * stages + 2;
  const auto per_step = static_cast<std::uint32_t>(options.rounds_per_step);
  const double slower = 1.0 + 0.5 * failures_;
  return std::max(steps_of(slower * braking_s, mission_.step_s), (rounds + per_step - 1) / per_step) + 2;
}

/// The switch step of calls that were published in the round before, its own included; nothing if there were none.
std::optional<std::uint32_t> Replanning::called_switch(const Tick& tick, std::span<const Representative> peers) const {
  const std::uint32_t before = tick.round - 1;
  std::optional<std::uint32_t> latest;
  const auto note = [&](const Revision& revision) {
    if (revision.attempt != before || revision.switch_step <= tick.step) return;
    latest = std::max(latest.value_or(0), revision.switch_step);
  };
  for (const Representative& peer : peers) {
    if (peer.revision) note(*peer.revision);
  }
  if (state_ == State::Called) note(own_);
  return latest;
}

/// Whoever is live now and was not when the attempt began has not accepted the plan.
bool Replanning::someone_came(const Tick& tick) const {
  return std::ranges::any_of(tick.roster, [this](const RosterEntry& now) {
    return std::ranges::none_of(
        crew_, [&](const RosterEntry& then) { return then.agent == now.agent && then.incarnation == now.incarnation; });
  });
}

ReplanEvent Replanning::hear(const Tick& tick, std::span<const Representative> peers, bool takes_part) {
  const std::optional<Representative> said = std::exchange(sample_, std::nullopt);
  if (!takes_part) {
    state_ = State::Idle;
    plan_.reset();
    return ReplanEvent::None;
  }
  if (const auto step = called_switch(tick, peers)) {
    state_ = State::Joined;
    attempt_ = tick.round - 1;
    crew_ = tick.roster;
    switch_step_ = *step;
    plan_.reset();
    return ReplanEvent::Join;
  }
  const State before = state_;
  if (before == State::Joined || before == State::Aiming) {
    const ReplanEvent event = aim_in_turn(tick, peers);
    if (event == ReplanEvent::Aim) return event;
  } else if (before == State::Planning) {
    plan(tick, peers, said);
  }
  const bool due = tick.phase == Phase::Flying && tick.step >= switch_step_;
  if (due && state_ == State::Ready && !someone_came(tick)) {
    state_ = State::Idle;
    failures_ = 0;
    return ReplanEvent::Switch;
  }
  if (due && engaged()) fail(tick);
  return before != State::Idle && state_ == State::Idle ? ReplanEvent::Fail : ReplanEvent::None;
}

double Replanning::shortest_of(AgentId agent, std::span<const Representative> peers) const {
  const auto peer = std::ranges::find(peers, agent, &Representative::agent);
  return peer == peers.end() ? shortest_m_ : peer->own_length_m;
}

/// Each chooses its final place knowing those before it, and where the others wait so far.
ReplanEvent Replanning::aim_in_turn(const Tick& tick, std::span<const Representative> peers) {
  joined_ = joiners(peers);
  goal_m_ = shortest_m_;
  for (const Representative& peer : peers) {
    if (peer.revision && peer.revision->attempt == attempt_) goal_m_ = std::max(goal_m_, peer.own_length_m);
  }
  if (state_ == State::Joined) {
    state_ = State::Aiming;
    first_turn_ = tick.round;
    first_ = joined_;
    order_.clear();
    for (const rendezvous::Joiner& joiner : joined_) order_.push_back({shortest_of(joiner.agent, peers), joiner.agent});
    std::ranges::stable_sort(order_, [](const Turn& a, const Turn& b) { return a.shortest_m > b.shortest_m; });
    avoided_ = rendezvous::united(joined_);
  }
  const std::uint32_t turn = tick.round - first_turn_;
  if (turn >= order_.size()) {
    open(tick);
    return ReplanEvent::None;
  }
  if (order_[turn].agent == self_) return ReplanEvent::Aim;
  publish_revision();
  return ReplanEvent::None;
}

void Replanning::call(const Tick& tick, Revision own) {
  if (engaged() || tick.phase != Phase::Flying) throw std::logic_error("a call is for flight rounds, one at a time");
  state_ = State::Called;
  own_ = std::move(own);
  own_.attempt = tick.round;
  own_.switch_step = tick.step + steps_to_switch();
  publish_revision();
}

void Replanning::join(Revision own, double shortest_m) {
  if (state_ != State::Joined) throw std::logic_error("there is no attempt to join");
  own_ = std::move(own);
  own_.attempt = attempt_;
  own_.switch_step = switch_step_;
  shortest_m_ = shortest_m;
  publish_revision();
}

void Replanning::aim(const Pose& pose, double shortest_m, std::uint32_t earliest_step) {
  if (state_ != State::Aiming) throw std::logic_error("there is nothing to aim for");
  own_.pose = pose;
  own_.switch_step = std::max(switch_step_, earliest_step);
  shortest_m_ = shortest_m;
  publish_revision();
}

void Replanning::publish_revision() {
  sample_.emplace();
  sample_->agent = self_;
  sample_->own_length_m = shortest_m_;
  sample_->revision = own_;
}

/// Who published a revision of the attempt in the round before, this agent included.
std::vector<rendezvous::Joiner> Replanning::joiners(std::span<const Representative> peers) const {
  std::vector<rendezvous::Joiner> all{{self_, own_}};
  for (const Representative& peer : peers) {
    if (peer.revision && peer.revision->attempt == attempt_) all.push_back({peer.agent, *peer.revision});
  }
  std::ranges::sort(all, {}, &rendezvous::Joiner::agent);
  return all;
}

/// All that aimed plan together.
void Replanning::open(const Tick& tick) {
  const std::vector<rendezvous::Joiner>& all = joined_;
  for (const rendezvous::Joiner& joiner : all) switch_step_ = std::max(switch_step_, joiner.revision.switch_step);
  const Mission mission = rendezvous::revised(mission_, all, attempt_);
  try {
    plan_.emplace(
        NewPlan{rendezvous::Planner(mission, self_), mission.vehicles.front().speed_mps, rendezvous::united(all), 0});
  } catch (const std::invalid_argument&) {  // of all alike: one promised a pose that nobody can plan from
    return fail(tick);
  }
  state_ = State::Planning;
  sample_ = plan_->planner.advance({}).representative;
}

void Replanning::plan(const Tick& tick, std::span<const Representative> peers,
                      const std::optional<Representative>& said) {
  std::vector<Representative> usable;
  for (const Representative& peer : peers) {
    if (!peer.revision && plan_->planner.can_use(peer)) usable.push_back(peer);
  }
  const rendezvous::PlanRound round = plan_->planner.advance(usable);
  if (round.status == rendezvous::PlanStatus::Failed) return fail(tick);
  if (round.status == rendezvous::PlanStatus::Ready) {
    state_ = State::Ready;
    plan_->view = plan_view_of(usable, said);
  } else {
    sample_ = round.representative;
  }
}

void Replanning::fail(const Tick& tick) {
  state_ = State::Idle;
  ++failures_;
  failed_step_ = tick.step;
  plan_.reset();
  sample_.reset();
}

NewPlan Replanning::take() {
  if (!plan_) throw std::logic_error("there is no new plan");
  NewPlan plan = std::move(*plan_);
  plan_.reset();
  return plan;
}

void Replanning::add_to(StateHash& hash) const {
  for (const RosterEntry& entry : crew_) hash.add(entry.agent).add(entry.incarnation);
  hash.add(state_).add(attempt_).add(switch_step_).add(failures_).add(failed_step_);
  if (engaged()) skein::add_to(hash, own_);
  hash.add(shortest_m_).add(goal_m_);
  if (plan_) plan_->planner.add_to(hash);
}

}  // namespace skein
