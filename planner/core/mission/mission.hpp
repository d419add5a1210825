// The mission: all that agents are told, published by the world before a run starts.
//
// It holds vehicles, poses, formation, known obstacles and no-fly zones, planner options and the seed. What an agent
// may not know is not in it. Source: papers/001, section 2.1, for the formation rendezvous.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"
#include "planner/core/geometry/terrain.hpp"
#include "planner/core/geometry/types.hpp"
#include "planner/core/hash/state_hash.hpp"
#include "planner/core/options/controller_options.hpp"
#include "planner/core/options/rendezvous_options.hpp"
#include "planner/core/options/transit_options.hpp"

namespace skein {

/// An agent's id: 1 to kMaxAgents. 0 is the world.
using AgentId = std::uint32_t;
inline constexpr AgentId kMaxAgents = 256;
inline constexpr AgentId kWorldId = 0;

enum class MissionKind : std::uint8_t { Rendezvous = 1, Transit = 2 };
/// Holonomic flies any velocity up to its speed, at once (papers/004, section III).
enum class VehicleType : std::uint8_t { ConstantSpeed = 1, Multirotor = 2, Holonomic = 3 };
/// What becomes of the vehicle of a lost agent: taken away, straight on, or waiting about where it is.
enum class OnAgentLoss : std::uint8_t { Remove = 1, Continue = 2, Hover = 3 };

/// A torsion limit that stands for none (per m).
inline constexpr double kUnlimitedTorsion_per_m = 10.0;

/// One UAV as the mission knows it.
struct VehicleSpec {
  AgentId id = 0;
  Pose start;
  Vec3 slot_offset_m = Vec3::Zero();  ///< place in the formation frame: x along the formation heading
  VehicleType type = VehicleType::ConstantSpeed;
  double speed_mps = 0.0;  ///< of a multirotor or holonomic the largest
  double max_curvature_per_m = 0.0;
  double radius_m = 0.0;                               ///< of the body: closer than the sum of two is a collision
  double safety_radius_m = 0.0;                        ///< R of Eq. 17: closer than the sum of two is a near miss
  double max_torsion_per_m = kUnlimitedTorsion_per_m;  ///< of planned paths in space (Eq. 12)
  double max_acceleration_mps2 = 0.0;                  ///< of a multirotor

  bool operator==(const VehicleSpec&) const = default;
};

/// A static obstacle or a no-fly zone.
struct Zone {
  std::variant<Cylinder, Box> shape;
  bool no_fly = false;

  bool operator==(const Zone&) const = default;
};

/// A place that something is announced to occupy for a while, such as an aircraft that takes off (papers/000, section
/// 2.3). It may come early_s before, or any time late; from from_s - early_s on the zone is unconfirmed, until the
/// world says that it is clear. Nobody may be in it while it is unconfirmed or occupied.
struct Announcement {
  std::variant<Cylinder, Box> shape;
  double from_s = 0.0;   ///< announced begin of the occupation, simulated time
  double to_s = 0.0;     ///< announced end
  double early_s = 0.0;  ///< how much earlier it may begin
  double clear_s = 0.0;  ///< before the zone is unconfirmed nobody enters any more: the time that leaving takes

  bool operator==(const Announcement&) const = default;
};

/// What a transit has instead of a formation (papers/004): unknown space to cross, each UAV to its goal.
struct TransitMission {
  Box area;                    ///< nobody flies outside; known to all, as the paper assumes
  std::vector<Vec3> goals_m;   ///< by vehicle, as in Mission::vehicles
  double goal_radius_m = 0.0;  ///< within which a UAV has arrived
  TransitOptions planner;
  RadioOptions radio;
  SensorOptions sensor;

  bool operator==(const TransitMission&) const = default;
};

/// The cells into which its area is divided.
[[nodiscard]] inline CellGrid grid_of(const TransitMission& transit) {
  return grid_over(transit.area, transit.planner.cell_m, transit.planner.cell_height_m);
}

struct Mission {
  std::string name;
  MissionKind kind = MissionKind::Rendezvous;
  std::uint64_t seed = 0;
  double length_unit_m = 1.0;  ///< the unit in which cost terms take lengths (1000 for a paper in kilometres)
  double step_s = 0.0;         ///< simulated time of one flight step
  Pose formation;              ///< pose of the formation centre at the rendezvous
  double arrival_radius_m = 0.0;
  std::vector<VehicleSpec> vehicles;  ///< by ascending id
  std::vector<Zone> zones;
  std::optional<Terrain> terrain;  ///< the ground; none: nothing is below
  RendezvousOptions planner;
  std::optional<TransitMission> transit;  ///< with kind Transit
  ControllerOptions controller;
  std::vector<Announcement> announced;

  bool operator==(const Mission&) const = default;
};

/// The vehicles' ids, in the mission's order: ascending.
[[nodiscard]] std::vector<AgentId> ids_of(const Mission& mission);

/// The spec of an agent's vehicle. @throws std::invalid_argument if the mission has no such vehicle.
[[nodiscard]] const VehicleSpec& vehicle_of(const Mission& mission, AgentId id);

/// Flight steps from one decision of a transit to the next. @pre mission.transit, decision_s a multiple of step_s
[[nodiscard]] std::uint32_t steps_per_decision(const Mission& mission);

/// Where a vehicle must arrive: its offset as part of a virtual structure, turned with the formation heading, and the
/// formation's own direction (papers/001, section 2.1).
[[nodiscard]] Pose slot_pose(const Mission& mission, const VehicleSpec& vehicle);

/// Hash of everything in the mission, the seed included: H0 of a run.
[[nodiscard]] std::uint64_t mission_hash(const Mission& mission);

}  // namespace skein
