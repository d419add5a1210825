#include "planner/rendezvous/swarm/genetic_population.hpp"

#include <algorithm>
#include <array>

namespace skein::rendezvous {
namespace {

/// Under it fitness no longer grows: a straight path may cost nothing if the length has no weight.
constexpr double kLeastCost = 1e-9;

using Pair = std::array<ph::Controls, 2>;
constexpr std::array<double ph::Controls::*, 2> kGenes{&ph::Controls::m0_m, &ph::Controls::m1_m};

Pair crossed(const RendezvousOptions& options, const Pair& parents, RandomStream& stream) {
  if (!(stream.uniform() < options.crossover_probability)) return parents;
  const double a = stream.uniform();
  Pair children;
  for (double ph::Controls::*gene : kGenes) {
    children[0].*gene = a * parents[0].*gene + (1.0 - a) * parents[1].*gene;
    children[1].*gene = (1.0 - a) * parents[0].*gene + a * parents[1].*gene;
  }
  return children;
}

template <typename Space>
ph::Controls mutated(const ProblemIn<Space>& problem, ph::Controls child, RandomStream& stream) {
  const Interval& range = problem.own().range_m;
  for (double ph::Controls::*gene : kGenes) {
    if (stream.uniform() < problem.options.mutation_probability) child.*gene = stream.uniform(range.min, range.max);
    child.*gene = range.clamp(child.*gene);
  }
  return child;
}

template <typename Space>
void hash_individual(StateHash& hash, const EvaluationIn<Space>& e) {
  hash.add(e.controls.m0_m).add(e.controls.m1_m).add(e.own).add(e.modified);
}

}  // namespace

template <typename Space>
GeneticPopulationIn<Space>::GeneticPopulationIn(const Problem& problem)
    : individuals_(static_cast<std::size_t>(problem.options.particles)),
      costs_(problem, individuals_.size(), Evaluate::Always),
      elite_points_(static_cast<std::size_t>(problem.options.check_points), 1),
      wheel_(individuals_.size()) {
  const Interval& range = problem.own().range_m;
  for (std::size_t j = 0; j < individuals_.size(); ++j) {
    RandomStream stream(problem.seed, problem.own().id, Purpose::SwarmStart, j);
    ph::Controls& controls = individuals_[j].controls;
    for (double ph::Controls::*gene : kGenes) controls.*gene = range.clamp(stream.uniform(range.min, range.max));
  }
  costs_.evaluate(problem, individuals_);
  costs_.walk_all(problem);
  best_ = *std::ranges::min_element(individuals_, {}, &Evaluation::own);
  own_best_ = best_;
}

template <typename Space>
void GeneticPopulationIn<Space>::advance(const Problem& problem, View<PeerPath> peers,
                                         std::optional<double> reference_length_m) {
  peers_.assign(peers, static_cast<std::size_t>(problem.options.check_points));
  advance(problem, peers_.peers(), reference_length_m);
}

template <typename Space>
void GeneticPopulationIn<Space>::advance(const Problem& problem, const kernel::Peers& peers,
                                         std::optional<double> reference_length_m) {
  refresh(problem, peers, reference_length_m);
  const std::size_t best = costs_.least(problem, individuals_);
  const Evaluation elite = individuals_[best];
  elite_points_.copy_lane(costs_.points(), costs_.lane_of(best), 0);
  const std::size_t count = individuals_.size();
  ++generation_;
  children_.clear();
  children_.reserve(count + 1);
  while (children_.size() < count) {
    const std::uint64_t index = static_cast<std::uint64_t>(generation_) * count + children_.size();
    RandomStream stream(problem.seed, problem.own().id, Purpose::Breeding, index);
    const ph::Controls& one = spin(stream);
    const ph::Controls& other = spin(stream);
    for (const ph::Controls& child : crossed(problem.options, {one, other}, stream)) {
      children_.push_back(mutated(problem, child, stream));
    }
  }
  for (std::size_t j = 0; j < count; ++j) individuals_[j].controls = children_[j];
  costs_.evaluate(problem, individuals_);
  costs_.bound(problem, individuals_);
  for (const Evaluation& child : individuals_) {
    if (child.own < own_best_.own) own_best_ = child;
  }
  const std::size_t worst = costs_.largest(problem, individuals_);
  individuals_[worst] = elite;
  costs_.replace(worst, elite_points_, 0);
  best_ = individuals_[costs_.least(problem, individuals_)];
}

/// Costs in the group as it is now (stale ones stay as they were stored), and the roulette wheel from them.
template <typename Space>
void GeneticPopulationIn<Space>::refresh(const Problem& problem, const kernel::Peers& peers,
                                         std::optional<double> reference_length_m) {
  if (problem.options.refresh_costs != 0 || generation_ == 0) {
    costs_.face(problem, peers, reference_length_m, individuals_);
  } else {
    costs_.expect(peers, reference_length_m);
  }
  double sum = 0.0;
  for (std::size_t j = 0; j < individuals_.size(); ++j) {
    sum += 1.0 / std::max(individuals_[j].modified, kLeastCost);
    wheel_[j] = sum;
  }
}

/// An individual by roulette.
template <typename Space>
const ph::Controls& GeneticPopulationIn<Space>::spin(RandomStream& stream) const {
  const double at = stream.uniform() * wheel_.back();
  const auto found = std::ranges::upper_bound(wheel_, at);
  const auto index = std::min<std::size_t>(static_cast<std::size_t>(found - wheel_.begin()), wheel_.size() - 1);
  return individuals_[index].controls;
}

template <typename Space>
void GeneticPopulationIn<Space>::add_to(StateHash& hash) const {
  hash.add(generation_).add(individuals_.size());
  for (const Evaluation& individual : individuals_) hash_individual(hash, individual);
  hash_individual(hash, best_);
  hash_individual(hash, own_best_);
}

template class GeneticPopulationIn<Planar>;
template class GeneticPopulationIn<Spatial>;

}  // namespace skein::rendezvous
