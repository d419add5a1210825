#include "planner/rendezvous/planner.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace skein::rendezvous {
namespace {

/// What is wrong with a representative, or nothing.
const char* fault_of(const Representative& representative, const Participant& uav) {
  if (representative.particle.size() != 2) return "its particle has not two numbers";
  for (const double m : representative.particle) {
    if (!uav.range_m.contains(m)) return "its particle is out of the search range";
  }
  for (const double length : {representative.path_length_m, representative.own_length_m}) {
    if (!(length > 0.0) || !std::isfinite(length)) return "its length is not positive and finite";
  }
  return nullptr;
}

}  // namespace

Planner::Planner(const Mission& mission, AgentId self, const kernel::Kernel& kernel)
    : problem_(make_problem(mission, self, kernel)), swarm_(problem_) {}

PlanRound Planner::advance(std::span<const Representative> peers) {
  if (round_.status != PlanStatus::Planning) return round_;
  if (!started_) {
    started_ = true;
    report_search();
    return round_;
  }
  check(peers);
  if (swarm_.generation() < problem_.options.generations) {
    search(peers);
  } else {
    align(peers);
  }
  return round_;
}

const ph::PlanarPath& Planner::path() const {
  if (round_.status != PlanStatus::Ready) throw std::logic_error("the planner has no final path: it is not Ready");
  return path_;
}

bool Planner::can_use(const Representative& peer) const {
  const auto uav = std::ranges::find(problem_.participants, peer.agent, &Participant::id);
  return peer.agent != problem_.own().id && uav != problem_.participants.end() && fault_of(peer, *uav) == nullptr;
}

void Planner::check(std::span<const Representative> peers) const {
  AgentId before = 0;
  for (const Representative& peer : peers) {
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument("representative of agent " + std::to_string(peer.agent) + ": " + why);
    };
    if (peer.agent == problem_.own().id) refuse("that is this planner itself");
    if (peer.agent <= before) refuse("ids must ascend");
    before = peer.agent;
    if (const char* fault = fault_of(peer, participant_of(problem_, peer.agent))) {
      refuse(fault);
    }
  }
}

std::optional<double> Planner::reference_length_m(std::span<const Representative> peers) const {
  double longest_m = round_.representative.own_length_m;
  AgentId holder = problem_.own().id;
  for (const Representative& peer : peers) {
    if (peer.own_length_m > longest_m || (peer.own_length_m == longest_m && peer.agent < holder)) {
      longest_m = peer.own_length_m;
      holder = peer.agent;
    }
  }
  if (holder == problem_.own().id) return std::nullopt;
  return longest_m;
}

void Planner::search(std::span<const Representative> peers) {
  peers_.follow(problem_, peers);
  swarm_.advance(problem_, peers_.peers(), reference_length_m(peers));
  report_search();
}

void Planner::align(std::span<const Representative> peers) {
  if (!aligner_) aligner_.emplace(swarm_.own_best().controls, swarm_.best().controls);
  const Aligner::Outcome outcome = aligner_->advance(problem_, peers);
  report_alignment();
  if (outcome == Aligner::Outcome::Agreed) {
    round_.status = PlanStatus::Ready;
    path_ = problem_.own().hermite.path(aligner_->controls());
  } else if (outcome == Aligner::Outcome::Failed) {
    round_.status = PlanStatus::Failed;
    round_.failed_constraint = aligner_->violated();
    round_.failed_peer = aligner_->violated_peer();
  }
}

void Planner::report_search() {
  Representative& out = round_.representative;
  const Evaluation& best = swarm_.best();
  out.agent = problem_.own().id;
  out.stage = PlanStage::Searching;
  out.violated = first_violation(best.terms);
  out.particle = {best.controls.m0_m, best.controls.m1_m};
  out.cost = best.modified;
  out.own_length_m = swarm_.own_best().length_m;
  out.path_length_m = best.length_m;
  round_.generation = static_cast<std::uint32_t>(swarm_.generation());
}

void Planner::report_alignment() {
  Representative& out = round_.representative;
  Evaluation evaluation;
  evaluate(problem_, aligner_->controls(), evaluation);
  out.stage = aligner_->settled() ? PlanStage::Settled : PlanStage::Aligning;
  out.violated = aligner_->violated();
  out.particle = {evaluation.controls.m0_m, evaluation.controls.m1_m};
  out.cost = evaluation.own;
  out.path_length_m = aligner_->length_m();
}

void Planner::add_to(StateHash& hash) const {
  swarm_.add_to(hash);
  hash.add(started_).add(aligner_.has_value()).add(round_.status).add(round_.representative.own_length_m);
  if (aligner_) aligner_->add_to(hash);
}

}  // namespace skein::rendezvous
