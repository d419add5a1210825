#include "simworld/lockstep/world_session.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace skein {
namespace {

constexpr double kResend_s = 1.0;
constexpr double kGoodbye_s = 2.0;  ///< how long the final tick waits for its answers
/// A reader of DDS that joins a stream of thousands of ticks a second may never find its place in it; a break is
/// enough.
constexpr double kPause_s = 0.1;
constexpr double kAway_s = 1.0;       ///< between two polls: the world itself was stopped, not the agents
constexpr double kPatience_s = 10.0;  ///< at least, for a process to end or to stop
/// Who is silent for so long and is to be ended by command is not waited for until the deadline.
constexpr double kDoomed_s = 2.0;

}  // namespace

WorldSession::WorldSession(const Scenario& scenario, SessionOptions options, bus::WorldPort& port,
                           ProcessControl* control, double now_s)
    : mission_(scenario.mission),
      deadline_s_(scenario.lockstep.deadline_s),
      options_(std::move(options)),
      port_(port),
      pacer_(options_.pace, scenario.mission.step_s),
      run_(options_.run, scenario.mission, scenario.world, options_.fail_fast),
      admission_(options_.run, options_.nonce, ids_of(scenario.mission), deadline_s_),
      interventions_(std::move(options_.faults), std::move(options_.replay), control),
      desk_(std::move(options_.orders), std::move(options_.injections)),
      gate_(options_.recorded) {
  times_.created_s = now_s;
  tick_.run = options_.run;
  interventions_.set_recorder(options_.recorder);
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
  if (resumed_s_) rematch(now_s);
  if (resumed_s_) return;
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
  if (state_ == State::Running && now_s < pause_until_s_) return pause_until_s_ - now_s;
  double due_s = last_sent_s_ + (state_ == State::Waiting ? kWaitingTick_s : kResend_s);
  if (state_ == State::Running && interventions_.holding() && !interventions_.awaits_return()) return kWaitingTick_s;
  if (state_ == State::Closing) due_s = times_.finished_s + kGoodbye_s;
  const bool paced = state_ == State::Running && barrier_.complete() && now_s < pacer_.due_s();
  if (paced) due_s = std::min(due_s, pacer_.due_s());
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
    if (entry == tick_.roster.end()) return admission_.forget(beacon.nonce);
    if (entry->agent == beacon.agent) add_loss(beacon.agent, LossReason::Left);
    return;
  }
  if (beacon.incarnation == 0) {
    const bool waits = admission_.introduce(beacon, now_s, tick_.round);
    if (waits && state_ == State::Running && beacon.round == 0) pause_until_s_ = now_s + kPause_s;
    return;
  }
  if (!beacon.closes_round) return repeat(repeats_.asked_by(beacon), now_s);
  if (barrier_.accept(beacon)) {
    admission_.answered(beacon.agent, beacon.round);
    ++topics_.beacon.samples;
    topics_.beacon.bytes += wire::Beacon::getCdrSerializedSize(sample);
  }
}

void WorldSession::on_sample(const wire::Representative& sample, double /*now_s*/) {
  collect<Representative>(sample, topics_.representative);
}

void WorldSession::on_sample(const wire::ObstacleMap& sample, double /*now_s*/) {
  collect<ObstacleMapSample>(sample, topics_.obstacle_map);
}

template <typename Sample, typename Wire>
void WorldSession::collect(const Wire& sample, TopicCount& count) {
  WireContext context;
  context.run = options_.run;
  context.roster = tick_.roster;
  if (mission_.transit) context.grid = grid_of(*mission_.transit);
  const Checked<Sample> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  if (barrier_.accept(checked.value())) {
    ++count.samples;
    count.bytes += Wire::getCdrSerializedSize(sample);
  }
}

/// The senders' own samples were counted when they arrived.
void WorldSession::repeat(const Repeated& samples, double now_s) {
  TopicCount repeated;
  for (const Representative& sample : samples.representatives) send(sample, repeated, now_s);
  for (const ObstacleMapSample& sample : samples.maps) send(sample, repeated, now_s);
}

void WorldSession::poll_running(double now_s) {
  if (now_s < pause_until_s_) return;
  drop_silent(now_s);
  const bool paused = barrier_.complete() && (!pacer_.may_open(now_s) || !is_recorded(now_s));
  if (!paused && (interventions_.holding() || barrier_.complete())) {
    if (!is_held(now_s)) return advance(now_s);
    if (!interventions_.awaits_return()) return;  // who is to come back must hear that it was dropped
  }
  if (state_ != State::Running || now_s - last_sent_s_ < kResend_s) return;
  repeat_tick(now_s);
}

void WorldSession::poll_closing(double now_s) {
  desk_.refuse([](const Order*) { return Objection{OrderResult::Ended, "the run is over"}; }, now_s);
  if ((barrier_.complete() && is_recorded(now_s)) || now_s - times_.finished_s > kGoodbye_s) {
    run_.note_acknowledged(barrier_);
    state_ = State::Done;
  } else if (now_s - last_sent_s_ >= kWaitingTick_s) {
    repeat_tick(now_s);
  }
}

