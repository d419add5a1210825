// The cheapest path of a given length that is proved against every constraint, among many candidates.
//
// Candidates are the crossings of the level curve L(m0, m1) = target along rays from given particles and, if none of
// those is clear of everybody, along the edges of a grid over the whole search range. They are taken by ascending cost
// w1 L + (1 - w1) E; the first that passes is kept, in each of three degrees.
// Source: papers/001, Remark 3, Eq. 11 and 17. Departs from source: see align/aligner.hpp.
// Complexity: O(candidates) path costs and at most as many dense checks.
#pragma once

#include <optional>
#include <span>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"

namespace skein::rendezvous {

/// A peer as it published itself.
template <typename Space>
struct NeighbourIn {
  AgentId id = 0;
  ph::Controls controls;
  double separation_m = 0.0;  ///< to be kept from it
  bool at_target = false;     ///< its path has the target length: its motion can be compared
  bool binding = false;       ///< at the target, and has the right of way
  DensePathIn<Space> dense;
};

template <typename Space>
struct ChosenIn {
  ph::Controls controls;
  DensePathIn<Space> dense;
};

template <typename Space>
struct ChoiceIn {
  std::optional<ChosenIn<Space>> clear;    ///< keeps apart from every neighbour at the target
  std::optional<ChosenIn<Space>> allowed;  ///< keeps apart from the binding ones
  std::optional<ChosenIn<Space>> alone;    ///< keeps its own constraints; in conflict with a binding neighbour
  Constraint fails = Constraint::Length;   ///< what the cheapest candidate violates; Length if there is no candidate
  AgentId peer = 0;                        ///< and with whom, if that is the separation
};

using Neighbour = NeighbourIn<Planar>;
using Chosen = ChosenIn<Planar>;
using Choice = ChoiceIn<Planar>;

/// The first neighbour, of those at the target or only of the binding ones, that a path does not keep apart from.
template <typename Space>
[[nodiscard]] AgentId conflict(const DensePathIn<Space>& dense, View<NeighbourIn<Space>> neighbours, bool binding_only);

/// Candidates of a length (m); `starts` are the particles from which rays go out.
template <typename Space>
[[nodiscard]] ChoiceIn<Space> choose(const ProblemIn<Space>& problem, std::span<const ph::Controls> starts,
                                     double target_m, View<NeighbourIn<Space>> neighbours);

}  // namespace skein::rendezvous
