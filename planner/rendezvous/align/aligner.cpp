#include "planner/rendezvous/align/aligner.hpp"

#include <algorithm>

#include "planner/rendezvous/align/level_set.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::int32_t kGridNodes = 64;
/// Raised lengths tried, as parts of the target: first step, growth, number. Together they reach 3 times the target.
constexpr double kFirstRaise = 2e-4;
constexpr double kRaiseGrowth = 1.6;
constexpr int kRaises = 20;
/// A UAV whose own best is shorter than this part of the longest one leaves it unproved: it will not be flown.
constexpr double kMaySetTheLength = 0.999;

}  // namespace

Aligner::Aligner(const ph::Controls& own_best, const ph::Controls& group_best)
    : own_best_(own_best), group_best_(group_best), controls_(own_best) {}

Aligner::Outcome Aligner::advance(const Problem& problem, std::span<const Representative> peers) {
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
  if (!feasible_alone_) return outcome_;
  double target_m = length_m_;
  for (const Representative& peer : peers) target_m = std::max(target_m, peer.path_length_m);
  look_at(problem, peers, target_m);
  if (!same_length(length_m_, target_m) || conflict(*dense_, problem.own().id) != 0) {
    move_to(problem, target_m);
    return outcome_;
  }
  violated_ = Constraint::None;
  violated_peer_ = 0;
  const auto ready = [&](const Representative& peer) {
    return peer.violated == Constraint::None && same_length(peer.path_length_m, target_m);
  };
  settled_ = std::ranges::all_of(peers, ready) && conflict(*dense_, kMaxAgents + 1) == 0;
  return outcome_;
}

void Aligner::open(const Problem& problem, std::span<const Representative> peers) {
  length_m_ = problem.own().hermite.length_m(own_best_);
  double longest_m = 0.0;
  for (const Representative& peer : peers) longest_m = std::max(longest_m, peer.own_length_m);
  if (length_m_ >= kMaySetTheLength * longest_m) return prove(problem);
  dense_ = sample_densely(problem, problem.own().hermite.path(controls_));
}

/// Replaces the own best by the best path that is proved, or notes that this UAV has none.
void Aligner::prove(const Problem& problem) {
  const AlonePath alone = best_alone(problem, own_best_);
  own_best_ = alone.controls;
  controls_ = alone.controls;
  length_m_ = alone.length_m;
  feasible_alone_ = alone.violated == Constraint::None;
  if (!feasible_alone_) violated_ = alone.violated;
  dense_ = sample_densely(problem, problem.own().hermite.path(controls_));
}

void Aligner::blame(std::span<const Representative> peers) {
  if (violated_ != Constraint::None) return;
  violated_ = Constraint::Length;
  for (const Representative& peer : peers) {
    if (peer.violated == Constraint::None) continue;
    violated_ = peer.violated;
    violated_peer_ = peer.agent;
    return;
  }
}

void Aligner::look_at(const Problem& problem, std::span<const Representative> peers, double target_m) {
  std::vector<Peer> seen;
  for (const Representative& peer : peers) {
    const ph::Controls controls{peer.particle[0], peer.particle[1]};
    const bool at_target = same_length(peer.path_length_m, target_m) && peer.violated == Constraint::None;
    const auto known = std::ranges::find(peers_, peer.agent, &Peer::id);
    if (known != peers_.end() && known->controls == controls) {
      seen.push_back(std::move(*known));
      seen.back().at_target = at_target;
      continue;
    }
    const Participant& uav = participant_of(problem, peer.agent);
    seen.push_back({peer.agent, controls, required_separation_m(problem.own(), uav), at_target,
                    sample_densely(problem, uav.hermite.path(controls))});
  }
  peers_ = std::move(seen);
}

/// The first peer of an id under `below`, at the target, that the path does not keep apart from; 0 if none.
AgentId Aligner::conflict(const DensePath& dense, AgentId below) const {
  for (const Peer& peer : peers_) {
    if (peer.id < below && peer.at_target && !keeps_apart(dense, peer.dense, peer.separation_m)) return peer.id;
  }
  return 0;
}

/// Takes the cheapest candidate that passes; otherwise keeps in mind by what the cheapest fails.
bool Aligner::choose_among(const Problem& problem, const std::vector<ph::Controls>& candidates) {
  struct Rated {
    double cost;
    ph::Controls controls;
  };
  std::vector<Rated> rated;
  Evaluation evaluation;
  for (const ph::Controls& controls : candidates) {
    evaluate(problem, controls, evaluation);
    rated.push_back({evaluation.own, controls});
  }
  std::ranges::stable_sort(rated, {}, &Rated::cost);
  for (const Rated& candidate : rated) {
    DensePath dense = sample_densely(problem, problem.own().hermite.path(candidate.controls));
    Constraint fails = check_alone(problem, dense);
    AgentId peer = 0;
    if (fails == Constraint::None) {
      peer = conflict(dense, problem.own().id);
      if (peer != 0) fails = Constraint::Separation;
    }
    if (fails == Constraint::None) {
      controls_ = candidate.controls;
      length_m_ = dense.path.length_m();
      dense_ = std::move(dense);
      violated_ = Constraint::None;
      violated_peer_ = 0;
      return true;
    }
    if (violated_ == Constraint::None) {
      violated_ = fails;
      violated_peer_ = peer;
    }
  }
  return false;
}

/// Paths of a length near the particles found by the search, and if none passes, anywhere in the search range.
bool Aligner::choose(const Problem& problem, double target_m) {
  std::vector<ph::Controls> near;
  for (const ph::Controls& from : {group_best_, own_best_, controls_}) {
    const auto found = on_rays(problem.own(), from, target_m, problem.options.equalise_directions);
    near.insert(near.end(), found.begin(), found.end());
  }
  return choose_among(problem, near) || choose_among(problem, on_grid(problem.own(), target_m, kGridNodes));
}

/// To the target, else to the smallest longer length that can be flown; else stays, with the constraint that fails.
void Aligner::move_to(const Problem& problem, double target_m) {
  const std::uint64_t task = task_of(problem, target_m);
  if (task == failed_task_) return;  // nothing has changed since it failed
  violated_ = Constraint::None;
  violated_peer_ = 0;
  if (choose(problem, target_m)) return;
  double raise = kFirstRaise;
  for (int k = 0; k < kRaises; ++k, raise *= kRaiseGrowth) {
    if (choose(problem, target_m * (1.0 + raise))) return;
  }
  failed_task_ = task;
  if (violated_ == Constraint::None) violated_ = Constraint::Length;
  if (violated_ != Constraint::Separation) prove(problem);
}

/// Names what a choice depends on: the target, and the UAVs that have the right of way.
std::uint64_t Aligner::task_of(const Problem& problem, double target_m) const {
  StateHash hash;
  hash.add(target_m);
  for (const Peer& peer : peers_) {
    if (peer.id < problem.own().id && peer.at_target) hash.add(peer.id).add(peer.controls.m0_m).add(peer.controls.m1_m);
  }
  return hash.value();
}

void Aligner::add_to(StateHash& hash) const {
  hash.add(round_).add(outcome_).add(settled_).add(feasible_alone_).add(violated_).add(violated_peer_);
  for (const ph::Controls& m : {own_best_, group_best_, controls_}) hash.add(m.m0_m).add(m.m1_m);
  hash.add(length_m_).add(failed_task_);
}

}  // namespace skein::rendezvous
