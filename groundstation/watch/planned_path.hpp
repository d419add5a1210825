// Planned paths as lines to draw, and how much of one is left.
//
// A rendezvous plans by particles: the Pythagorean-hodograph path of (m0, m1) from start to slot. A transit plans one
// decision: where it will be, and the next cells. Source: papers/001, Eq. 2-6; papers/004. Departs from source: none.
// Complexity: O(points) a path; left_m O(points).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein::watch {

/// The path of a particle at equal arc distances; empty if the mission or the particle has none.
/// @param from where the plan starts: the vehicle's own start unless it was made under way
[[nodiscard]] std::vector<Vec3> planned_line(const Mission& mission, AgentId agent, std::span<const double> particle,
                                             const std::optional<Pose>& from);

/// The motion that an intent announces: from `position_m` to its end and through the next cells.
[[nodiscard]] std::vector<Vec3> intended_line(const Mission& mission, const Intent& intent, const Vec3& position_m);

/// Length (m) of a line from the point on it that is nearest to `position_m` to its end. @pre two points or more
[[nodiscard]] double left_m(std::span<const Vec3> line_m, const Vec3& position_m);

}  // namespace skein::watch
