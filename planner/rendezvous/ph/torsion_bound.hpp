// A rigorous upper bound of a path's largest torsion, between samples too.
//
// |tau| = |N(q)| / (sigma(q)^2 |b(q)|^2) with polynomials of degree 6, 4 and 4 (spatial_path.hpp), so on an interval
// |tau| <= max|N_i| / ((min sigma_i)^2 min(|b|^2)_i) by their Bernstein coefficients; intervals are halved as for the
// curvature. A path in a plane has torsion 0. Where a path that is not plane comes close to an inflection, |b|^2 almost
// 0, its torsion is large; at an inflection the bound is infinite.
// Source: papers/001, Eq. 6 and 12. Departs from source: the paper takes the largest of Np samples.
// Complexity: O(tolerance^-1/2) pieces a maximum.
#pragma once

#include "planner/rendezvous/ph/spatial_path.hpp"

namespace skein::rendezvous::ph {

/// At least the largest |torsion| (1/m) of the path, and at most `tolerance` of it plus 1e-6 / length above it.
[[nodiscard]] double max_torsion_per_m(const SpatialPath& path, double tolerance = 1e-6);

/// Whether |torsion| is nowhere above the limit (1/m), but for a millionth of it and 1e-6 / length.
[[nodiscard]] bool torsion_within(const SpatialPath& path, double limit_per_m);

}  // namespace skein::rendezvous::ph
