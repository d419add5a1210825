#include "simworld/lockstep/world_session.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace skein {
namespace {

constexpr double kWaitingTick_s = 0.5;
constexpr double kResend_s = 1.0;
constexpr double kMission_s = 2.0;  ///< an agent that lacks the mission for so long gets it again
constexpr double kGoodbye_s = 2.0;  ///< how long the final tick waits for its answers
constexpr double kAway_s = 1.0;     ///< between two polls: the world itself was stopped, not the agents

}  // namespace

WorldSession::WorldSession(const Scenario& scenario, SessionOptions options, bus::WorldPort& port,
                           ProcessControl* control, double now_s)
    : mission_(scenario.mission),
      deadline_s_(scenario.lockstep.deadline_s),
      options_(std::move(options)),
      port_(port),
      control_(control),
      run_(options_.run, scenario.mission, scenario.world, options_.fail_fast),
      admission_(options_.run, options_.nonce, ids_of(scenario.mission), deadline_s_) {
  if (control_ == nullptr && !options_.faults.empty()) {
    throw std::invalid_argument("faults need a launcher that can end processes");
  }
  times_.created_s = now_s;
  tick_.run = options_.run;
  if (options_.settle_s <= 0.0) publish_mission(now_s);
}

template <typename Value>
void WorldSession::send(const Value& value, TopicCount& count, double now_s) {
  const auto sample = to_wire(value, {static_cast<std::int64_t>(now_s * 1e9), options_.run});
  ++count.samples;
  count.bytes += std::remove_cvref_t<decltype(sample)>::getCdrSerializedSize(sample);
  port_.publish(sample);
}

void WorldSession::poll(double now_s) {
  if (state_ == State::Done) return;
  act(now_s);
  port_.wake_after(state_ == State::Waiting ? 0 : barrier_.lacking_beacons());
}

void WorldSession::act(double now_s) {
  if (last_poll_s_ && now_s - *last_poll_s_ > kAway_s) away_s_ += now_s - *last_poll_s_;
  last_poll_s_ = now_s;
  take(now_s);
  switch (state_) {
    case State::Waiting:
      return poll_waiting(now_s);
    case State::Running:
      return poll_running(now_s);
    case State::Closing:
      return poll_closing(now_s);
    case State::Done:
      return;
  }
}

double WorldSession::idle_s(double now_s) const {
  double due_s = last_sent_s_ + (state_ == State::Waiting ? kWaitingTick_s : kResend_s);
  if (state_ == State::Running && !awaited_.empty()) due_s = awaited_since_s_ + deadline_s_;
  if (state_ == State::Closing) due_s = barrier_.opened_s() + kGoodbye_s;
  return std::clamp(due_s - now_s, 0.0, kWaitingTick_s);
}

void WorldSession::take(double now_s) {
  inbox_.clear();
  port_.take(inbox_);
  for (const bus::WorldInbound& sample : inbox_) {
    std::visit([&](const auto& typed) { on_sample(typed, now_s); }, sample);
  }
}

void WorldSession::on_sample(const wire::Beacon& sample, double now_s) {
  WireContext context;
  context.run = options_.run;
  if (state_ != State::Waiting) context.roster = tick_.roster;
  const Checked<Beacon> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  const Beacon& beacon = checked.value();
  if (beacon.mode == AgentMode::Leaving) {
    if (!admission_.closed()) return admission_.forget(beacon.nonce);
    // the goodbye of a process that was never admitted, under an id that another one holds, loses nobody
    const auto entry = std::ranges::find(tick_.roster, beacon.nonce, &RosterEntry::nonce);
    if (entry != tick_.roster.end() && entry->agent == beacon.agent) add_loss(beacon.agent, LossReason::Left);
    return;
  }
  if (beacon.incarnation == 0) return admission_.introduce(beacon, now_s);
  if (!beacon.closes_round) return serve_needs(beacon, now_s);
  if (barrier_.accept(beacon)) {
    ++topics_.beacon.samples;
    topics_.beacon.bytes += wire::Beacon::getCdrSerializedSize(sample);
  }
}