void WorldSession::drop_silent(double now_s) {
  if (interventions_.holding()) return;
  const double waited_s = now_s - barrier_.opened_s() - away_s_;
  for (const AgentId agent : barrier_.waiting_for()) {
    const bool doomed = waited_s >= kDoomed_s && desk_.ends(agent, now_s);
    if (waited_s >= deadline_s_ || doomed) add_loss(agent, LossReason::Deadline);
  }
}

std::vector<AgentId> WorldSession::silent_for(double seconds, double now_s) const {
  if (state_ != State::Running || interventions_.holding() || now_s - barrier_.opened_s() - away_s_ <= seconds)
    return {};
  return barrier_.waiting_for();
}

bool WorldSession::is_live(AgentId agent) const {
  return std::ranges::find(tick_.roster, agent, &RosterEntry::agent) != tick_.roster.end() &&
         std::ranges::find(lost_, agent, &Loss::agent) == lost_.end();
}

void WorldSession::add_loss(AgentId agent, LossReason reason) {
  if (!is_live(agent)) return;
  lost_.push_back({agent, reason});
  barrier_.excuse(agent);
  admission_.lose(agent, run_.rounds() + 1, reason == LossReason::Deadline);
}

void WorldSession::process_ended(AgentId agent, double now_s) {
  interventions_.process_ended(agent);
  if (!admission_.closed()) {
    refuse_start(fmt::format("agent {} ended before the run started", agent), now_s, ExitCode::AgentLost);
  } else {
    admission_.forget_newcomer(agent);
    add_loss(agent, LossReason::ProcessEnded);
  }
}

/// Does what is due at the coming tick. @return whether that tick has to wait; if not, `back_` comes back with it
bool WorldSession::is_held(double now_s) {
  for (const Loss& loss : interventions_.repeat(run_.rounds() + 1, tick_.roster, now_s)) {
    add_loss(loss.agent, loss.reason);
    interventions_.end(loss.agent);
  }
  for (bool busy = true; busy;) {
    const Moment moment = run_.rounds() == 0 ? Moment{Phase::Planning, 1} : run_.next(barrier_, lost_);
    take_faults(moment, now_s);
    busy = interventions_.holding();
    busy = interventions_.carry_out(
               moment, [this](AgentId agent) { return is_live(agent); }, now_s) ||
           busy;
    find_returning(now_s);
    if (interventions_.holds(back_)) break;
    if (!busy) return false;
  }
  const auto failure = interventions_.failure(now_s, std::max(deadline_s_, kPatience_s),
                                              std::max(deadline_s_, options_.startup_timeout_s));
  if (failure) interrupt(*failure, static_cast<int>(ExitCode::Failed), now_s);
  return true;
}

void WorldSession::find_returning(double now_s) {
  back_.clear();
  if (!admission_.has_newcomers()) return;
  world_matched_ = port_.matched();
  std::vector<std::uint64_t> live;
  for (const RosterEntry& entry : tick_.roster) {
    if (is_live(entry.agent) && !interventions_.is_stopped(entry.agent)) live.push_back(entry.nonce);
  }
  back_ = admission_.returning(world_matched_, live, now_s);
  std::erase_if(back_, [this](const RosterEntry& entry) { return !interventions_.may_return(entry.agent); });
}

/// Opens `next`. Who comes back with it has not heard the samples that it counts: they go out once more.
void WorldSession::go_on(const Tick& next, double now_s) {
  if (next.phase == Phase::Flying && times_.flying_s < 0.0) times_.flying_s = now_s;
  if (next.phase == Phase::Finished) close(now_s);
  bool anybody_back = false;
  for (const RosterEntry& entry : std::exchange(back_, {})) {
    if (std::ranges::find(next.roster, entry.nonce, &RosterEntry::nonce) == next.roster.end()) continue;
    admission_.admit(entry);
    anybody_back = true;
  }
  open(next, now_s);
  if (anybody_back) repeat(repeats_.counted_by(next), now_s);
}

void WorldSession::close(double now_s) {
  times_.finished_s = now_s;
  state_ = State::Closing;
}

void WorldSession::open(const Tick& tick, double now_s) {
  expect(tick, now_s);
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
  tick_.assigned = admission_.take_assigned();
  tick_.answers = desk_.answers(run_.orders(), now_s);
  send(tick_, topics_.tick, now_s);
  last_sent_s_ = now_s;
}

void WorldSession::publish_sense(const RosterEntry& entry, double now_s) {
  send(run_.sense_of(entry), topics_.sense, now_s);
}

void WorldSession::interrupt(std::string reason, int exit_code, double now_s) {
  if (state_ == State::Closing || state_ == State::Done) return;
  interrupted_ = Outcome{static_cast<std::uint8_t>(exit_code), std::move(reason)};
  close(now_s);
  if (topics_.mission.samples == 0) return give_up();  // nobody has heard of this run
  Tick last = tick_;
  last.phase = Phase::Finished;
  ++last.round;
  last.roster = run_.roster();
  for (RosterEntry& entry : last.roster) entry.sense = entry.representative = entry.obstacle_map = false;
  open(last, now_s);
}

}  // namespace skein
