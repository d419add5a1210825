#include "planner/rendezvous/align/alone.hpp"

#include <algorithm>
#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::int32_t kGridNodes = 48;
constexpr int kHalvings = 12;
constexpr int kMaxMoves = 400;
/// Joined paths tried instead of a grid.
constexpr std::uint64_t kTries = 4000;

template <typename Space>
Constraint violation(const ProblemIn<Space>& problem, const ph::Controls& controls) {
  return check_alone(problem, problem.own().hermite.path(controls));
}

template <typename Space>
double cost_of(const ProblemIn<Space>& problem, const ph::Controls& controls) {
  return bare_cost(problem, problem.own().hermite.path(controls));
}

struct Node {
  double cost;
  ph::Controls controls;
};

/// Nodes of a coarse grid over (m0, m1).
template <typename Space>
std::vector<Node> grid_nodes(const ProblemIn<Space>& problem) {
  const Interval& range = problem.own().range_m;
  std::vector<Node> nodes;
  for (std::int32_t i = 0; i < kGridNodes; ++i) {
    for (std::int32_t j = 0; j < kGridNodes; ++j) {
      const auto node = [&](std::int32_t k) { return range.clamp(range.min + range.width() * k / (kGridNodes - 1)); };
      const ph::Controls controls{node(i), node(j)};
      nodes.push_back({cost_of(problem, controls), controls});
    }
  }
  return nodes;
}

/// Random paths of the segments of `like` that are not refuted at once.
template <typename Space>
std::vector<Node> joined_nodes(const ProblemIn<Space>& problem, const ph::Controls& like) {
  std::vector<Node> nodes;
  for (std::uint64_t k = 0; k < kTries; ++k) {
    RandomStream stream(problem.seed, problem.own().id, Purpose::JoinedAlone, k);
    ph::Controls controls = like;
    for (std::size_t i = 0; i < controls.size(); ++i) {
      const Interval range = start_range(problem.own(), i);
      controls[i] = range.clamp(stream.uniform(range.min, range.max));
    }
    const typename Space::Path path = problem.own().hermite.path(controls);
    if (refute<Space>(problem, path) == Constraint::None) nodes.push_back({bare_cost(problem, path), controls});
  }
  return nodes;
}

/// The cheapest of many paths that passes, or `start` with what it violates.
template <typename Space>
AlonePath cheapest(const ProblemIn<Space>& problem, const ph::Controls& start, Constraint violated) {
  std::vector<Node> nodes = start.is_joined() ? joined_nodes(problem, start) : grid_nodes(problem);
  std::ranges::stable_sort(nodes, {}, &Node::cost);
  for (const Node& node : nodes) {
    if (violation(problem, node.controls) == Constraint::None) return {node.controls, 0.0, Constraint::None};
  }
  return {start, 0.0, violated};
}

/// Steps in (m0, m1) in all eight directions, and in each interior coordinate both ways.
std::vector<ph::Controls> steps_of(const ph::Controls& like) {
  std::vector<ph::Controls> steps{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
  for (std::size_t i = 2; i < like.size(); ++i) {
    for (const double way : {1.0, -1.0}) {
      ph::Controls step;
      step[i] = way;
      steps.push_back(step);
    }
  }
  return steps;
}

template <typename Space>
void lower_cost(const ProblemIn<Space>& problem, AlonePath& best) {
  const std::vector<ph::Controls> steps = steps_of(best.controls);
  double shrunk = 1.0;  // steps, as a part of the first ones
  double cost = cost_of(problem, best.controls);
  int moves = 0;
  for (int halvings = 0; halvings < kHalvings && moves < kMaxMoves;) {
    bool moved = false;
    for (const ph::Controls& d : steps) {
      ph::Controls next = best.controls;
      for (std::size_t i = 0; i < next.size(); ++i) {
        const Interval range = range_of(problem.own(), i);
        next[i] = range.clamp(next[i] + d[i] * (range.width() / kGridNodes * shrunk));
      }
      const double next_cost = cost_of(problem, next);
      if (!(next_cost < cost) || violation(problem, next) != Constraint::None) continue;
      best.controls = next;
      cost = next_cost;
      moved = true;
      ++moves;
    }
    if (!moved) {
      shrunk *= 0.5;
      ++halvings;
    }
  }
}

}  // namespace

template <typename Space>
AlonePath best_alone(const ProblemIn<Space>& problem, const ph::Controls& start) {
  AlonePath best{start, 0.0, violation(problem, start)};
  if (best.violated != Constraint::None) best = cheapest(problem, start, best.violated);
  if (best.violated == Constraint::None) lower_cost(problem, best);
  best.length_m = problem.own().hermite.length_m(best.controls);
  return best;
}

template AlonePath best_alone(const ProblemIn<Planar>&, const ph::Controls&);
template AlonePath best_alone(const ProblemIn<Spatial>&, const ph::Controls&);

}  // namespace skein::rendezvous
