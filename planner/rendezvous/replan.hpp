// A rendezvous planned anew under way: the mission that starts where each UAV will be, among what they have seen.
//
// Everybody makes it from the same revisions, so all plan the same problem: vehicles are those that take part, starts
// the poses that they promise, zones the mission's and every obstacle that one of them knows, the speed the least that
// one of them can keep, and the seed one of its own for each attempt.
// A UAV that will stand is free to face any way. Of the paths of one segment to its slot, on a coarse grid of headings
// and (m0, m1), that keep all constraints of its own it takes the heading of the shortest that is not shorter than the
// common length will be: a heading straight to the slot can reach no other length. If no path keeps the constraints,
// the heading nearest to the way to the slot along which most room is clear.
//
// Source: papers/001, section 5 ('on-line use': poses are predicted). Departs from source: the paper only names it.
// Complexity: revised O(vehicles + obstacles); best_departure O(headings * grid) paths, few of them proved.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/lockstep/samples.hpp"

namespace skein::rendezvous {

/// Who takes part in an attempt, and with what.
struct Joiner {
  AgentId agent = 0;
  Revision revision;
};

/// What a fixed obstacle keeps others out of: an upright cylinder, as high as the sphere.
[[nodiscard]] Cylinder column_of(const Track& track);

/// The fixed obstacles that anyone knows, by ascending id, each once: as the lowest agent that knows it says.
[[nodiscard]] std::vector<Track> united(std::span<const Joiner> joiners);

/// The mission of an attempt. @param joiners by ascending agent, at least one, all of them the mission's
[[nodiscard]] Mission revised(const Mission& mission, std::span<const Joiner> joiners, std::uint32_t attempt);

/// The mission with larger safety radii, by a fourth or as far as the slots allow: plans that are made for it leave
/// room for UAVs that brake, wait and draw back each on its own.
[[nodiscard]] Mission with_reserve(const Mission& mission);

/// A heading (rad) to leave a place by, and the length (m) of the path that it was chosen for.
struct Departure {
  double heading_rad = 0.0;
  double length_m = 0.0;
};

/// The best heading of a UAV at rest at a place (m), or nothing if no path of one segment leads from it to the slot.
/// @param wanted_m length that the path should have at least; if none has, the longest counts
[[nodiscard]] std::optional<Departure> best_departure(const Mission& mission, AgentId self, const Vec3& place_m,
                                                      std::span<const Track> obstacles, double wanted_m = 0.0);

/// The heading of most room, of equal ones that nearest to the way to the slot. @param reach_m at most so far
[[nodiscard]] double clearest_heading(const Mission& mission, AgentId self, const Vec3& place_m,
                                      std::span<const Track> obstacles, double reach_m);

/// Signed distance (m) of a place to the nearest of the mission's zones and the obstacles; a million if there is none.
[[nodiscard]] double clearance_m(const Mission& mission, std::span<const Track> obstacles, const Vec3& place_m);

}  // namespace skein::rendezvous
