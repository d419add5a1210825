#include "simworld/lockstep/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

bool holds(std::span<const Loss> lost, AgentId agent) {
  return std::ranges::find(lost, agent, &Loss::agent) != lost.end();
}

const Beacon& beacon_of(const Barrier& answers, AgentId agent) {
  const Answer* answer = answers.answer_of(agent);
  if (answer == nullptr || !answer->beacon) {
    throw std::logic_error(fmt::format("round decided without the beacon of agent {}", agent));
  }
  return *answer->beacon;
}

/// The beacon of this very incarnation, if it answered.
const Beacon* own_beacon(const Barrier& answers, const RosterEntry& entry) {
  const Answer* answer = answers.answer_of(entry.agent);
  const bool own = answer != nullptr && answer->beacon && answer->beacon->incarnation == entry.incarnation;
  return own ? &*answer->beacon : nullptr;
}

NavStatus given_up(AgentMode mode) {
  if (mode == AgentMode::Unreachable) return NavStatus::Unreachable;
  return mode == AgentMode::Deadlock ? NavStatus::Deadlock : NavStatus::Flying;
}

/// A beacon of a failed agent may name another one: the peer of its separation, or the agent whose constraint fails.
std::string planning_failure(const Barrier& answers, const Beacon& first) {
  const Answer* other = answers.answer_of(first.constraint_peer);
  const bool follow = other != nullptr && other->beacon && other->beacon->mode == AgentMode::Failed &&
                      other->beacon->constraint_peer != first.agent;
  const Beacon& beacon = follow ? *other->beacon : first;
  std::string text =
      fmt::format("planning failed: agent {} cannot satisfy {}", beacon.agent, name_of(beacon.constraint));
  if (beacon.constraint == Constraint::Separation) text += fmt::format(" with agent {}", beacon.constraint_peer);
  return text;
}

}  // namespace

Run::Run(std::uint64_t run, const Mission& mission, const WorldOptions& options, bool fail_fast)
    : run_(run),
      mission_(mission),
      options_(options),
      fail_fast_(fail_fast),
      world_(mission, options.on_agent_loss, options.hidden, options.surprises),
      hash_(mission_hash(mission)) {
  for (const VehicleSpec& vehicle : mission.vehicles) plan_.push_back({.agent = vehicle.id});
  if (mission.transit) radio_.emplace(mission);
}

Tick Run::begin(std::vector<RosterEntry> roster, std::span<const Loss> lost, std::span<const RosterEntry> back) {
  roster_ = std::move(roster);
  phase_ = Phase::Planning;
  round_ = 1;
  drop(lost);
  admit(back);
  date_changes(0);
  return compose(nullptr);
}

Moment Run::next(const Barrier& answers, std::span<const Loss> lost) const {
  if (phase_ == Phase::Flying) return {Phase::Flying, step_ + 1};
  const bool ready = std::ranges::all_of(roster_, [&](const RosterEntry& entry) {
    if (holds(lost, entry.agent)) return true;
    const AgentMode mode = beacon_of(answers, entry.agent).mode;
    return mode == AgentMode::Ready || mode == AgentMode::Rejoined;
  });
  return ready ? Moment{Phase::Flying, 1} : Moment{Phase::Planning, round_ + 1};
}

Tick Run::decide(const Barrier& answers, std::span<const Loss> lost, std::span<const RosterEntry> back) {
  if (phase_ != Phase::Planning && phase_ != Phase::Flying) throw std::logic_error("no round is open");
  const std::size_t known = changes_.size();
  drop(lost);
  if (phase_ == Phase::Planning) {
    decide_planning(answers);
  } else if (phase_ == Phase::Flying) {
    decide_flight(answers);
  }
  admit(back);
  fold_hash(answers);
  ++round_;
  date_changes(known);
  return compose(&answers);
}

void Run::date_changes(std::size_t known) {
  for (std::size_t i = known; i < changes_.size(); ++i) {
    changes_[i].step = step_;
    changes_[i].round = round_;
  }
}