void WorldSession::on_sample(const wire::Representative& sample, double /*now_s*/) {
  WireContext context;
  context.run = options_.run;
  context.roster = tick_.roster;
  const Checked<Representative> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  if (barrier_.accept(checked.value())) {
    ++topics_.representative.samples;
    topics_.representative.bytes += wire::Representative::getCdrSerializedSize(sample);
  }
}

void WorldSession::serve_needs(const Beacon& beacon, double now_s) {
  for (const Need& need : beacon.needs) {
    const auto found = repeatable_.find(need.agent);
    if (found == repeatable_.end() || found->second.round != need.round) continue;
    TopicCount repeated;  // the sender's sample was counted when it arrived
    send(found->second, repeated, now_s);
  }
}

void WorldSession::poll_waiting(double now_s) {
  if (topics_.mission.samples == 0) {
    if (now_s - times_.created_s < options_.settle_s) return;
    publish_mission(now_s);
  }
  world_matched_ = port_.matched();
  if (const auto roster = admission_.roster(world_matched_); roster && !admission_.closed()) {
    admission_.close();
    tick_.roster = *roster;
  }
  if (admission_.closed()) return start(now_s);
  if (now_s - times_.created_s > options_.startup_timeout_s) {
    const std::string missing = fmt::format("{}", fmt::join(admission_.missing(world_matched_), ", "));
    return refuse_start(fmt::format("start-up timed out after {} s: {} of {} agents matched; missing: {} ({})",
                                    options_.startup_timeout_s, matched(), mission_.vehicles.size(), missing,
                                    admission_.obstacles(world_matched_)),
                        now_s);
  }
  if (!admission_.lacks_mission()) all_have_mission_s_ = now_s;
  if (now_s - std::max(all_have_mission_s_, mission_sent_s_) >= kMission_s) publish_mission(now_s);
  if (now_s - last_sent_s_ >= kWaitingTick_s) publish_tick(now_s);
}

/// Opens round 1, unless a fault on purpose holds it.
void WorldSession::start(double now_s) {
  if (held_by_fault({Phase::Planning, 1}, now_s)) return;
  replay_losses(1);
  state_ = State::Running;
  times_.started_s = now_s;
  const Tick first = run_.begin(tick_.roster, std::exchange(lost_, {}));
  if (first.phase == Phase::Finished) close(now_s);
  open(first, now_s);
}

void WorldSession::poll_running(double now_s) {
  drop_silent(now_s);
  if (!awaited_.empty() || barrier_.complete()) {
    if (!held_by_fault(run_.next(barrier_, lost_), now_s)) advance(now_s);
  } else if (now_s - last_sent_s_ >= kResend_s) {
    publish_tick(now_s);
    for (const AgentId agent : barrier_.waiting_for()) {
      const auto entry = std::ranges::find(tick_.roster, agent, &RosterEntry::agent);
      if (entry->sense) publish_sense(*entry, now_s);
    }
  }
}

void WorldSession::poll_closing(double now_s) {
  if (barrier_.complete() || now_s - barrier_.opened_s() > kGoodbye_s) state_ = State::Done;
}

void WorldSession::drop_silent(double now_s) {
  if (!awaited_.empty() || now_s - barrier_.opened_s() - away_s_ < deadline_s_) return;
  for (const AgentId agent : barrier_.waiting_for()) add_loss(agent, LossReason::Deadline);
}

void WorldSession::add_loss(AgentId agent, LossReason reason) {
  const bool live = std::ranges::find(tick_.roster, agent, &RosterEntry::agent) != tick_.roster.end();
  if (!live || std::ranges::find(lost_, agent, &Loss::agent) != lost_.end()) return;
  lost_.push_back({agent, reason});
  barrier_.excuse(agent);
}

void WorldSession::process_ended(AgentId agent, double now_s) {
  std::erase_if(awaited_, [&](const Fault& fault) { return fault.agent == agent; });
  if (!admission_.closed()) {
    lost_before_start_ = true;
    refuse_start(fmt::format("agent {} ended before the run started", agent), now_s);
  } else {
    add_loss(agent, LossReason::ProcessEnded);
  }
}

