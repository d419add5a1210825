// The rendezvous of one UAV among its swarm, as its planner sees it, made from the mission.
//
// Poses become planar Hermite data (start pose to slot pose), search ranges of (m0, m1) are turned from chords into
// metres, and zones are kept with the distance that the centre of the vehicle must keep from them, its radius plus the
// margin. Everything stays in metres; only cost terms are in the mission's length unit.
//
// Source: papers/001, section 2.1 and Table 1. Departs from source: search range in chords, own range for every UAV;
// a small part of the curvature limit is left to the controller. Complexity: O(vehicles + zones), once.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "planner/core/geometry/bounds.hpp"
#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/kernel/dispatch.hpp"
#include "planner/rendezvous/ph/hermite.hpp"

namespace skein::rendezvous {

/// Part of the curvature limit that no planned path uses: a reserve for tracking.
inline constexpr double kCurvatureReserve = 1e-3;

/// One UAV: what every agent knows of it.
struct Participant {
  AgentId id = 0;
  ph::Hermite hermite;
  Interval range_m;  ///< of m0 and m1
  double altitude_m = 0.0;
  double safety_radius_m = 0.0;
};

/// A zone in the plane of flight. The disc about `centre_m` of radius `reach_m` holds its footprint.
struct PlanarZone {
  std::variant<Cylinder, Box> shape;
  bool no_fly = false;
  Vec2 centre_m = Vec2::Zero();
  double reach_m = 0.0;
};

struct Problem {
  std::vector<Participant> participants;  ///< by ascending id
  std::size_t self = 0;                   ///< index of the planning UAV
  std::vector<PlanarZone> zones;          ///< those that reach the altitude of flight
  double keep_out_m = 0.0;                ///< distance to be kept from zones
  double max_curvature_per_m = 0.0;       ///< with the reserve taken off
  double length_unit_m = 1.0;
  std::uint64_t seed = 0;
  RendezvousOptions options;
  const kernel::Kernel* kernel = nullptr;  ///< of static storage; all kernels give the same results

  [[nodiscard]] const Participant& own() const { return participants[self]; }
};

/// The problem of vehicle `self`. @throws std::invalid_argument if the mission is no rendezvous that can be planned in
/// a plane: options out of range, no such vehicle, ids not ascending, start and slot at one place or at different
/// altitudes, a climb, different speeds, a limit or radius that is not positive (radii may be 0).
[[nodiscard]] Problem make_problem(const Mission& mission, AgentId self,
                                   const kernel::Kernel& kernel = kernel::chosen_kernel());

/// The participant with an id. @throws std::invalid_argument if there is none.
[[nodiscard]] const Participant& participant_of(const Problem& problem, AgentId id);

/// Least horizontal distance (m) that two UAVs must keep, from safety radii and altitudes; 0 if none.
[[nodiscard]] double required_separation_m(const Participant& a, const Participant& b);

/// Signed distance (m) of a point or a segment to a zone's footprint.
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec2& p);
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec2& a, const Vec2& b);

}  // namespace skein::rendezvous
