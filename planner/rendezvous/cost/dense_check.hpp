// The check of a final path against every constraint, rigorous between its samples.
//
// A path of curvature at most K, sampled at arc distance h, deviates from the straight motion between neighbouring
// samples by at most K h^2 / 8 (its sag). So a chord that keeps the required distance plus the sag proves that the
// path keeps the distance; two UAVs that fly the same length at the same speed are held apart likewise, by the closest
// approach of their straight motions, with both sags. Distances change no faster than the path advances, so far from
// a zone or peer many samples are skipped.
// Terrain of slope at most k and curvature at most c lies, over a chord of length h, at most c h^2 / 8 above the
// straight line through its heights at the ends, and a path that deviates by its sag from the chord loses at most sag
// sqrt(1 + k^2) of its height above it. The penalty of the search may be small; this check names constraints.
//
// Source: papers/001, Eq. 11, 12, 17. Departs from source: the paper checks 50 points.
// Complexity: O(dense points) Newton steps; each zone and peer O(dense points) at worst, a few steps as a rule.
#pragma once

#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// A path with its equidistant dense points and what bounds it between them.
template <typename Space>
struct DensePathIn {
  typename Space::Path path;
  std::vector<typename Space::Vec> points_m;
  double curvature_bound_per_m = 0.0;  ///< at least the largest curvature
  double sag_m = 0.0;
};

using DensePath = DensePathIn<Planar>;

template <typename Space>
[[nodiscard]] DensePathIn<Space> sample_densely(const ProblemIn<Space>& problem, const typename Space::Path& path);

/// The first of curvature, torsion, obstacle, no-fly zone and terrain that the path may violate, or None, which is
/// proof that it does not.
template <typename Space>
[[nodiscard]] Constraint check_alone(const ProblemIn<Space>& problem, const DensePathIn<Space>& dense);
/// The same for a path that is not sampled yet; most that fail are refused by `refute`, before any sampling.
template <typename Space>
[[nodiscard]] Constraint check_alone(const ProblemIn<Space>& problem, const typename Space::Path& path);

/// A constraint that the path violates for certain, by its curvature, torsion and the options' check points; None
/// proves nothing.
template <typename Space>
[[nodiscard]] Constraint refute(const ProblemIn<Space>& problem, const typename Space::Path& path);

/// Proof that the two, flown so that each part of the way takes both the same time, keep a distance (m).
template <typename Space>
[[nodiscard]] bool keeps_apart(const DensePathIn<Space>& a, const DensePathIn<Space>& b, double separation_m);

}  // namespace skein::rendezvous
