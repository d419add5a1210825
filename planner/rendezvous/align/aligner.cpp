#include "planner/rendezvous/align/aligner.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "planner/rendezvous/align/alone.hpp"
#include "planner/rendezvous/align/level_set.hpp"
#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

/// A UAV whose own best is shorter than this part of the longest one leaves it unproved: it will not be flown.
constexpr double kMaySetTheLength = 0.999;
/// Rounds for which a UAV asks for the way before it raises the target: one to be read, one to be answered.
constexpr std::int32_t kPatience = 2;
/// Raised lengths, as parts of the target: the first step, its growth from step to step, and the last step.
constexpr double kFirstRaise = 2e-4;
constexpr double kRaiseGrowth = 1.6;
constexpr double kLastRaise = 2.0;

}  // namespace

template <typename Space>
AlignerIn<Space>::AlignerIn(const ph::Controls& own_best, const ph::Controls& group_best)
    : own_best_(own_best), group_best_(group_best), controls_(own_best) {}

template <typename Space>
AlignOutcome AlignerIn<Space>::advance(const Problem& problem, std::span<const Representative> peers) {
  if (outcome_ != Outcome::Aligning) return outcome_;
  ++round_;
  if (round_ == 1) {
    open(problem, peers);
    return outcome_;
  }
  const auto agrees = [&](const Representative& peer) {
    return peer.stage == PlanStage::Settled && same_length(peer.path_length_m, length_m_);
  };
  if (settled_ && std::ranges::all_of(peers, agrees)) return outcome_ = Outcome::Agreed;
  settled_ = false;
  if (round_ > problem.options.equalise_rounds) {
    blame(peers);
    return outcome_ = Outcome::Failed;
  }
  if (feasible_alone_) align(problem, peers);
  return outcome_;
}

template <typename Space>
void AlignerIn<Space>::open(const Problem& problem, std::span<const Representative> peers) {
  length_m_ = problem.own().hermite.length_m(own_best_);
  double longest_m = 0.0;
  for (const Representative& peer : peers) longest_m = std::max(longest_m, peer.own_length_m);
  const bool refuted = refute<Space>(problem, problem.own().hermite.path(own_best_)) != Constraint::None;
  if (refuted || length_m_ >= kMaySetTheLength * longest_m) prove(problem);
  dense_ = sample_densely(problem, problem.own().hermite.path(controls_));
}

/// Replaces the own best by the best path that is proved, or notes that this UAV has none.
template <typename Space>
void AlignerIn<Space>::prove(const Problem& problem) {
  const AlonePath alone = best_alone(problem, own_best_);
  feasible_alone_ = alone.violated == Constraint::None;
  if (!feasible_alone_) violated_ = alone.violated;
  own_best_ = alone.controls;
  if (round_ > 1) return;
  controls_ = alone.controls;
  length_m_ = alone.length_m;
}

template <typename Space>
void AlignerIn<Space>::blame(std::span<const Representative> peers) {
  if (violated_ != Constraint::None) return;
  violated_ = Constraint::Length;
  for (const Representative& peer : peers) {
    if (peer.violated == Constraint::None) continue;
    violated_ = peer.violated;
    violated_peer_ = peer.agent;
    return;
  }
  for (const Representative& peer : peers) {
    if (peer.path_length_m < length_m_ && !same_length(peer.path_length_m, length_m_)) violated_peer_ = peer.agent;
  }
}

template <typename Space>
void AlignerIn<Space>::align(const Problem& problem, std::span<const Representative> peers) {
  double target_m = length_m_;
  for (const Representative& peer : peers) target_m = std::max(target_m, peer.path_length_m);
  if (!same_length(length_m_, target_m)) asked_ = 0;
  look_at(problem, peers, target_m);
  if (!same_length(length_m_, target_m) || conflict(dense_, neighbours_, true) != 0) {
    find_way(problem, target_m);
    return;
  }
  violated_ = Constraint::None;
  violated_peer_ = 0;
  asked_ = 0;
  const auto ready = [&](const Representative& peer) {
    return peer.violated == Constraint::None && same_length(peer.path_length_m, target_m);
  };
  settled_ = std::ranges::all_of(peers, ready) && conflict(dense_, neighbours_, false) == 0;
}

