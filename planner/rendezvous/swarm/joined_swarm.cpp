#include "planner/rendezvous/swarm/joined_swarm.hpp"

#include <algorithm>

#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

/// Part of the particles that is drawn anew while none keeps all own constraints.
constexpr double kWhileInfeasible = 0.5;

template <typename Space>
void hash_evaluation(StateHash& hash, const EvaluationIn<Space>& e) {
  add_to(hash, e.controls);
  hash.add(e.own).add(e.modified);
}

}  // namespace

template <typename Space>
JoinedSwarmIn<Space>::JoinedSwarmIn(const Problem& problem, std::size_t segments, const ph::Controls& before)
    : coordinates_(particle_size<Space>(segments)) {
  const std::size_t count = segments * static_cast<std::size_t>(problem.options.particles);
  particles_.resize(count);
  velocities_.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    RandomStream stream(problem.seed, problem.own().id, Purpose::JoinedStart, j);
    start(problem, j, stream);
    if (j == 0) particles_[0].controls = clamped(problem.own(), problem.own().hermite.reshaped(before, segments));
    evaluate(problem, particles_[j].controls, particles_[j]);
  }
  personal_bests_ = particles_;
  best_ = *std::ranges::min_element(particles_, {}, &Evaluation::own);
  own_best_ = best_;
}

template <typename Space>
void JoinedSwarmIn<Space>::start(const Problem& problem, std::size_t particle, RandomStream& stream) {
  ph::Controls& at = particles_[particle].controls;
  ph::Controls& velocity = velocities_[particle];
  at.interior.size = coordinates_ - 2;
  velocity.interior.size = coordinates_ - 2;
  for (std::size_t i = 0; i < coordinates_; ++i) {
    const Interval range = range_of(problem.own(), i);
    const Interval from = start_range(problem.own(), i);
    const double limit = problem.options.velocity_limit * range.width();
    at[i] = range.clamp(stream.uniform(from.min, from.max));
    velocity[i] = stream.uniform(-limit, limit);
  }
}

template <typename Space>
void JoinedSwarmIn<Space>::advance(const Problem& problem, std::span<const PeerPath> peers,
                                   std::optional<double> reference_length_m) {
  const RendezvousOptions& options = problem.options;
  for (Evaluation& best : personal_bests_) modify(problem, peers, reference_length_m, best);
  modify(problem, peers, reference_length_m, best_);
  update_bests();
  ++generation_;
  const double progress = static_cast<double>(generation_) / static_cast<double>(options.generations);
  const double inertia = options.inertia_start - (options.inertia_start - options.inertia_end) * progress * progress;
  const bool feasible = !has_own_trouble(first_violation(own_best_.terms));
  const double drawn_anew =
      feasible ? options.reinitialise_probability : std::max(kWhileInfeasible, options.reinitialise_probability);
  for (std::size_t j = 0; j < particles_.size(); ++j) {
    move(problem, j, inertia, drawn_anew);
    evaluate(problem, particles_[j].controls, particles_[j]);
    modify(problem, peers, reference_length_m, particles_[j]);
    if (particles_[j].own < own_best_.own) own_best_ = particles_[j];
    if (particles_[j].modified < personal_bests_[j].modified) personal_bests_[j] = particles_[j];
  }
  update_bests();
}

template <typename Space>
void JoinedSwarmIn<Space>::move(const Problem& problem, std::size_t particle, double inertia, double drawn_anew) {
  const RendezvousOptions& options = problem.options;
  const std::uint64_t index = static_cast<std::uint64_t>(generation_) * particles_.size() + particle;
  RandomStream stream(problem.seed, problem.own().id, Purpose::JoinedMove, index);
  if (stream.uniform() < drawn_anew) {
    start(problem, particle, stream);
    return;
  }
  for (std::size_t i = 0; i < coordinates_; ++i) {
    const Interval range = range_of(problem.own(), i);
    const double limit = options.velocity_limit * range.width();
    double& x = particles_[particle].controls[i];
    double& v = velocities_[particle][i];
    const double cognitive = options.cognitive * stream.uniform();
    const double social = options.social * stream.uniform();
    v = Interval{-limit, limit}.clamp(inertia * v + cognitive * (personal_bests_[particle].controls[i] - x) +
                                      social * (best_.controls[i] - x));
    x = range.clamp(x + v);
  }
}

/// The group best is the best of all personal bests.
template <typename Space>
void JoinedSwarmIn<Space>::update_bests() {
  const auto leader = std::ranges::min_element(personal_bests_, {}, &Evaluation::modified);
  if (leader->modified < best_.modified) best_ = *leader;
}

template <typename Space>
void JoinedSwarmIn<Space>::add_to(StateHash& hash) const {
  hash.add(generation_).add(particles_.size());
  for (const Evaluation& particle : particles_) hash_evaluation(hash, particle);
  for (const ph::Controls& velocity : velocities_) rendezvous::add_to(hash, velocity);
  for (const Evaluation& best : personal_bests_) hash_evaluation(hash, best);
  hash_evaluation(hash, best_);
  hash_evaluation(hash, own_best_);
}

template class JoinedSwarmIn<Planar>;
template class JoinedSwarmIn<Spatial>;

}  // namespace skein::rendezvous
