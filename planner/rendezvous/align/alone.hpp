// The best path that a UAV finds for itself, proved against every own constraint: what it brings to the alignment.
//
// It starts at the particle that was best by own cost (Eq. 11). If that one fails the dense check, the nodes of a
// coarse grid over the search range, for joined segments random paths, are taken in the order of their cost until one
// passes. A pattern search then lowers the cost: eight neighbours in (m0, m1) and two for each interior coordinate, the
// step halved when none is better, every step proved again.
// Source: papers/001, Eq. 11. Departs from source: the paper takes the particle as it is, checked at 50 points.
// Complexity: O(halvings * 8) evaluations, and 48^2 more with the grid.
#pragma once

#include "planner/rendezvous/cost/cost.hpp"
#include "planner/rendezvous/cost/dense_check.hpp"

namespace skein::rendezvous {

struct AlonePath {
  ph::Controls controls;
  double length_m = 0.0;
  Constraint violated = Constraint::None;  ///< not None: no path of this UAV was found that keeps its own constraints
};

template <typename Space>
[[nodiscard]] AlonePath best_alone(const ProblemIn<Space>& problem, const ph::Controls& start);

}  // namespace skein::rendezvous
