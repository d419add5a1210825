// The check of a final path against every constraint, rigorous between its samples.
//
// A path of curvature at most K, sampled at arc distance h, deviates from the straight motion between neighbouring
// samples by at most K h^2 / 8 (its sag). So a chord that keeps the required distance plus the sag proves that the
// path keeps the distance; two UAVs that fly the same length at the same speed are held apart likewise, by the closest
// approach of their straight motions, with both sags. Distances change no faster than the path advances, so far from
// a zone or peer many samples are skipped. The penalty of the search may be 0; this check names constraints.
//
// Source: papers/001, Eq. 11, 12, 17. Departs from source: the paper checks 50 points.
// Complexity: O(dense points) Newton steps; each zone and peer O(dense points) at worst, a few steps as a rule.
#pragma once

#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// A path with its equidistant dense points and what bounds it between them.
struct DensePath {
  ph::PlanarPath path;
  std::vector<Vec2> points_m;
  double curvature_bound_per_m = 0.0;  ///< at least the largest curvature
  double sag_m = 0.0;
};

[[nodiscard]] DensePath sample_densely(const Problem& problem, const ph::PlanarPath& path);

/// The first of curvature, obstacle and no-fly zone that the path may violate, or None, which is proof that it does
/// not.
[[nodiscard]] Constraint check_alone(const Problem& problem, const DensePath& dense);
/// The same for a path that is not sampled yet; most that fail are refused by `refute`, before any sampling.
[[nodiscard]] Constraint check_alone(const Problem& problem, const ph::PlanarPath& path);

/// A constraint that the path violates for certain, by its curvature and the options' check points; None proves
/// nothing.
[[nodiscard]] Constraint refute(const Problem& problem, const ph::PlanarPath& path);

/// Proof that the two, flown so that each part of the way takes both the same time, keep a distance (m).
[[nodiscard]] bool keeps_apart(const DensePath& a, const DensePath& b, double separation_m);

}  // namespace skein::rendezvous
