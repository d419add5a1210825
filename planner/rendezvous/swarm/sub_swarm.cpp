#include "planner/rendezvous/swarm/sub_swarm.hpp"

#include <algorithm>

namespace skein::rendezvous {
namespace {

template <typename Space>
double velocity_limit_m(const ProblemIn<Space>& problem) {
  return problem.options.velocity_limit * problem.own().range_m.width();
}

template <typename Space>
void hash_evaluation(StateHash& hash, const EvaluationIn<Space>& e) {
  hash.add(e.controls.m0_m).add(e.controls.m1_m).add(e.own).add(e.modified);
}

}  // namespace

template <typename Space>
SubSwarmIn<Space>::SubSwarmIn(const Problem& problem) {
  const auto count = static_cast<std::size_t>(problem.options.particles);
  particles_.resize(count);
  velocities_.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    RandomStream stream(problem.seed, problem.own().id, Purpose::SwarmStart, j);
    start(problem, j, stream);
    evaluate(problem, particles_[j].controls, particles_[j]);
  }
  personal_bests_ = particles_;
  best_ = *std::ranges::min_element(particles_, {}, &Evaluation::own);
  own_best_ = best_;
  elite_ = best_;
}

template <typename Space>
void SubSwarmIn<Space>::start(const Problem& problem, std::size_t particle, RandomStream& stream) {
  const Interval& range = problem.own().range_m;
  const double limit = velocity_limit_m(problem);
  particles_[particle].controls.m0_m = range.clamp(stream.uniform(range.min, range.max));
  particles_[particle].controls.m1_m = range.clamp(stream.uniform(range.min, range.max));
  velocities_[particle].m0_m = stream.uniform(-limit, limit);
  velocities_[particle].m1_m = stream.uniform(-limit, limit);
}

template <typename Space>
void SubSwarmIn<Space>::advance(const Problem& problem, std::span<const PeerPath> peers,
                                std::optional<double> reference_length_m) {
  refresh(problem, peers, reference_length_m);
  ++generation_;
  const double progress = static_cast<double>(generation_) / static_cast<double>(problem.options.generations);
  const double inertia = problem.options.inertia_start -
                         (problem.options.inertia_start - problem.options.inertia_end) * progress * progress;
  for (std::size_t j = 0; j < particles_.size(); ++j) {
    move(problem, j, inertia);
    evaluate(problem, particles_[j].controls, particles_[j]);
    modify(problem, peers, reference_length_m, particles_[j]);
    if (particles_[j].own < own_best_.own) own_best_ = particles_[j];
  }
  keep_elite();
  update_bests();
}

template <typename Space>
void SubSwarmIn<Space>::refresh(const Problem& problem, std::span<const PeerPath> peers,
                                std::optional<double> reference_length_m) {
  if (problem.options.refresh_costs != 0 || generation_ == 0) {
    for (Evaluation& particle : particles_) modify(problem, peers, reference_length_m, particle);
    for (Evaluation& best : personal_bests_) modify(problem, peers, reference_length_m, best);
    modify(problem, peers, reference_length_m, best_);
  }
  elite_ = *std::ranges::min_element(particles_, {}, &Evaluation::modified);
  const auto leader = std::ranges::min_element(personal_bests_, {}, &Evaluation::modified);
  if (leader->modified < best_.modified) best_ = *leader;
}

template <typename Space>
void SubSwarmIn<Space>::move(const Problem& problem, std::size_t particle, double inertia) {
  const RendezvousOptions& options = problem.options;
  const std::uint64_t index = static_cast<std::uint64_t>(generation_) * particles_.size() + particle;
  RandomStream stream(problem.seed, problem.own().id, Purpose::SwarmMove, index);
  if (stream.uniform() < options.reinitialise_probability) {
    start(problem, particle, stream);
    return;
  }
  const double limit = velocity_limit_m(problem);
  const Interval velocities{-limit, limit};
  for (double ph::Controls::*d : {&ph::Controls::m0_m, &ph::Controls::m1_m}) {
    double& x = particles_[particle].controls.*d;
    double& v = velocities_[particle].*d;
    const double cognitive = options.cognitive * stream.uniform();
    const double social = options.social * stream.uniform();
    v = velocities.clamp(inertia * v + cognitive * (personal_bests_[particle].controls.*d - x) +
                         social * (best_.controls.*d - x));
    x = problem.own().range_m.clamp(x + v);
  }
}

template <typename Space>
void SubSwarmIn<Space>::keep_elite() {
  *std::ranges::max_element(particles_, {}, &Evaluation::modified) = elite_;
}

template <typename Space>
void SubSwarmIn<Space>::update_bests() {
  for (std::size_t j = 0; j < particles_.size(); ++j) {
    if (particles_[j].modified < personal_bests_[j].modified) personal_bests_[j] = particles_[j];
    if (particles_[j].modified < best_.modified) best_ = particles_[j];
  }
}

template <typename Space>
void SubSwarmIn<Space>::add_to(StateHash& hash) const {
  hash.add(generation_).add(particles_.size());
  for (const Evaluation& particle : particles_) hash_evaluation(hash, particle);
  for (const ph::Controls& velocity : velocities_) hash.add(velocity.m0_m).add(velocity.m1_m);
  for (const Evaluation& best : personal_bests_) hash_evaluation(hash, best);
  hash_evaluation(hash, best_);
  hash_evaluation(hash, own_best_);
}

template class SubSwarmIn<Planar>;
template class SubSwarmIn<Spatial>;

}  // namespace skein::rendezvous
