// A rigorous upper bound of a path's largest curvature, between samples too.
//
// |kappa| = 2 |n(q)| / sigma(q)^2 with n quadratic (in space a vector, b) and sigma quartic. On an interval both lie
// within the hull of their Bernstein coefficients, so |kappa| <= 2 max|n_i| / (min sigma_i)^2; the ends of the interval
// give values that are reached. Intervals whose bound exceeds the largest value reached by more than the tolerance are
// halved (bound_search.hpp).
// Source: papers/001, Eq. 5 and 12. Departs from source: the paper takes the largest of Np samples.
// Complexity: O(tolerance^-1/2) pieces a maximum.
#pragma once

#include "planner/rendezvous/ph/planar_path.hpp"
#include "planner/rendezvous/ph/spatial_path.hpp"

namespace skein::rendezvous::ph {

/// At least the largest |curvature| (1/m) of the path, and at most `tolerance` of it plus 1e-6 / length above it;
/// infinite at a cusp.
[[nodiscard]] double max_curvature_per_m(const PlanarPath& path, double tolerance = 1e-6);
[[nodiscard]] double max_curvature_per_m(const SpatialPath& path, double tolerance = 1e-6);

/// Whether |curvature| is nowhere above the limit (1/m), but for a millionth of it and 1e-6 / length.
[[nodiscard]] bool curvature_within(const PlanarPath& path, double limit_per_m);
[[nodiscard]] bool curvature_within(const SpatialPath& path, double limit_per_m);

}  // namespace skein::rendezvous::ph