void Run::drop(std::span<const Loss> lost) {
  for (const Loss& loss : lost) {
    const auto found = std::ranges::find(roster_, loss.agent, &RosterEntry::agent);
    if (found == roster_.end()) continue;
    changes_.push_back({0, 0, loss.agent, found->incarnation, loss.reason});
    roster_.erase(found);
    world_.lose_agent(loss.agent);
  }
  if (roster_.empty()) {
    finish("no agent is left");
  } else if (fail_fast_ && !changes_.empty()) {
    finish("ended at the first loss");
  }
}

void Run::admit(std::span<const RosterEntry> back) {
  if (finished()) return;
  for (const RosterEntry& entry : back) {
    changes_.push_back({0, 0, entry.agent, entry.incarnation, LossReason::Rejoined});
    roster_.insert(std::ranges::lower_bound(roster_, entry.agent, {}, &RosterEntry::agent), entry);
    world_.return_agent(entry.agent);
  }
}

void Run::note_plan(const Barrier& answers) {
  for (const RosterEntry& entry : roster_) {
    const Beacon& beacon = beacon_of(answers, entry.agent);
    if (beacon.mode == AgentMode::Rejoined) continue;
    const auto figures = std::ranges::find(plan_, entry.agent, &PlanFigures::agent);
    *figures = {entry.agent, beacon.planned_length_m, beacon.cost, beacon.generation, std::move(figures->particle)};
    const auto& published = answers.answer_of(entry.agent)->representative;
    if (published) figures->particle = published->particle;
  }
}

void Run::note_spread(const Barrier& answers) {
  double least_m = std::numeric_limits<double>::infinity();
  double most_m = 0.0;
  for (const RosterEntry& entry : roster_) {
    if (beacon_of(answers, entry.agent).mode == AgentMode::Rejoined) continue;
    const double length_m = std::ranges::find(plan_, entry.agent, &PlanFigures::agent)->length_m;
    least_m = std::min(least_m, length_m);
    most_m = std::max(most_m, length_m);
  }
  plan_spread_m_ = most_m - least_m;
}

void Run::decide_planning(const Barrier& answers) {
  planning_rounds_ = round_;
  note_plan(answers);
  bool ready = true;
  bool planned = false;
  for (const RosterEntry& entry : roster_) {
    const Beacon& beacon = beacon_of(answers, entry.agent);
    if (beacon.mode == AgentMode::Rejoined) continue;
    if (beacon.mode == AgentMode::Failed) return finish(planning_failure(answers, beacon));
    ready = ready && beacon.mode == AgentMode::Ready;
    planned = true;
  }
  if (!planned) {
    finish("no agent is left that took part in planning");
  } else if (ready) {
    note_spread(answers);
    phase_ = Phase::Flying;
    step_ = 1;
  } else if (round_ >= options_.max_rounds) {
    finish(fmt::format("planning did not end within world.max_rounds = {} rounds", options_.max_rounds));
  }
}

void Run::decide_flight(const Barrier& answers) {
  std::vector<VehicleCommand> commands;
  commands.reserve(roster_.size());
  for (const RosterEntry& entry : roster_) {
    const Beacon& beacon = beacon_of(answers, entry.agent);
    commands.push_back({entry.agent, beacon.commanded_velocity_mps, beacon.mode == AgentMode::Arrived});
    if (mission_.transit) world_.note_given_up(entry.agent, given_up(beacon.mode));
  }
  world_.advance(step_, commands);
  if (radio_) log_radio(answers);
  steps_flown_ = step_;
  ended_steps_ = world_.all_ended() ? ended_steps_ + 1 : 0;
  if (ended_steps_ > options_.extra_steps) {
    finish("");
  } else if (step_ >= options_.max_steps) {
    finish(fmt::format("the flight did not end within world.max_steps = {} steps", options_.max_steps));
  } else {
    ++step_;
  }
}

