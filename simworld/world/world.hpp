// The truth of a run: where every vehicle is, what it touched, when it arrived.
//
// A plain value advanced one flight step at a time from the commands of the live agents. Between steps every motion is
// checked continuously: separation of vehicles as closest approach of moving points, clearance from zones along the
// path flown. A vehicle arrives in the step in which it crosses its slot's plane (the plane through the slot, square to
// the formation's direction) within the arrival radius of the slot; one that can hover, at the end of a step within
// that radius. On a transit its goal is its slot, and it lands there: from then on it meets nobody. Obstacles that
// agents are not told of are the world's alone; it also holds the grid of cells that are really occupied, which sensors
// look at. Movers (simworld/movers) are the world's alone as well, and so is when an announced zone is really occupied;
// a body that a mover meets while the vehicle is at rest through the whole step is `Rammed`: no vehicle can help that.
// Source: papers/001, section 2.1 (arrival in formation) and Eq. 17 (separation); contacts are counted, not sampled;
// papers/004, section III-A; papers/000, section 2.3. Complexity of a step: O(V^2 + V Z) for V vehicles and Z zones,
// movers and hidden obstacles.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "planner/core/cells/cell_window.hpp"
#include "planner/core/lockstep/map_sample.hpp"
#include "planner/core/lockstep/orders.hpp"
#include "planner/core/mission/mission.hpp"
#include "simworld/collision/obstacle.hpp"
#include "simworld/movers/movers.hpp"
#include "simworld/movers/surprises.hpp"
#include "simworld/sensing/truth_grid.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein {

enum class VehicleStatus : std::uint8_t {
  Flying = 1,
  Arrived = 2,
  Missed = 3,       ///< its agent flew its path to the end, but not through the slot
  Removed = 4,      ///< its agent was lost, and the vehicle taken away
  Adrift = 5,       ///< its agent was lost, and the vehicle goes straight on
  Hovering = 6,     ///< its agent was lost, and the vehicle waits about where it is
  Rejoined = 7,     ///< its agent came back and flies it, without a plan so far
  Unreachable = 8,  ///< its agent says that no way leads to its goal
  Deadlock = 9,     ///< its agent says that it cannot get past the others
  Landed = 10,      ///< by command: it stands where it came down, and meets nobody
};

[[nodiscard]] std::string_view name_of(VehicleStatus status);

struct VehicleRecord {
  VehicleSpec spec;
  Pose slot;
  VehicleState state;
  VehicleStatus status = VehicleStatus::Flying;
  double flown_m = 0.0;
  double max_curvature_per_m = 0.0;
  double max_torsion_per_m = 0.0;  ///< turn of the plane of motion per way, while that plane is defined
  Vec3 turn = Vec3::Zero();        ///< of the step before: axis times angle (rad)
  std::uint32_t arrival_step = 0;  ///< 0: not arrived
  double arrival_time_s = 0.0;
  double heading_rad = 0.0;  ///< of its last motion; kept while it stands or climbs straight up
  bool landed = false;       ///< at the goal of a transit, or by command: it stands, and meets nobody
};

/// How close two vehicles came while both were in the air, by the centres, continuous between steps.
struct PairSeparation {
  AgentId a = 0;
  AgentId b = 0;
  std::optional<double> least_m;  ///< nothing if they never flew a step together
};

/// What one live agent commands for a step.
struct VehicleCommand {
  AgentId agent = 0;
  Vec3 velocity_mps = Vec3::Zero();
  bool path_flown = false;   ///< the agent says that its path is flown to the end
  bool landed = false;       ///< it says that it is down, by command
  bool off_mission = false;  ///< it flies by command
};

/// Rammed: by a mover, at rest. ZoneEntry: into an announced zone that is unconfirmed or occupied.
enum class ContactKind : std::uint8_t {
  Vehicles,
  VehicleObstacle,
  NearMiss,
  NoFly,
  Terrain,
  Hidden,
  Mover,
  Rammed,
  ZoneEntry
};

/// Way (m) of a step up to which a vehicle counts as at rest.
inline constexpr double kAtRest_m = 1e-6;

/// A stretch of steps in which two things were too close, counted once, at its first step.
struct Contact {
  ContactKind kind = ContactKind::Vehicles;
  std::uint32_t step = 0;
  AgentId vehicle = 0;
  std::uint32_t other = 0;  ///< the other vehicle's id, or the index of zone, hidden obstacle or mover; else 0
  double distance_m = 0.0;  ///< between centres, or from centre to the surface of zone or terrain
};

class World {
 public:
  /// @param hidden of a transit: the obstacles that agents are not told of
  /// @throws std::invalid_argument if the mission has no vehicles or a step is not positive.
  World(const Mission& mission, OnAgentLoss on_agent_loss, std::vector<Obstacle> hidden = {},
        const Surprises& surprises = {});

  /// The vehicle's agent is gone. Before the flight, and with OnAgentLoss::Remove, the vehicle is taken away.
  void lose_agent(AgentId id);
  /// The vehicle's agent came back: it takes over a vehicle that is adrift, and, where the swarm plans anew under way,
  /// one that hovers. Others stay as they are.
  void return_agent(AgentId id);
  /// The vehicle's agent flies a plan that was made under way: the vehicle is waited for (again).
  void take_up(AgentId id);

