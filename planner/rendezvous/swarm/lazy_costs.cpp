#include "planner/rendezvous/swarm/lazy_costs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace skein::rendezvous {
namespace {

template <typename Space>
std::size_t points_of(const ProblemIn<Space>& problem) {
  return static_cast<std::size_t>(problem.options.check_points);
}

/// The modified cost if the particle collides.
template <typename Space>
double upper_bound(const ProblemIn<Space>& problem, const EvaluationIn<Space>& particle) {
  CostTerms terms = particle.terms;
  terms.collision = problem.options.penalty;
  return modified_cost(terms, problem.options.length_weight);
}

}  // namespace

template <typename Space>
LazyCostsIn<Space>::LazyCostsIn(const Problem& problem, std::size_t particles, Evaluate when)
    : when_(when),
      batch_(problem, particles),
      points_(points_of(problem), particles * problem.kernel->width + kernel::kLaneMultiple),
      lane_of_(particles),
      gathered_(points_of(problem), particles),
      collided_(1, particles + kernel::kLaneMultiple),
      walked_(particles, 0),
      known_(particles, 0),
      all_(particles),
      keys_(particles) {
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  to_walk_.reserve(particles);
  open_.reserve(particles);
}

template <typename Space>
void LazyCostsIn<Space>::evaluate(const Problem& problem, std::span<Evaluation> particles) {
  batch_.evaluate(problem, particles);
  std::ranges::fill(walked_, char{0});
  lanes_used_ = 0;
}

template <typename Space>
void LazyCostsIn<Space>::face(const Problem& problem, const kernel::Peers& peers,
                              std::optional<double> reference_length_m, std::span<Evaluation> particles) {
  expect(peers, reference_length_m);
  bound(problem, particles);
}

template <typename Space>
void LazyCostsIn<Space>::expect(const kernel::Peers& peers, std::optional<double> reference_length_m) {
  peers_ = peers;
  reference_length_m_ = reference_length_m;
}

template <typename Space>
void LazyCostsIn<Space>::bound(const Problem& problem, std::span<Evaluation> particles) {
  for (Evaluation& particle : particles) set_cooperation(problem, false, reference_length_m_, particle);
  std::ranges::fill(known_, char{0});
  if (when_ == Evaluate::Always) find_out(problem, particles, all_);
}

template <typename Space>
void LazyCostsIn<Space>::modify(const Problem& problem, const PointTable& points,
                                std::span<Evaluation* const> evaluations) {
  Space::steps(*problem.kernel).meet(points.view(), points.points(), evaluations.size(), peers_, collided_.row(0));
  for (std::size_t i = 0; i < evaluations.size(); ++i) {
    set_cooperation(problem, collided_.row(0)[i] > 0.0, reference_length_m_, *evaluations[i]);
  }
}

template <typename Space>
void LazyCostsIn<Space>::walk_all(const Problem& problem) {
  walk(problem, all_);
}

template <typename Space>
std::size_t LazyCostsIn<Space>::walk(const Problem& problem, std::span<const std::size_t> chosen) {
  to_walk_.clear();
  std::ranges::copy_if(chosen, std::back_inserter(to_walk_), [&](std::size_t j) { return walked_[j] == 0; });
  const std::size_t first = lanes_used_;
  if (to_walk_.empty()) return first;
  batch_.walk(problem, to_walk_, points_, first);
  const std::size_t width = problem.kernel->width;
  lanes_used_ += (to_walk_.size() + width - 1) / width * width;  // a kernel writes whole packs
  for (std::size_t i = 0; i < to_walk_.size(); ++i) {
    lane_of_[to_walk_[i]] = first + i;
    walked_[to_walk_[i]] = 1;
  }
  return first;
}

template <typename Space>
void LazyCostsIn<Space>::find_out(const Problem& problem, std::span<Evaluation> particles,
                                  std::span<const std::size_t> chosen) {
  if (chosen.empty()) return;
  kernel::ConstTable points = points_.view(walk(problem, chosen));
  if (to_walk_.size() < chosen.size()) {  // else they stand there side by side, padded by the kernel
    for (std::size_t i = 0; i < chosen.size(); ++i) gathered_.copy_lane(points_, lane_of_[chosen[i]], i);
    gathered_.pad(chosen.size());
    points = gathered_.view();
  }
  Space::steps(*problem.kernel).meet(points, points_of(problem), chosen.size(), peers_, collided_.row(0));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    set_cooperation(problem, collided_.row(0)[i] > 0.0, reference_length_m_, particles[chosen[i]]);
    known_[chosen[i]] = 1;
  }
}

/// Lists the unknown particles of least keys, by key.
template <typename Space>
void LazyCostsIn<Space>::list_open(std::size_t most) {
  open_.clear();
  std::ranges::copy_if(all_, std::back_inserter(open_), [&](std::size_t j) { return !is_known(j); });
  const std::size_t count = std::min(most, open_.size());
  const auto by_key = [&](std::size_t a, std::size_t b) {
    return keys_[a] < keys_[b] || (keys_[a] == keys_[b] && a < b);
  };
  std::ranges::partial_sort(open_, open_.begin() + static_cast<std::ptrdiff_t>(count), by_key);
  open_.resize(count);
}

template <typename Space>
void LazyCostsIn<Space>::find_out_ahead(const Problem& problem, std::span<Evaluation> particles,
                                        std::vector<std::size_t>& chosen) {
  if (when_ == Evaluate::Always) return;
  const std::size_t width = problem.kernel->width;
  const auto add = [&](std::size_t most, const auto& key) {
    for (std::size_t j = 0; j < particles.size(); ++j) keys_[j] = key(particles[j]);
    for (const std::size_t j : chosen) keys_[j] = std::numeric_limits<double>::infinity();
    list_open(std::min(most, particles.size() - chosen.size()));
    chosen.insert(chosen.end(), open_.begin(), open_.end());
  };
  add(width, [](const Evaluation& e) { return e.modified; });
  add(width - chosen.size() % width, [&](const Evaluation& e) { return -upper_bound(problem, e); });
  find_out(problem, particles, chosen);
}

/// The first particle of least key; an unknown one's key is a lower bound of it.
template <typename Space>
template <typename Key>
std::size_t LazyCostsIn<Space>::extreme(const Problem& problem, std::span<Evaluation> particles, const Key& key) {
  for (;;) {
    for (std::size_t j = 0; j < particles.size(); ++j) keys_[j] = key(particles[j], is_known(j));
    const auto first = static_cast<std::size_t>(std::ranges::min_element(keys_) - keys_.begin());
    if (is_known(first)) return first;
    list_open(problem.kernel->width);
    find_out(problem, particles, open_);
  }
}

template <typename Space>
std::size_t LazyCostsIn<Space>::least(const Problem& problem, std::span<Evaluation> particles) {
  return extreme(problem, particles, [](const Evaluation& e, bool) { return e.modified; });
}

template <typename Space>
std::size_t LazyCostsIn<Space>::largest(const Problem& problem, std::span<Evaluation> particles) {
  return extreme(problem, particles,
                 [&](const Evaluation& e, bool known) { return -(known ? e.modified : upper_bound(problem, e)); });
}

template <typename Space>
void LazyCostsIn<Space>::replace(std::size_t particle, const PointTable& points, std::size_t lane) {
  lane_of_[particle] = lanes_used_++;
  points_.copy_lane(points, lane, lane_of_[particle]);
  walked_[particle] = 1;
  known_[particle] = 1;
}

template class LazyCostsIn<Planar>;
template class LazyCostsIn<Spatial>;

}  // namespace skein::rendezvous
