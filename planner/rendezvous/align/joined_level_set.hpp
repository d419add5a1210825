// Controls of joined segments whose path has a given length: points of a level surface of L in all coordinates.
//
// As level_set.hpp, along rays from given controls in the space of all coordinates, each scaled by its range: first
// both ways along every axis, then in random directions. A ray ends where a coordinate leaves its range. Source:
// papers/001, Remarks 3 and 4. Departs from source: every direction, exactly. Complexity: O(rays * 80) lengths.
#pragma once

#include <vector>

#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// The first crossing along each of rays number first .. first + n - 1; `from` itself, alone, if its path has the
/// length (m) already.
template <typename Space>
[[nodiscard]] std::vector<ph::Controls> on_joined_rays(const ProblemIn<Space>& problem, const ph::Controls& from,
                                                       double target_m, std::size_t first, std::size_t n);

}  // namespace skein::rendezvous
