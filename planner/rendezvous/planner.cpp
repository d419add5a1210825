#include "planner/rendezvous/planner.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "planner/rendezvous/cost/coordinates.hpp"
#include "planner/rendezvous/point_separation.hpp"

namespace skein::rendezvous {
namespace {

/// What is wrong with a representative, or nothing.
template <typename Space>
const char* fault_of(const Representative& representative, const ParticipantIn<Space>& uav, std::size_t max_segments) {
  const std::optional<ph::Controls> controls = controls_of<Space>(representative.particle);
  if (!controls || segments_of<Space>(*controls) > max_segments) {
    return "its particle has not the two numbers of a segment, or those of joined segments";
  }
  for (std::size_t i = 0; i < controls->size(); ++i) {
    if (!range_of(uav, i).contains((*controls)[i])) return "its particle is out of the search range";
  }
  for (const double length : {representative.path_length_m, representative.own_length_m}) {
    if (!(length > 0.0) || !std::isfinite(length)) return "its length is not positive and finite";
  }
  return nullptr;
}

}  // namespace

template <typename Space>
PlannerIn<Space>::PlannerIn(const Mission& mission, AgentId self, const kernel::Kernel& kernel)
    : problem_(make_problem<Space>(mission, self, kernel)), run_seed_(problem_.seed), swarm_(problem_) {}

template <typename Space>
PlanRound PlannerIn<Space>::advance(std::span<const Representative> peers) {
  if (round_.status != PlanStatus::Planning) return round_;
  if (!started_) {
    started_ = true;
    report_search();
    return round_;
  }
  check(peers);
  if (swarm_.generation() < problem_.options.generations) {
    search(peers);
  } else if (problem_.options.equalise != 0) {
    align(peers);
  } else {
    conclude(peers);
  }
  return round_;
}

template <typename Space>
const typename Space::Path& PlannerIn<Space>::path() const {
  if (round_.status != PlanStatus::Ready) throw std::logic_error("the planner has no final path: it is not Ready");
  return path_;
}

template <typename Space>
bool PlannerIn<Space>::can_use(const Representative& peer) const {
  const auto uav = std::ranges::find(problem_.participants, peer.agent, &Participant::id);
  return peer.agent != problem_.own().id && uav != problem_.participants.end() &&
         fault_of(peer, *uav, max_segments()) == nullptr;
}

template <typename Space>
void PlannerIn<Space>::check(std::span<const Representative> peers) const {
  AgentId before = 0;
  for (const Representative& peer : peers) {
    const auto refuse = [&](const std::string& why) {
      throw std::invalid_argument("representative of agent " + std::to_string(peer.agent) + ": " + why);
    };
    if (peer.agent == problem_.own().id) refuse("that is this planner itself");
    if (peer.agent <= before) refuse("ids must ascend");
    before = peer.agent;
    if (const char* fault = fault_of(peer, participant_of(problem_, peer.agent), max_segments())) refuse(fault);
  }
}

template <typename Space>
std::optional<double> PlannerIn<Space>::reference_length_m(std::span<const Representative> peers) const {
  const auto length =
      problem_.options.own_reference != 0 ? &Representative::own_length_m : &Representative::path_length_m;
  double longest_m = round_.representative.*length;
  AgentId holder = problem_.own().id;
  for (const Representative& peer : peers) {
    if (peer.*length > longest_m || (peer.*length == longest_m && peer.agent < holder)) {
      longest_m = peer.*length;
      holder = peer.agent;
    }
  }
  if (holder == problem_.own().id) return std::nullopt;
  return longest_m;
}

template <typename Space>
void PlannerIn<Space>::search(std::span<const Representative> peers) {
  if (problem_.options.cooperate == 0) peers = {};
  peers_.follow(problem_, peers);
  swarm_.advance(problem_, peers_, reference_length_m(peers));
  report_search();
}

template <typename Space>
void PlannerIn<Space>::align(std::span<const Representative> peers) {
  if (may_add_segments()) {
    const bool opened = aligner_ && aligner_->round() == 1;
    const bool stands = standstill_.lasts(round_.representative, peers);
    if (stands || (opened && anyone_in_trouble(round_.representative, peers))) return next_stage(peers);
  }
  if (!aligner_) aligner_.emplace(swarm_.own_best().controls, swarm_.best().controls);
  const AlignOutcome outcome = aligner_->advance(problem_, peers);
  if (outcome == AlignOutcome::Failed && may_add_segments()) return next_stage(peers);
  report_alignment();
  if (outcome == AlignOutcome::Agreed) {
    round_.status = PlanStatus::Ready;
    path_ = problem_.own().hermite.path(aligner_->controls());
  } else if (outcome == AlignOutcome::Failed) {
    round_.status = PlanStatus::Failed;
    round_.failed_constraint = aligner_->violated();
    round_.failed_peer = aligner_->violated_peer();
  }
}

/// The end without equalisation: the group best is flown if all have judged all to be feasible.
template <typename Space>
void PlannerIn<Space>::conclude(std::span<const Representative> peers) {
  judge(peers);
  if (round_.failed_constraint != Constraint::None && may_add_segments()) return next_stage(peers);
  Representative& out = round_.representative;
  out.violated = round_.failed_constraint;
  out.stage = PlanStage::Settled;
  if (round_.failed_constraint != Constraint::None) {
    round_.status = PlanStatus::Failed;
  } else {
    round_.status = PlanStatus::Ready;
    path_ = problem_.own().hermite.path(swarm_.best().controls);
  }
}

/// Search and alignment begin again, with one more segment for those that `peers` and the own sample name.
template <typename Space>
void PlannerIn<Space>::next_stage(std::span<const Representative> peers) {
  const ph::Controls before = swarm_.own_best().controls;
  if (takes_segment(round_.representative, peers)) ++segments_;
  ++stage_;
  problem_.seed = seed_of_stage(run_seed_, stage_);
  swarm_ = Search(problem_, segments_, before);
  aligner_.reset();
  standstill_ = {};
  round_.failed_constraint = Constraint::None;
  round_.failed_peer = 0;
  report_search();
}

/// Own constraints before those that a peer names, those before separations: of this UAV first, then of any pair.
template <typename Space>
void PlannerIn<Space>::judge(std::span<const Representative> peers) {
  const auto blame = [&](Constraint constraint, AgentId peer) {
    round_.failed_constraint = constraint;
    round_.failed_peer = peer;
  };
  const AgentId self = problem_.own().id;
  const Constraint own = round_.representative.violated;
  if (has_own_trouble(own)) return blame(own, 0);
  for (const Representative& peer : peers) {
    if (has_own_trouble(peer.violated)) return blame(peer.violated, peer.agent);
  }
  if (problem_.options.cooperate == 0) return;
  std::vector<PlannedPath> paths{{self, round_.representative.particle}};
  for (const Representative& peer : peers) paths.push_back({peer.agent, peer.particle});
  for (const PointSeparation& pair : point_separations(problem_, std::span<const PlannedPath>(paths))) {
    if (pair.least_m < pair.required_m) return blame(Constraint::Separation, pair.a == self ? pair.b : pair.a);
  }
}

template <typename Space>
void PlannerIn<Space>::report_search() {
  Representative& out = round_.representative;
  const Evaluation& best = swarm_.best();
  out.agent = problem_.own().id;
  out.stage = PlanStage::Searching;
  out.violated = first_violation(best.terms);
  out.particle = particle_of(best.controls);
  out.cost = best.modified;
  out.own_length_m = swarm_.own_best().length_m;
  out.path_length_m = best.length_m;
  round_.generation = static_cast<std::uint32_t>(swarm_.generation());
}

template <typename Space>
void PlannerIn<Space>::report_alignment() {
  Representative& out = round_.representative;
  Evaluation evaluation;
  evaluate(problem_, aligner_->controls(), evaluation);
  out.stage = aligner_->settled() ? PlanStage::Settled : PlanStage::Aligning;
  out.violated = aligner_->violated();
  out.particle = particle_of(evaluation.controls);
  out.cost = evaluation.own;
  out.path_length_m = aligner_->length_m();
}

template <typename Space>
void PlannerIn<Space>::add_to(StateHash& hash) const {
  swarm_.add_to(hash);
  hash.add(started_).add(aligner_.has_value()).add(round_.status).add(round_.representative.own_length_m);
  if (aligner_) aligner_->add_to(hash);
  if (stage_ > 1) hash.add(stage_).add(segments_);
  standstill_.add_to(hash);
}

template class PlannerIn<Planar>;
template class PlannerIn<Spatial>;

namespace {

Planner::InSpace make_in_space(const Mission& mission, AgentId self, const kernel::Kernel& kernel) {
  if (is_planar(mission)) return Planner::InSpace(std::in_place_type<PlannerIn<Planar>>, mission, self, kernel);
  return Planner::InSpace(std::in_place_type<PlannerIn<Spatial>>, mission, self, kernel);
}

}  // namespace

Planner::Planner(const Mission& mission, AgentId self, const kernel::Kernel& kernel)
    : in_space_(make_in_space(mission, self, kernel)) {}

bool Planner::can_use(const Representative& peer) const {
  return std::visit([&](const auto& planner) { return planner.can_use(peer); }, in_space_);
}

PlanRound Planner::advance(std::span<const Representative> peers) {
  return std::visit([&](auto& planner) { return planner.advance(peers); }, in_space_);
}

void Planner::add_to(StateHash& hash) const {
  std::visit([&](const auto& planner) { planner.add_to(hash); }, in_space_);
}

double Planner::path_length_m() const {
  return std::visit([](const auto& planner) { return planner.path().length_m(); }, in_space_);
}

}  // namespace skein::rendezvous