void Run::log_radio(const Barrier& answers) {
  std::vector<OnAir> agents;
  for (const RosterEntry& entry : roster_) {
    const Answer* answer = answers.answer_of(entry.agent);
    if (answer->beacon->mode == AgentMode::Rejoined) continue;
    const bool sent = answer->beacon->obstacle_map && answer->obstacle_map;
    agents.push_back({entry.agent, world_.vehicle(entry.agent).state.position_m,
                      sent ? &*answer->obstacle_map : nullptr, answer->beacon->map_hash});
  }
  radio_->add(step_, round_, agents);
}

void Run::fold_hash(const Barrier& answers) {
  StateHash hash(hash_);
  hash.add(phase_).add(step_);
  world_.add_to(hash);
  for (const RosterEntry& entry : roster_) {
    const Beacon* beacon = own_beacon(answers, entry);
    hash.add(entry.agent).add(entry.incarnation).add(beacon == nullptr ? 0 : beacon->state_hash);
  }
  hash_ = hash.value();
}

void Run::finish(std::string failure) {
  phase_ = Phase::Finished;
  failure_ = std::move(failure);
}

Sense Run::sense_of(const RosterEntry& entry) const {
  const VehicleRecord& vehicle = world_.vehicle(entry.agent);
  Sense sense;
  sense.run = run_;
  sense.agent = entry.agent;
  sense.incarnation = entry.incarnation;
  sense.round = round_;
  sense.pose = pose_of(vehicle.state);
  sense.velocity_mps = vehicle.state.velocity_mps;
  const double range_m = mission_.controller.sensor_range_m;
  if (mission_.transit || range_m > 0.0) sense.heard = heard_by(vehicle);
  if (world_.truth() != nullptr) sense.sight = world_.look_of(entry.agent, step_);
  if (range_m > 0.0) sense.tracks = world_.tracks_of(entry.agent, range_m);
  sense.zones = world_.zone_states(step_);
  sense.obeyed = world_.obeys(entry.agent);
  return sense;
}

/// Whose agent is live says over the radio where it is; who has none is seen by the sensor. A rendezvous has a radio
/// without limits.
std::vector<HeardPeer> Run::heard_by(const VehicleRecord& vehicle) const {
  std::vector<HeardPeer> heard;
  const std::optional<TransitMission>& transit = mission_.transit;
  const double seen_m = std::max(mission_.controller.sensor_range_m, transit ? transit->sensor.range_m : 0.0);
  const double radio_m = transit ? transit->radio.range_m : std::numeric_limits<double>::infinity();
  for (const VehicleRecord& other : world_.vehicles()) {
    if (other.spec.id == vehicle.spec.id || other.status == VehicleStatus::Removed) continue;
    const bool live = std::ranges::find(roster_, other.spec.id, &RosterEntry::agent) != roster_.end();
    const double range_m = live ? std::max(radio_m, seen_m) : seen_m;
    if ((other.state.position_m - vehicle.state.position_m).norm() > range_m) continue;
    heard.push_back({other.spec.id, other.state.position_m, other.state.velocity_mps, other.landed});
  }
  return heard;
}

Tick Run::compose(const Barrier* answers) const {
  Tick tick;
  tick.run = run_;
  tick.step = step_;
  tick.round = round_;
  tick.phase = phase_;
  tick.time_s = mission_.step_s * static_cast<double>(phase_ == Phase::Flying ? step_ - 1 : steps_flown_);
  tick.roster = roster_;
  for (RosterEntry& entry : tick.roster) {
    const Beacon* beacon = answers == nullptr ? nullptr : own_beacon(*answers, entry);
    entry.representative = beacon != nullptr && beacon->representative;
    entry.obstacle_map = beacon != nullptr && beacon->obstacle_map;
    entry.sense = phase_ == Phase::Flying;
  }
  tick.world_hash = hash_;
  return tick;
}

}  // namespace skein
