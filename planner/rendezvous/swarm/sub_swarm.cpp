#include "planner/rendezvous/swarm/sub_swarm.hpp"

#include <algorithm>

namespace skein::rendezvous {
namespace {

template <typename Space>
double velocity_limit_m(const ProblemIn<Space>& problem) {
  return problem.options.velocity_limit * problem.own().range_m.width();
}

template <typename Space>
void hash_own(StateHash& hash, const EvaluationIn<Space>& e) {
  hash.add(e.controls.m0_m).add(e.controls.m1_m).add(e.own);
}

/// For candidates whose modified cost decides something later.
template <typename Space>
void hash_evaluation(StateHash& hash, const EvaluationIn<Space>& e) {
  hash_own(hash, e);
  hash.add(e.modified);
}

}  // namespace

template <typename Space>
SubSwarmIn<Space>::SubSwarmIn(const Problem& problem, Evaluate when)
    : refreshes_(problem.options.refresh_costs != 0),
      particles_(static_cast<std::size_t>(problem.options.particles)),
      velocities_(particles_.size()),
      costs_(problem, particles_.size(), problem.options.refresh_costs != 0 ? when : Evaluate::Always),
      best_points_(static_cast<std::size_t>(problem.options.check_points), particles_.size() + 2) {
  const std::size_t count = particles_.size();
  for (std::size_t j = 0; j < count; ++j) {
    RandomStream stream(problem.seed, problem.own().id, Purpose::SwarmStart, j);
    start(problem, j, stream);
  }
  costs_.evaluate(problem, particles_);
  costs_.walk_all(problem);
  personal_bests_ = particles_;
  for (std::size_t j = 0; j < count; ++j) best_points_.copy_lane(costs_.points(), costs_.lane_of(j), j);
  own_best_ = *std::ranges::min_element(particles_, {}, &Evaluation::own);
  const auto first =
      static_cast<std::size_t>(std::ranges::min_element(particles_, {}, &Evaluation::own) - particles_.begin());
  take_best(own_best_, best_points_, first);
  elite_ = own_best_;
  best_points_.pad(count + 1);
  stored_.reserve(count + 1);
  contenders_.reserve(count);
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
void SubSwarmIn<Space>::advance(const Problem& problem, View<PeerPath> peers,
                                std::optional<double> reference_length_m) {
  peers_.assign(peers, static_cast<std::size_t>(problem.options.check_points));
  advance(problem, peers_.peers(), reference_length_m);
}

template <typename Space>
void SubSwarmIn<Space>::advance(const Problem& problem, const kernel::Peers& peers,
                                std::optional<double> reference_length_m) {
  refresh(problem, peers, reference_length_m);
  ++generation_;
  const double progress = static_cast<double>(generation_) / static_cast<double>(problem.options.generations);
  const double inertia = problem.options.inertia_start -
                         (problem.options.inertia_start - problem.options.inertia_end) * progress * progress;
  for (std::size_t j = 0; j < particles_.size(); ++j) move(problem, j, inertia);
  costs_.evaluate(problem, particles_);
  costs_.bound(problem, particles_);
  for (const Evaluation& particle : particles_) {
    if (particle.own < own_best_.own) own_best_ = particle;
  }
  find_out_contenders(problem);
  keep_elite(problem);
  update_bests();
}

/// Those that may replace a best, and those that are likely asked for next, all in one go.
template <typename Space>
void SubSwarmIn<Space>::find_out_contenders(const Problem& problem) {
  contenders_.clear();
  for (std::size_t j = 0; j < particles_.size(); ++j) {
    const double to_beat = std::max(personal_bests_[j].modified, best_.modified);
    if (particles_[j].modified < to_beat) contenders_.push_back(j);
  }
  costs_.find_out_ahead(problem, particles_, contenders_);
}

template <typename Space>
void SubSwarmIn<Space>::refresh(const Problem& problem, const kernel::Peers& peers,
                                std::optional<double> reference_length_m) {
  if (problem.options.refresh_costs != 0 || generation_ == 0) {
    costs_.face(problem, peers, reference_length_m, particles_);
    stored_.clear();
    for (Evaluation& best : personal_bests_) stored_.push_back(&best);
    stored_.push_back(&best_);
    costs_.modify(problem, best_points_, stored_);
  } else {
    costs_.expect(peers, reference_length_m);
  }
  const std::size_t elite = costs_.least(problem, particles_);
  elite_ = particles_[elite];
  best_points_.copy_lane(costs_.points(), costs_.lane_of(elite), particles_.size() + 1);
  const auto leader = std::ranges::min_element(personal_bests_, {}, &Evaluation::modified);
  if (leader->modified < best_.modified) {
    take_best(*leader, best_points_, static_cast<std::size_t>(leader - personal_bests_.begin()));
  }
}

/// Makes a candidate the group best, with its points: lane `lane` of `points`.
template <typename Space>
void SubSwarmIn<Space>::take_best(const Evaluation& from, const PointTable& points, std::size_t lane) {
  best_ = from;
  best_points_.copy_lane(points, lane, particles_.size());
  best_.points_m.resize(points.points());
  points.copy_to(lane, best_.points_m);
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
void SubSwarmIn<Space>::keep_elite(const Problem& problem) {
  const std::size_t worst = costs_.largest(problem, particles_);
  particles_[worst] = elite_;
  costs_.replace(worst, best_points_, particles_.size() + 1);
}

template <typename Space>
void SubSwarmIn<Space>::update_bests() {
  for (std::size_t j = 0; j < particles_.size(); ++j) {
    if (!costs_.is_known(j)) continue;
    if (particles_[j].modified < personal_bests_[j].modified) {
      personal_bests_[j] = particles_[j];
      best_points_.copy_lane(costs_.points(), costs_.lane_of(j), j);
    }
    if (particles_[j].modified < best_.modified) take_best(particles_[j], costs_.points(), costs_.lane_of(j));
  }
}

template <typename Space>
void SubSwarmIn<Space>::add_to(StateHash& hash) const {
  hash.add(generation_).add(particles_.size());
  for (const Evaluation& particle : particles_) {
    if (refreshes_) hash_own(hash, particle);
    if (!refreshes_) hash_evaluation(hash, particle);
  }
  for (const ph::Controls& velocity : velocities_) hash.add(velocity.m0_m).add(velocity.m1_m);
  for (const Evaluation& best : personal_bests_) hash_evaluation(hash, best);
  hash_evaluation(hash, best_);
  hash_own(hash, own_best_);
}

template class SubSwarmIn<Planar>;
template class SubSwarmIn<Spatial>;

}  // namespace skein::rendezvous
