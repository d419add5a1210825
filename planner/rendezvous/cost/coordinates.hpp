// The particle of a path: its control variables in their order, their ranges, and how many of them make how many
// segments.
//
// A particle is (m0, m1, then for each free interior coefficient its length m and its angles): 2, 4, 6 or 8 numbers in
// the plane, 2, 5, 8 or 11 in space for 1 to 4 segments. Lengths have the search range of m0 and m1, angles [-pi, pi].
//
// Source: papers/001, section 3.1 and Remark 4. Departs from source: see ph/joined_hermite.hpp. Complexity: O(1).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// How many numbers shape a path of so many segments.
template <typename Space>
[[nodiscard]] constexpr std::size_t particle_size(std::size_t segments) {
  return 2 + Space::Hermite::kPerCoefficient * (segments - 1);
}

/// Number of segments of a path.
template <typename Space>
[[nodiscard]] constexpr std::size_t segments_of(const ph::Controls& controls) {
  return 1 + controls.interior.size / Space::Hermite::kPerCoefficient;
}

/// Whether coordinate i of a particle is an angle (rad); otherwise a length (m).
template <typename Space>
[[nodiscard]] constexpr bool is_angle(std::size_t i) {
  return i >= 2 && (i - 2) % Space::Hermite::kPerCoefficient != 0;
}

/// The range of coordinate i of a UAV's particles.
template <typename Space>
[[nodiscard]] Interval range_of(const ParticipantIn<Space>& uav, std::size_t i);

/// The part of the range in which a search starts: interior lengths below twice the chord, angles within 2 rad of it.
template <typename Space>
[[nodiscard]] Interval start_range(const ParticipantIn<Space>& uav, std::size_t i);

/// Each coordinate moved into its range.
template <typename Space>
[[nodiscard]] ph::Controls clamped(const ParticipantIn<Space>& uav, ph::Controls controls);

/// The controls of a particle, or nothing if its size is that of no path of up to kMaxSegments segments.
template <typename Space>
[[nodiscard]] std::optional<ph::Controls> controls_of(std::span<const double> particle);

[[nodiscard]] std::vector<double> particle_of(const ph::Controls& controls);

/// All numbers of the controls, in their order.
void add_to(StateHash& hash, const ph::Controls& controls);

}  // namespace skein::rendezvous
