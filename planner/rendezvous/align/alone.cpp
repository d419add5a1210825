#include "planner/rendezvous/align/alone.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace skein::rendezvous {
namespace {

constexpr std::int32_t kGridNodes = 48;
constexpr int kHalvings = 12;
constexpr int kMaxMoves = 400;

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

/// The cheapest node of a coarse grid that passes, or `start` with what it violates.
template <typename Space>
AlonePath cheapest_on_grid(const ProblemIn<Space>& problem, const ph::Controls& start, Constraint violated) {
  const Interval& range = problem.own().range_m;
  std::vector<Node> nodes;
  for (std::int32_t i = 0; i < kGridNodes; ++i) {
    for (std::int32_t j = 0; j < kGridNodes; ++j) {
      const auto node = [&](std::int32_t k) { return range.clamp(range.min + range.width() * k / (kGridNodes - 1)); };
      const ph::Controls controls{node(i), node(j)};
      nodes.push_back({cost_of(problem, controls), controls});
    }
  }
  std::ranges::stable_sort(nodes, {}, &Node::cost);
  for (const Node& node : nodes) {
    if (violation(problem, node.controls) == Constraint::None) return {node.controls, 0.0, Constraint::None};
  }
  return {start, 0.0, violated};
}

template <typename Space>
void lower_cost(const ProblemIn<Space>& problem, AlonePath& best) {
  const Interval& range = problem.own().range_m;
  double step_m = range.width() / kGridNodes;
  double cost = cost_of(problem, best.controls);
  constexpr std::array<std::array<int, 2>, 8> kNeighbours{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  int moves = 0;
  for (int halvings = 0; halvings < kHalvings && moves < kMaxMoves;) {
    bool moved = false;
    for (const auto& d : kNeighbours) {
      const ph::Controls next{range.clamp(best.controls.m0_m + d[0] * step_m),
                              range.clamp(best.controls.m1_m + d[1] * step_m)};
      const double next_cost = cost_of(problem, next);
      if (!(next_cost < cost) || violation(problem, next) != Constraint::None) continue;
      best.controls = next;
      cost = next_cost;
      moved = true;
      ++moves;
    }
    if (!moved) {
      step_m *= 0.5;
      ++halvings;
    }
  }
}

}  // namespace

template <typename Space>
AlonePath best_alone(const ProblemIn<Space>& problem, const ph::Controls& start) {
  AlonePath best{start, 0.0, violation(problem, start)};
  if (best.violated != Constraint::None) best = cheapest_on_grid(problem, start, best.violated);
  if (best.violated == Constraint::None) lower_cost(problem, best);
  best.length_m = problem.own().hermite.length_m(best.controls);
  return best;
}

template AlonePath best_alone(const ProblemIn<Planar>&, const ph::Controls&);
template AlonePath best_alone(const ProblemIn<Spatial>&, const ph::Controls&);

}  // namespace skein::rendezvous