  /// Of a transit: the vehicle's agent has given up (Unreachable or Deadlock), or takes that back (Flying). It still
  /// obeys commands and is still in the way, and it arrives if it comes to its goal after all. Without effect on a
  /// vehicle that arrived or whose agent was lost.
  void note_given_up(AgentId id, NavStatus status);

  /// Flies step `step` (from 1). Commands by ascending id; a flying vehicle without one keeps its direction.
  void advance(std::uint32_t step, std::span<const VehicleCommand> commands);

  /// Puts an obstacle into the air, which no agent is told of: it is there from step `step` (from 1) on.
  void inject(const Injection& obstacle, std::uint32_t step);

  /// No vehicle with a live agent is still on its way.
  [[nodiscard]] bool all_ended() const;

  [[nodiscard]] const std::vector<VehicleRecord>& vehicles() const { return vehicles_; }
  [[nodiscard]] const VehicleRecord& vehicle(AgentId id) const;
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
  [[nodiscard]] std::size_t count(ContactKind kind) const;
  /// Least distance between the centres of two vehicles so far; nothing before two vehicles flew a step together.
  [[nodiscard]] std::optional<double> min_separation_m() const { return min_separation_m_; }
  /// Of every pair, by ascending ids.
  [[nodiscard]] std::vector<PairSeparation> separations() const;
  /// Least distance from a vehicle's body to an obstacle, no-fly zone or the terrain (a lower bound) so far; negative
  /// inside.
  [[nodiscard]] std::optional<double> min_clearance_m() const { return min_clearance_m_; }
  [[nodiscard]] const std::vector<Obstacle>& hidden() const { return hidden_; }
  /// Which cells are occupied; nothing if the mission is no transit by cells.
  [[nodiscard]] const TruthGrid* truth() const { return truth_ ? &*truth_ : nullptr; }
  /// What the vehicle's sensor sees as step `step` (from 1) opens; empty if it does not look then, landed or is gone.
  /// @pre truth() is there
  [[nodiscard]] CellWindow look_of(AgentId id, std::uint32_t step) const;
  /// The movers whose surface is within the range of the vehicle as the next step opens, by ascending id.
  [[nodiscard]] std::vector<Track> tracks_of(AgentId id, double range_m) const;
  /// Of every announced zone in step `step` (from 1), as in Mission::announced.
  [[nodiscard]] std::vector<ZoneState> zone_states(std::uint32_t step) const;
  /// The vehicle does what its agent commands.
  [[nodiscard]] bool obeys(AgentId id) const;
  [[nodiscard]] const std::vector<MoverRecord>& movers() const { return movers_.all(); }
  /// By vehicle, the shortest way from start to goal with full knowledge (simworld/sensing/shortest_paths.hpp); empty
  /// if the mission is no transit by cells.
  [[nodiscard]] std::vector<std::optional<double>> shortest_paths_m() const;
  void add_to(StateHash& hash) const;

 private:
  [[nodiscard]] std::size_t index_of(AgentId id) const;
  [[nodiscard]] bool in_the_air(std::size_t i) const;
  void move(std::size_t i, std::uint32_t step, const VehicleCommand* command);
  void note_arrival(std::size_t i, std::uint32_t step);
  void land();
  void set_down(std::size_t i);
  void check_vehicles(std::uint32_t step);
  void check_zones(std::uint32_t step);
  void check_hidden(std::uint32_t step);
  void check_terrain(std::uint32_t step);
  void check_movers(std::uint32_t step);
  void check_announced(std::uint32_t step);
  void prepare(const Mission& mission, const Surprises& surprises);
  [[nodiscard]] std::vector<Bystander> bystanders() const;
  /// The vehicle as it really is: some are slower than the mission says.
  [[nodiscard]] VehicleSpec real_spec(const VehicleRecord& vehicle, std::uint32_t step) const;
  void note(bool touching, std::vector<bool>& open, std::size_t key, const Contact& contact);

  double step_s_;
  double arrival_radius_m_;
  std::vector<Zone> zones_;
  std::optional<Terrain> terrain_;
  std::vector<Obstacle> hidden_;
  std::vector<Box> hidden_bounds_;
  std::optional<TransitMission> transit_;
  std::optional<TruthGrid> truth_;
  std::uint64_t seed_;
  OnAgentLoss on_agent_loss_;
  bool replans_;
  bool airborne_ = false;
  std::uint32_t injected_ = 0;
  std::vector<VehicleRecord> vehicles_;
  std::vector<Motion> motions_;
  Movers movers_;
  std::vector<SlowVehicle> slow_;
  std::vector<Announcement> announced_;
  std::vector<Occupation> occupations_;  ///< by announcement
  std::vector<Contact> contacts_;
  std::vector<bool> touching_;   ///< vehicle x vehicle: bodies in contact in the last step
  std::vector<bool> near_;       ///< vehicle x vehicle: safety spheres in contact in the last step
  std::vector<bool> in_zone_;    ///< vehicle x zone
  std::vector<bool> in_hidden_;  ///< vehicle x hidden obstacle
  std::vector<double> least_m_;  ///< vehicle x vehicle: least distance so far
  std::vector<bool> grounded_;   ///< vehicle: in contact with the terrain in the last step
  std::vector<bool> in_mover_;   ///< vehicle x mover, in motion
  std::vector<bool> rammed_;     ///< vehicle x mover, at rest
  std::vector<bool> in_closed_;  ///< vehicle x announced zone
  std::optional<double> min_separation_m_;
  std::optional<double> min_clearance_m_;
};

}  // namespace skein
