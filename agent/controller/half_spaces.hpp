// The velocity nearest to a wished one among those that many half-spaces and a speed allow.
//
// Half-space j: normal_j . v >= least_j. One after the other: while the best so far lies in the next half-space it
// stays the best; else the best lies on its boundary, a plane, where the same is done in two dimensions with the
// half-spaces before it, and there on a line. If they have no velocity in common, the least t is sought by bisection
// for which all normal_j . v >= least_j - t do: the worst violation is least. Source: Seidel, 'Small-dimensional linear
// programming and convex hulls made easy', 1991; used for velocities by van den Berg, Guy, Lin, Manocha, 'Reciprocal
// n-body collision avoidance', 2011, section 5. Departs from source: in the order given instead of a random one, and
// bisection instead of one dimension more. Complexity: O(n) if few half-spaces cut the best off, O(n^3) at worst; with
// nothing in common times kBisections.
#pragma once

#include <optional>
#include <span>

#include "planner/core/geometry/types.hpp"

namespace skein {

struct HalfSpace {
  Vec3 normal = Vec3::Zero();  ///< unit
  double least_mps = 0.0;
};

/// Of the bisection: the worst violation is the least to 2^-kBisections of its range.
inline constexpr int kBisections = 16;

/// Nearest to `wish_mps` (m/s) with |v| <= speed_mps, in all half-spaces relaxed by `slack_mps`; nothing if there is
/// none.
/// @param level the answer is level; wish_mps is then taken as level too
[[nodiscard]] std::optional<Vec3> nearest_in(std::span<const HalfSpace> spaces, double slack_mps, double speed_mps,
                                             const Vec3& wish_mps, bool level);

/// The same without slack if there is one, else with the least slack.
[[nodiscard]] Vec3 nearest_or_least_violation(std::span<const HalfSpace> spaces, double speed_mps, const Vec3& wish_mps,
                                              bool level);

}  // namespace skein
