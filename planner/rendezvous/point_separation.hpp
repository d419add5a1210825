// Separations of planned paths as the paper measures them, at the points that have the same number.
//
//   dis_min,ij = min over k of |r_i(k) - r_j(k)|, k = 1 .. Nph, the points of each path at equal arc distances (Eq. 17)
// On paths of different lengths the points of one number are not reached at the same time: the figure then is the
// paper's (its Table 3), not the distance in flight.
//
// Source: papers/001, Eq. 17. Departs from source: none. Complexity: O(N Np Newton + N^2 Np).
#pragma once

#include <span>
#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

struct PointSeparation {
  AgentId a = 0;
  AgentId b = 0;
  double least_m = 0.0;     ///< dis_min
  double required_m = 0.0;  ///< to be kept, in the plane

  bool operator==(const PointSeparation&) const = default;
};

/// The path that an agent plans to fly: its particle.
struct PlannedPath {
  AgentId agent = 0;
  std::vector<double> particle;  ///< of 1 to 4 segments (cost/coordinates.hpp), within the search range
};

/// Of every pair, in the order of `paths`. @throws std::invalid_argument for an agent that the problem does not have
/// or a particle that is not one of 1 to 4 segments.
template <typename Space>
[[nodiscard]] std::vector<PointSeparation> point_separations(const ProblemIn<Space>& problem,
                                                             std::span<const PlannedPath> paths);

/// The same from a mission. @throws std::invalid_argument as make_problem and above.
[[nodiscard]] std::vector<PointSeparation> point_separations(const Mission& mission,
                                                             std::span<const PlannedPath> paths);

}  // namespace skein::rendezvous