bool WorldSession::held_by_fault(const Moment& moment, double now_s) {
  for (auto fault = options_.faults.begin(); fault != options_.faults.end();) {
    const bool due = Moment{fault->phase, fault->at} == moment;
    const bool live = std::ranges::find(tick_.roster, fault->agent, &RosterEntry::agent) != tick_.roster.end();
    if (due && live && std::ranges::find(lost_, fault->agent, &Loss::agent) == lost_.end()) {
      awaited_.push_back(*fault);
      awaited_since_s_ = now_s;
      control_->kill(fault->agent);
    }
    fault = due && live ? options_.faults.erase(fault) : std::next(fault);
  }
  if (!awaited_.empty() && now_s - awaited_since_s_ > deadline_s_) {
    interrupt(fmt::format("the fault on agent {} took no effect within {} s", awaited_.front().agent, deadline_s_),
              now_s);
    return true;
  }
  return !awaited_.empty();
}

void WorldSession::replay_losses(std::uint32_t round) {
  std::erase_if(options_.replay, [&](const RosterChange& change) {
    if (change.round != round) return false;
    const auto entry = std::ranges::find(tick_.roster, change.agent, &RosterEntry::agent);
    if (entry == tick_.roster.end() || entry->incarnation != change.incarnation) return false;
    add_loss(change.agent, change.reason);
    return true;
  });
}

void WorldSession::advance(double now_s) {
  replay_losses(run_.rounds() + 1);
  repeatable_.clear();
  for (const RosterEntry& entry : tick_.roster) {
    const Answer* answer = barrier_.answer_of(entry.agent);
    if (answer->representative) repeatable_[entry.agent] = *answer->representative;
  }
  const Tick next = run_.decide(barrier_, lost_);
  for (const Loss& loss : std::exchange(lost_, {})) {
    admission_.forget(std::ranges::find(tick_.roster, loss.agent, &RosterEntry::agent)->nonce);
  }
  if (next.phase == Phase::Flying && times_.flying_s < 0.0) times_.flying_s = now_s;
  if (next.phase == Phase::Finished) close(now_s);
  open(next, now_s);
}

void WorldSession::close(double now_s) {
  times_.finished_s = now_s;
  state_ = State::Closing;
}

void WorldSession::open(const Tick& tick, double now_s) {
  tick_ = tick;
  away_s_ = 0.0;
  barrier_.open(tick_, now_s);
  for (const RosterEntry& entry : tick_.roster) {
    if (entry.sense) publish_sense(entry, now_s);
  }
  publish_tick(now_s);
}

void WorldSession::publish_mission(double now_s) {
  send(mission_, topics_.mission, now_s);
  mission_sent_s_ = now_s;
}

void WorldSession::publish_tick(double now_s) {
  tick_.refused = admission_.take_refused();
  send(tick_, topics_.tick, now_s);
  last_sent_s_ = now_s;
}

void WorldSession::publish_sense(const RosterEntry& entry, double now_s) {
  const VehicleRecord& vehicle = run_.world().vehicle(entry.agent);
  Sense sense;
  sense.run = options_.run;
  sense.agent = entry.agent;
  sense.incarnation = entry.incarnation;
  sense.round = tick_.round;
  sense.pose = pose_of(vehicle.state);
  sense.velocity_mps = vehicle.state.velocity_mps;
  send(sense, topics_.sense, now_s);
}

void WorldSession::refuse_start(const std::string& reason, double now_s) {
  if (state_ != State::Waiting) return;
  start_failure_ = reason;
  interrupt(reason, now_s);
}

void WorldSession::interrupt(std::string reason, double now_s) {
  if (state_ == State::Closing || state_ == State::Done) return;
  interrupted_ = std::move(reason);
  close(now_s);
  if (topics_.mission.samples == 0) return give_up();  // nobody has heard of this run
  Tick last = tick_;
  last.phase = Phase::Finished;
  ++last.round;
  last.roster = run_.roster();
  for (RosterEntry& entry : last.roster) entry.sense = entry.representative = false;
  open(last, now_s);
}

}  // namespace skein
