#include "simworld/lockstep/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "planner/core/lockstep/names.hpp"
#include "simworld/lockstep/answers.hpp"

namespace skein {
namespace {

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
  if (!mission.transit) return;
  radio_.emplace(mission);
  map_watch_.emplace(mission);
}

Tick Run::begin(std::vector<RosterEntry> roster, std::span<const Loss> lost, std::span<const RosterEntry> back,
                const Steered& steered) {
  roster_ = std::move(roster);
  phase_ = Phase::Planning;
  drop(lost);
  steer(steered);
  round_ = 1;
  admit(back);
  date_changes(0);
  return compose(nullptr);
}

Moment Run::next(const Barrier& answers, std::span<const Loss> lost) const {
  if (step_ > 0) return next_aloft(answers, lost);
  const bool ready = std::ranges::all_of(roster_, [&](const RosterEntry& entry) {
    if (holds(lost, entry.agent)) return true;
    const AgentMode mode = beacon_of(answers, entry.agent).mode;
    return mode == AgentMode::Ready || mode == AgentMode::Rejoined;
  });
  return ready ? Moment{Phase::Flying, 1} : Moment{Phase::Planning, round_ + 1};
}

Tick Run::decide(const Barrier& answers, std::span<const Loss> lost, std::span<const RosterEntry> back,
                 const Steered& steered) {
  if (phase_ != Phase::Planning && phase_ != Phase::Flying) throw std::logic_error("no round is open");
  const std::size_t known = changes_.size();
  const Opened open{phase_, step_, round_};
  drop(lost);
  plan_watch_.add(open, answers, roster_);
  note_acknowledged(answers);
  if (step_ == 0 && phase_ == Phase::Planning) {
    decide_planning(answers);
  } else if (!finished()) {
    note_aloft(answers);
    if (phase_ == Phase::Flying) {
      decide_flight(answers);
    } else {
      decide_aloft();
    }
  }
  steer(steered);
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
    modes_.erase(entry.agent);
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
  tick.orders = orders_;
  return tick;
}

}  // namespace skein
