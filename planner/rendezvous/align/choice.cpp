#include "planner/rendezvous/align/choice.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "planner/rendezvous/align/level_set.hpp"
#include "planner/rendezvous/cost/cost.hpp"

namespace skein::rendezvous {
namespace {

constexpr std::int32_t kGridNodes = 64;

struct Candidate {
  double cost;
  ph::Controls controls;
  ph::PlanarPath path;
};

std::vector<Candidate> by_cost(const Problem& problem, const std::vector<ph::Controls>& controls) {
  std::vector<Candidate> candidates;
  candidates.reserve(controls.size());
  for (const ph::Controls& m : controls) {
    const ph::PlanarPath path = problem.own().hermite.path(m);
    candidates.push_back({bare_cost(problem, path), m, path});
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::cost);
  return candidates;
}

void note(Choice& choice, Constraint fails, AgentId peer) {
  if (choice.fails != Constraint::Length) return;
  choice.fails = fails;
  choice.peer = peer;
}

/// Puts a candidate where it belongs; what a cheaper one took stays.
void place(const Problem& problem, const Candidate& candidate, std::span<const Neighbour> neighbours, Choice& choice) {
  if (const Constraint fails = refute(problem, candidate.path); fails != Constraint::None) {
    return note(choice, fails, 0);
  }
  Chosen chosen{candidate.controls, sample_densely(problem, candidate.path)};
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

void choose_among(const Problem& problem, const std::vector<ph::Controls>& controls,
                  std::span<const Neighbour> neighbours, Choice& choice) {
  for (const Candidate& candidate : by_cost(problem, controls)) {
    place(problem, candidate, neighbours, choice);
    if (choice.clear) return;
  }
}

}  // namespace

AgentId conflict(const DensePath& dense, std::span<const Neighbour> neighbours, bool binding_only) {
  for (const Neighbour& peer : neighbours) {
    const bool counts = binding_only ? peer.binding : peer.at_target;
    if (counts && !keeps_apart(dense, peer.dense, peer.separation_m)) return peer.id;
  }
  return 0;
}

Choice choose(const Problem& problem, std::span<const ph::Controls> starts, double target_m,
              std::span<const Neighbour> neighbours) {
  Choice choice;
  std::vector<ph::Controls> near;
  for (const ph::Controls& from : starts) {
    const auto found = on_rays(problem.own(), from, target_m, problem.options.equalise_directions, *problem.kernel);
    near.insert(near.end(), found.begin(), found.end());
  }
  choose_among(problem, near, neighbours, choice);
  if (!choice.clear)
    choose_among(problem, on_grid(problem.own(), target_m, kGridNodes, *problem.kernel), neighbours, choice);
  return choice;
}

}  // namespace skein::rendezvous
