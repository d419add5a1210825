#include "planner/rendezvous/align/choice.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "planner/rendezvous/align/joined_level_set.hpp"
#include "planner/rendezvous/align/level_set.hpp"
#include "planner/rendezvous/cost/cost.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::int32_t kGridNodes = 64;
/// Rays from each joined start in the second look, as a multiple of those in the first.
constexpr std::size_t kSecondLook = 4;

struct Candidate {
  double cost;
  ph::Controls controls;
};

template <typename Space>
std::vector<Candidate> by_cost(const ProblemIn<Space>& problem, const std::vector<ph::Controls>& controls) {
  std::vector<Candidate> candidates;
  candidates.reserve(controls.size());
  for (const ph::Controls& m : controls) {
    candidates.push_back({bare_cost(problem, problem.own().hermite.path(m)), m});
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
  return candidates;
}

template <typename Space>
void note(ChoiceIn<Space>& choice, Constraint fails, AgentId peer) {
  if (choice.fails != Constraint::Length) return;
  choice.fails = fails;
  choice.peer = peer;
}

/// Puts a candidate where it belongs; what a cheaper one took stays.
template <typename Space>
void place(const ProblemIn<Space>& problem, const Candidate& candidate, View<NeighbourIn<Space>> neighbours,
           ChoiceIn<Space>& choice) {
  const typename Space::Path path = problem.own().hermite.path(candidate.controls);
  if (const Constraint fails = refute<Space>(problem, path); fails != Constraint::None) {
    return note(choice, fails, 0);
  }
  ChosenIn<Space> chosen{candidate.controls, sample_densely<Space>(problem, path)};
  if (const Constraint fails = check_alone(problem, chosen.dense); fails != Constraint::None) {
    return note(choice, fails, 0);
  }
  if (conflict(chosen.dense, neighbours, false) == 0) {
    choice.clear = std::move(chosen);
  } else if (const AgentId peer = conflict(chosen.dense, neighbours, true); peer != 0) {
    note(choice, Constraint::Separation, peer);
    if (!choice.alone) choice.alone = std::move(chosen);
  } else if (!choice.allowed) {
    choice.allowed = std::move(chosen);
  }
}

template <typename Space>
void choose_among(const ProblemIn<Space>& problem, const std::vector<ph::Controls>& controls,
                  View<NeighbourIn<Space>> neighbours, ChoiceIn<Space>& choice) {
  for (const Candidate& candidate : by_cost(problem, controls)) {
    place(problem, candidate, neighbours, choice);
    if (choice.clear) return;
  }
}

/// For joined segments: near the starts; then farther rays from each, since a grid has too many dimensions.
template <typename Space>
ChoiceIn<Space> choose_joined(const ProblemIn<Space>& problem, std::span<const ph::Controls> starts, double target_m,
                              View<NeighbourIn<Space>> neighbours) {
  ChoiceIn<Space> choice;
  const auto rays = static_cast<std::size_t>(problem.options.equalise_directions);
  for (const auto& [first, n] : {std::pair{std::size_t{0}, rays}, std::pair{rays, kSecondLook * rays}}) {
    std::vector<ph::Controls> near;
    for (const ph::Controls& from : starts) {
      const auto found = on_joined_rays(problem, from, target_m, first, n);
      near.insert(near.end(), found.begin(), found.end());
    }
    choose_among(problem, near, neighbours, choice);
    if (choice.clear) break;
  }
  return choice;
}

}  // namespace

template <typename Space>
AgentId conflict(const DensePathIn<Space>& dense, View<NeighbourIn<Space>> neighbours, bool binding_only) {
  for (const NeighbourIn<Space>& peer : neighbours) {
    const bool counts = binding_only ? peer.binding : peer.at_target;
    if (counts && !keeps_apart(dense, peer.dense, peer.separation_m)) return peer.id;
  }
  return 0;
}

template <typename Space>
ChoiceIn<Space> choose(const ProblemIn<Space>& problem, std::span<const ph::Controls> starts, double target_m,
                       View<NeighbourIn<Space>> neighbours) {
  if (std::ranges::any_of(starts, &ph::Controls::is_joined)) {
    return choose_joined(problem, starts, target_m, neighbours);
  }
  ChoiceIn<Space> choice;
  std::vector<ph::Controls> near;
  for (const ph::Controls& from : starts) {
    const auto found = on_rays(problem.own(), from, target_m, problem.options.equalise_directions, *problem.kernel);
    near.insert(near.end(), found.begin(), found.end());
  }
  choose_among(problem, near, neighbours, choice);
  if (choice.clear) return choice;
  choose_among(problem, on_grid(problem.own(), target_m, kGridNodes, *problem.kernel), neighbours, choice);
  return choice;
}

template AgentId conflict(const DensePathIn<Planar>&, View<NeighbourIn<Planar>>, bool);
template ChoiceIn<Planar> choose(const ProblemIn<Planar>&, std::span<const ph::Controls>, double,
                                 View<NeighbourIn<Planar>>);
template AgentId conflict(const DensePathIn<Spatial>&, View<NeighbourIn<Spatial>>, bool);
template ChoiceIn<Spatial> choose(const ProblemIn<Spatial>&, std::span<const ph::Controls>, double,
                                  View<NeighbourIn<Spatial>>);

}  // namespace skein::rendezvous
