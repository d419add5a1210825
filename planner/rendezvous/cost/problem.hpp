// The rendezvous of one UAV among its swarm, as its planner sees it, made from the mission.
//
// Poses become Hermite data of the problem's space (start pose to slot pose): the plane if the whole mission
// lies at level heights, else space. Search ranges of (m0, m1) are turned from chords into
// metres, and zones are kept with the distance that the centre of the vehicle must keep from them, its radius plus the
// margin. Everything stays in metres; only cost terms are in the mission's length unit.
//
// Source: papers/001, section 2.1 and Table 1. Departs from source: search range in chords, own range for every UAV;
// a small part of the curvature limit is left to the controller. Complexity: O(vehicles + zones), once.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "planner/core/geometry/bounds.hpp"
#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/cost/space.hpp"
#include "planner/rendezvous/kernel/dispatch.hpp"

namespace skein::rendezvous {

/// Part of the curvature limit that no planned path uses: a reserve for tracking.
inline constexpr double kCurvatureReserve = 1e-3;

/// One UAV: what every agent knows of it.
template <typename Space>
struct ParticipantIn {
  AgentId id = 0;
  typename Space::Hermite hermite;
  Interval range_m;         ///< of m0 and m1
  double altitude_m = 0.0;  ///< of the slot, and in the plane of the whole flight
  double safety_radius_m = 0.0;
};

/// A zone and where it is in the plane: the disc about `centre_m` of radius `reach_m` holds its footprint.
struct PlanarZone {
  std::variant<Cylinder, Box> shape;
  bool no_fly = false;
  Vec2 centre_m = Vec2::Zero();
  double reach_m = 0.0;
  Interval heights_m;  ///< from its lower to its upper end
};

template <typename Space>
struct ProblemIn {
  std::vector<ParticipantIn<Space>> participants;  ///< by ascending id
  std::size_t self = 0;                            ///< index of the planning UAV
  std::vector<PlanarZone> zones;                   ///< in the plane those that reach the altitude of flight
  double keep_out_m = 0.0;                         ///< distance to be kept from zones
  double max_curvature_per_m = 0.0;                ///< with the reserve taken off
  double max_torsion_per_m = 0.0;                  ///< in space; likewise
  std::optional<Terrain> terrain;                  ///< in space
  double terrain_height_m = 0.0;  ///< to be kept above the terrain, so that keep_out_m is kept from its slopes
  double terrain_roof_m = 0.0;    ///< height from which on the terrain does not matter
  double length_unit_m = 1.0;
  std::uint64_t seed = 0;
  RendezvousOptions options;
  const kernel::Kernel* kernel = nullptr;  ///< never null once made; all give the same results

  [[nodiscard]] const ParticipantIn<Space>& own() const { return participants[self]; }
};

using Participant = ParticipantIn<Planar>;
using Problem = ProblemIn<Planar>;

/// Whether the mission can be planned in the plane: every start and slot level, each start at its slot's altitude, and
/// no terrain.
[[nodiscard]] bool is_planar(const Mission& mission);

/// The problem of vehicle `self`. @throws std::invalid_argument if the mission is no rendezvous that can be planned:
/// options out of range, no such vehicle, ids not ascending, start and slot at one place, different speeds, a limit or
/// radius that is not positive (radii may be 0); in the plane also start and slot at different altitudes, or a climb.
template <typename Space = Planar>
[[nodiscard]] ProblemIn<Space> make_problem(const Mission& mission, AgentId self,
                                            const kernel::Kernel& kernel = kernel::chosen_kernel());

/// The participant with an id. @throws std::invalid_argument if there is none.
template <typename Space>
[[nodiscard]] const ParticipantIn<Space>& participant_of(const ProblemIn<Space>& problem, AgentId id);

/// Least distance (m) that two UAVs must keep; in the plane the horizontal one, from safety radii and altitudes, 0 if
/// none.
template <typename Space>
[[nodiscard]] double required_separation_m(const ParticipantIn<Space>& a, const ParticipantIn<Space>& b);

/// Signed distance (m) of a point or a segment to a zone's footprint, or in space to the zone.
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec2& p);
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec2& a, const Vec2& b);
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec3& p);
[[nodiscard]] double distance_m(const PlanarZone& zone, const Vec3& a, const Vec3& b);

}  // namespace skein::rendezvous
