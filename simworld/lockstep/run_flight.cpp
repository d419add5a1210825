#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "simworld/lockstep/answers.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

NavStatus given_up(AgentMode mode) {
  if (mode == AgentMode::Unreachable) return NavStatus::Unreachable;
  return mode == AgentMode::Deadlock ? NavStatus::Deadlock : NavStatus::Flying;
}

/// Where it passes by its slot, it does not arrive.
bool is_off_mission(AgentMode mode) {
  return mode == AgentMode::Holding || mode == AgentMode::GoingTo || mode == AgentMode::Landing;
}

}  // namespace

bool Run::replans() const {
  return !mission_.transit && mission_.planner.replan == 1;
}

std::uint32_t Run::rounds_per_step() const {
  return static_cast<std::uint32_t>(std::max(1, mission_.planner.rounds_per_step));
}

bool Run::anybody_replans(const Barrier& answers, std::span<const Loss> lost) const {
  return replans() && std::ranges::any_of(roster_, [&](const RosterEntry& entry) {
           return !holds(lost, entry.agent) && beacon_of(answers, entry.agent).mode == AgentMode::Replanning;
         });
}

/// A vehicle whose agent came back, or that missed its slot, has no plan, but its agent takes part in making one.
bool Run::awaits_plan(const Barrier& answers) const {
  return replans() && std::ranges::any_of(roster_, [&](const RosterEntry& entry) {
           const VehicleStatus status = world_.vehicle(entry.agent).status;
           const bool waits = status == VehicleStatus::Rejoined || status == VehicleStatus::Missed;
           return waits && beacon_of(answers, entry.agent).mode == AgentMode::Replanning;
         });
}

Moment Run::next_aloft(const Barrier& answers, std::span<const Loss> lost) const {
  if (phase_ == Phase::Flying) {
    const bool plans = rounds_per_step() > 1 && anybody_replans(answers, lost);
    return plans ? Moment{Phase::Planning, round_ + 1} : Moment{Phase::Flying, step_ + 1};
  }
  return planning_left_ > 1 ? Moment{Phase::Planning, round_ + 1} : Moment{Phase::Flying, step_};
}

/// What the swarm says under way, and the figures of a plan once its agent flies it.
void Run::note_aloft(const Barrier& answers) {
  flight_log_.add(step_, round_, answers, roster_);
  if (!replans()) return;
  for (const RosterEntry& entry : roster_) {
    const Beacon& beacon = beacon_of(answers, entry.agent);
    AgentMode& before = modes_[entry.agent];
    if (before == AgentMode::Replanning && beacon.mode == AgentMode::Flying) {
      const auto figures = std::ranges::find(plan_, entry.agent, &PlanFigures::agent);
      figures->length_m = beacon.planned_length_m;
      figures->cost = beacon.cost;
      figures->generation = beacon.generation;
    }
    before = beacon.mode;
  }
}

/// A planning round of a flight step: time stands still, and nobody's failure ends the run.
void Run::decide_aloft() {
  ++replan_rounds_;
  if (--planning_left_ == 0) phase_ = Phase::Flying;
}

void Run::decide_flight(const Barrier& answers) {
  std::vector<VehicleCommand> commands;
  commands.reserve(roster_.size());
  for (const RosterEntry& entry : roster_) {
    const Beacon& beacon = beacon_of(answers, entry.agent);
    commands.push_back({entry.agent, beacon.commanded_velocity_mps, beacon.mode == AgentMode::Arrived,
                        beacon.mode == AgentMode::Landed, is_off_mission(beacon.mode)});
    if (mission_.transit) world_.note_given_up(entry.agent, given_up(beacon.mode));
    const bool flies_on = replans() || (mission_.transit && mission_.transit->planner.name == kStraight);
    if (flies_on && beacon.mode == AgentMode::Flying) world_.take_up(entry.agent);
  }
  count_commanded(answers);
  world_.advance(step_, commands);
  if (radio_) log_radio(answers);
  steps_flown_ = step_;
  ended_steps_ = world_.all_ended() && !awaits_plan(answers) ? ended_steps_ + 1 : 0;
  if (ended_steps_ > options_.extra_steps) {
    finish("");
  } else if (step_ >= step_limit()) {
    finish(out_of_steps());
  } else {
    ++step_;
    rounds_in_step_ = anybody_replans(answers) ? rounds_per_step() : 1;
    planning_left_ = rounds_in_step_ - 1;
    if (planning_left_ > 0) phase_ = Phase::Planning;
  }
}

void Run::log_radio(const Barrier& answers) {
  std::vector<OnAir> agents;
  std::vector<MapHolder> holders;
  for (const RosterEntry& entry : roster_) {
    const Answer* answer = answers.answer_of(entry.agent);
    const VehicleRecord& vehicle = world_.vehicle(entry.agent);
    const std::uint64_t map_hash = answer->beacon->map_hash;
    if (vehicle.status == VehicleStatus::Removed) continue;
    if (answer->beacon->mode == AgentMode::Rejoined && map_hash == 0) continue;
    const bool sent = answer->beacon->obstacle_map && answer->obstacle_map;
    agents.push_back({entry.agent, vehicle.state.position_m, sent ? &*answer->obstacle_map : nullptr, map_hash});
    holders.push_back({entry.agent, entry.incarnation, vehicle.state.position_m, map_hash});
  }
  radio_->add(step_, round_, agents);
  map_watch_->add(step_, holders);
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
  if (transit && vehicle.status == VehicleStatus::Removed) return heard;  // it is not there, and not on air
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

}  // namespace skein