template <typename Space>
void AlignerIn<Space>::look_at(const Problem& problem, std::span<const Representative> peers, double target_m) {
  std::vector<Neighbour> seen;
  for (const Representative& peer : peers) {
    const ParticipantIn<Space>& uav = participant_of(problem, peer.agent);
    const bool asks = peer.violated == Constraint::Separation;
    Neighbour now;
    now.id = peer.agent;
    now.controls = *controls_of<Space>(peer.particle);
    now.separation_m = required_separation_m(problem.own(), uav);
    now.at_target = same_length(peer.path_length_m, target_m) && (asks || peer.violated == Constraint::None);
    now.binding = now.at_target && (peer.agent < problem.own().id || (asks && asked_ == 0));
    const auto known = std::ranges::find(neighbours_, peer.agent, &Neighbour::id);
    const bool unchanged = known != neighbours_.end() && known->controls == now.controls;
    now.dense = unchanged ? std::move(known->dense) : sample_densely(problem, uav.hermite.path(now.controls));
    seen.push_back(std::move(now));
  }
  neighbours_ = std::move(seen);
}

/// To the target; else asks for the way or raises the target; else stays, with the constraint that fails.
template <typename Space>
void AlignerIn<Space>::find_way(const Problem& problem, double target_m) {
  if (asked_ > 0 && asked_ < kPatience) {
    ++asked_;  // the others are giving way: no moving now
    return;
  }
  const std::uint64_t task = task_of(target_m);
  if (task == failed_task_) return;  // nothing has changed since nothing was found
  const std::array<ph::Controls, 3> starts{group_best_, own_best_, controls_};
  const Choice choice = choose(problem, starts, target_m, neighbours_);
  if (choice.clear) return take(*choice.clear, Constraint::None, 0);
  if (choice.allowed) return take(*choice.allowed, Constraint::None, 0);
  if (may_stay(problem, target_m)) {
    failed_task_ = task;
    return;
  }
  if (choice.alone && asked_ == 0) {
    take(*choice.alone, Constraint::Separation, choice.peer);
    asked_ = 1;
    return;
  }
  if (raise(problem, target_m)) return;
  failed_task_ = task;
  violated_ = choice.fails;
  violated_peer_ = choice.peer;
  if (violated_ != Constraint::Separation) prove(problem);
}

/// At the target, and only in conflict with UAVs of higher id: those that asked in vain must find another way.
template <typename Space>
bool AlignerIn<Space>::may_stay(const Problem& problem, double target_m) const {
  const auto blocks = [&](const Neighbour& peer) {
    return peer.id < problem.own().id && peer.at_target && !keeps_apart(dense_, peer.dense, peer.separation_m);
  };
  return violated_ == Constraint::None && same_length(length_m_, target_m) && std::ranges::none_of(neighbours_, blocks);
}

/// The smallest longer length with a path; each further raise begins with a larger step, so that they come to an end.
template <typename Space>
bool AlignerIn<Space>::raise(const Problem& problem, double target_m) {
  const std::array<ph::Controls, 3> starts{group_best_, own_best_, controls_};
  double step = kFirstRaise;
  for (std::int32_t k = 0; k < raised_; ++k) step *= kRaiseGrowth;
  for (; step <= kLastRaise; step *= kRaiseGrowth) {
    const Choice choice = choose(problem, starts, target_m * (1.0 + step), neighbours_);
    const std::optional<Chosen>& found = choice.clear ? choice.clear : choice.allowed;
    if (!found) continue;
    take(*found, Constraint::None, 0);
    ++raised_;
    return true;
  }
  return false;
}

template <typename Space>
void AlignerIn<Space>::take(const Chosen& chosen, Constraint violated, AgentId peer) {
  controls_ = chosen.controls;
  dense_ = chosen.dense;
  length_m_ = chosen.dense.path.length_m();
  violated_ = violated;
  violated_peer_ = peer;
  asked_ = 0;
}

/// Names what a choice depends on: the target, and the UAVs at it with their right of way.
template <typename Space>
std::uint64_t AlignerIn<Space>::task_of(double target_m) const {
  StateHash hash;
  hash.add(target_m).add(asked_ >= kPatience);
  for (const Neighbour& peer : neighbours_) {
    if (!peer.at_target) continue;
    hash.add(peer.id).add(peer.binding);
    rendezvous::add_to(hash, peer.controls);
  }
  return hash.value();
}

template <typename Space>
void AlignerIn<Space>::add_to(StateHash& hash) const {
  hash.add(round_).add(outcome_).add(settled_).add(feasible_alone_).add(violated_).add(violated_peer_);
  for (const ph::Controls& m : {own_best_, group_best_, controls_}) rendezvous::add_to(hash, m);
  hash.add(length_m_).add(asked_).add(raised_).add(failed_task_);
}

template class AlignerIn<Planar>;
template class AlignerIn<Spatial>;

}  // namespace skein::rendezvous
