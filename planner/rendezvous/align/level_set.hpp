// Controls (m0, m1) whose path has a given length: points of a level curve of L(m0, m1).
//
// Along a line in the plane of (m0, m1) L is continuous, so a change of sign of L - target brackets a crossing, which
// bisection narrows to rounding. The lines are rays from a particle in equally spaced directions, or the edges of a
// grid over the whole search range. A change of sign that is a jump (where the choice among the four interpolants
// changes) is left out.
// Source: papers/001, Remark 3 ('slightly increasing the parameters (m0, m1)'). Departs from source: every direction,
// exactly. Complexity: O(lines * 70) lengths in closed form, all lines together in the kernel's lanes.
#pragma once

#include <vector>

#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// Lengths that differ by less than this part count as equal: 4 micrometres in 35 km.
inline constexpr double kLengthTolerance = 1e-10;

[[nodiscard]] bool same_length(double a_m, double b_m);

/// The first crossing along each of n rays from `from`; `from` itself, alone, if its path has the length already.
template <typename Space>
[[nodiscard]] std::vector<ph::Controls> on_rays(const ParticipantIn<Space>& uav, const ph::Controls& from,
                                                double target_m, std::int32_t n,
                                                const kernel::Kernel& kernel = kernel::chosen_kernel());

/// All crossings on the edges of a grid of n x n nodes over the search range.
template <typename Space>
[[nodiscard]] std::vector<ph::Controls> on_grid(const ParticipantIn<Space>& uav, double target_m, std::int32_t n,
                                                const kernel::Kernel& kernel = kernel::chosen_kernel());

}  // namespace skein::rendezvous
