#include "simworld/scenario/sections.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "planner/core/options/rendezvous_options.hpp"
#include "simworld/scenario/reader.hpp"
#include "simworld/scenario/ring.hpp"

namespace skein::scenario {
namespace {

using Keys = std::string_view;
constexpr Keys kRoot[] = {"name",     "kind",      "seed",      "length_unit_m", "step_s",  "arrival_radius_m",
                          "vehicles", "formation", "obstacles", "no_fly",        "terrain", "planner",
                          "lockstep", "world"};
constexpr Keys kVehicles[] = {
    "type",   "speed_mps", "max_curvature_per_m",  "max_torsion_per_m", "radius_m", "safety_radius_m", "on_agent_loss",
    "starts", "ring",      "max_acceleration_mps2"};
constexpr Keys kStart[] = {"id", "x_m", "y_m", "z_m", "heading_rad", "climb_rad"};
constexpr Keys kFormation[] = {"x_m", "y_m", "z_m", "heading_rad", "slots"};
constexpr Keys kSlot[] = {"id", "x_m", "y_m", "z_m"};
constexpr Keys kCylinder[] = {"x_m", "y_m", "radius_m", "z_min_m", "z_max_m"};
constexpr Keys kBox[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr Keys kTerrain[] = {"a", "b", "c", "d", "e", "f", "g", "h", "l"};
constexpr Keys kLockstep[] = {"deadline_s"};
constexpr Keys kWorld[] = {"max_steps", "max_rounds"};

constexpr Limits kCoordinate{-1e7, 1e7, "m"};
constexpr Limits kHeight{-kUnboundedZ_m, kUnboundedZ_m, "m"};
constexpr Limits kClimb{-1.5707963267948966, 1.5707963267948966, "rad"};
constexpr Limits kHeading{-6.283185307179586, 6.283185307179586, "rad"};
constexpr Limits kExtent{1e-3, 1e6, "m"};
constexpr std::size_t kMaxZones = 256;  // of each list
constexpr std::uint64_t kMostSteps = 10'000'000;

constexpr auto kPlannerKeys = [] {
  std::array<Keys, kRendezvousFields.size() + 2> keys{"name"};
  for (std::size_t i = 0; i < kRendezvousFields.size(); ++i) keys[i + 1] = kRendezvousFields[i].key;
  keys.back() = "round_s";
  return keys;
}();

AgentId read_id(const MapReader& reader) {
  return static_cast<AgentId>(reader.whole("id", 1, kMaxAgents));
}

Vec3 read_point(const MapReader& reader) {
  const double x_m = reader.number("x_m", kCoordinate);
  const double y_m = reader.number("y_m", kCoordinate);
  return {x_m, y_m, reader.number("z_m", kHeight, 0.0)};
}

void read_head(const MapReader& root, Mission& mission) {
  static constexpr Keys kKinds[] = {"rendezvous"};
  mission.name = root.name("name");
  (void)root.word("kind", kKinds);
  mission.kind = MissionKind::Rendezvous;
  mission.seed = root.whole("seed", 0, std::numeric_limits<std::uint64_t>::max(), 0);
  mission.length_unit_m = root.number("length_unit_m", {1e-3, 1e6, "m"}, 1.0);
  mission.step_s = root.number("step_s", {1e-3, 60, "s"});
  mission.arrival_radius_m = root.number("arrival_radius_m", {1e-6, 1e5, "m"});
}

/// What is common to all vehicles, as a spec without id, start and slot.
VehicleSpec read_vehicle_type(const MapReader& vehicles, WorldOptions& world) {
  static constexpr Keys kTypes[] = {"constant_speed", "multirotor"};
  static constexpr Keys kLosses[] = {"remove", "hover", "continue"};
  VehicleSpec spec;
  const bool hovers = vehicles.word("type", kTypes) == "multirotor";
  spec.type = hovers ? VehicleType::Multirotor : VehicleType::ConstantSpeed;
  spec.speed_mps = vehicles.number("speed_mps", {0.01, 1000, "m/s"});
  spec.max_curvature_per_m = vehicles.number("max_curvature_per_m", {1e-6, 10, "per m"});
  spec.radius_m = vehicles.number("radius_m", {1e-3, 1000, "m"});
  spec.safety_radius_m = vehicles.number("safety_radius_m", {1e-3, 1e5, "m"});
  spec.max_torsion_per_m =
      vehicles.number("max_torsion_per_m", {1e-6, kUnlimitedTorsion_per_m, "per m"}, kUnlimitedTorsion_per_m);
  if (hovers) {
    spec.max_acceleration_mps2 = vehicles.number("max_acceleration_mps2", {1e-3, 1000, "m/s2"});
    const double needed = 2.0 * spec.speed_mps * spec.speed_mps * spec.max_curvature_per_m;
    if (spec.max_acceleration_mps2 < needed) {
      vehicles.refuse("max_acceleration_mps2",
                      fmt::format("at least twice what speed and curvature limit take together, "
                                  "{} m/s2",
                                  needed));
    }
  } else if (vehicles.find("max_acceleration_mps2") != nullptr) {
    vehicles.refuse("max_acceleration_mps2", "with type multirotor");
  }
  if (spec.safety_radius_m < spec.radius_m) {
    vehicles.refuse("safety_radius_m", fmt::format("at least vehicles.radius_m, {} m", spec.radius_m));
  }
  const std::string_view on_loss = vehicles.word("on_agent_loss", kLosses, "remove");
  world.on_agent_loss = on_loss == "remove"  ? OnAgentLoss::Remove
                        : on_loss == "hover" ? OnAgentLoss::Hover
                                             : OnAgentLoss::Continue;
  return spec;
}

struct Placed {
  VehicleSpec spec;
  Place start;
  Place slot;
  bool has_slot = false;
};

std::map<AgentId, Placed> read_starts(const MapReader& vehicles, const VehicleSpec& common) {
  std::map<AgentId, Placed> placed;
  const auto items = vehicles.list("starts", kMaxAgents, true);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const MapReader item = vehicles.item("starts", i, kStart);
    Placed vehicle{common, place_of_item(items[i]), {}};
    vehicle.spec.id = read_id(item);
    vehicle.spec.start.position_m = read_point(item);
    vehicle.spec.start.heading_rad = item.number("heading_rad", kHeading);
    vehicle.spec.start.climb_rad = item.number("climb_rad", kClimb, 0.0);
    if (!placed.emplace(vehicle.spec.id, vehicle).second) item.refuse("id", "an id that no other start has");
  }
  return placed;
}

void read_slots(const MapReader& formation, std::map<AgentId, Placed>& placed) {
  const auto items = formation.list("slots", kMaxAgents, true);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const MapReader item = formation.item("slots", i, kSlot);
    const auto found = placed.find(read_id(item));
    if (found == placed.end()) item.refuse("id", "the id of one of vehicles.starts");
    if (found->second.has_slot) item.refuse("id", "an id that no other slot has");
    found->second.spec.slot_offset_m = read_point(item);
    found->second.slot = place_of_item(items[i]);
    found->second.has_slot = true;
  }
  for (const auto& [id, vehicle] : placed) {
    if (vehicle.has_slot) continue;
    throw ReadFault(formation.place_of("slots"),
                    fmt::format("formation.slots has none for vehicle {}; allowed: one for each start", id));
  }
}

/// Vehicles with start and slot: on a ring, or one by one.
Places read_placed(const MapReader& vehicles, const MapReader& formation, const VehicleSpec& common, Mission& mission) {
  Places places;
  if (vehicles.find("ring") != nullptr) {
    for (const std::string_view key : {"starts", "slots"}) {
      const MapReader& map = key == "starts" ? vehicles : formation;
      if (map.find(key) != nullptr) map.refuse(key, "no such list beside vehicles.ring");
    }
    mission.vehicles = read_ring(vehicles, common, mission.formation);
    const Place place = place_of_item(*vehicles.find("ring"));
    places.starts.assign(mission.vehicles.size(), place);
    places.slots = places.starts;
    return places;
  }
  std::map<AgentId, Placed> placed = read_starts(vehicles, common);
  read_slots(formation, placed);
  for (const auto& [id, vehicle] : placed) {
    mission.vehicles.push_back(vehicle.spec);
    places.starts.push_back(vehicle.start);
    places.slots.push_back(vehicle.slot);
  }
  return places;
}

void read_heights(const MapReader& item, double& z_min_m, double& z_max_m) {
  z_min_m = item.number("z_min_m", kHeight, z_min_m);
  z_max_m = item.number("z_max_m", kHeight, z_max_m);
  if (z_max_m <= z_min_m) item.refuse("z_max_m", fmt::format("more than z_min_m, {} m", z_min_m));
}

Cylinder read_cylinder(const MapReader& item) {
  Cylinder cylinder;
  const double x_m = item.number("x_m", kCoordinate);
  cylinder.centre_m = Vec2(x_m, item.number("y_m", kCoordinate));
  cylinder.radius_m = item.number("radius_m", kExtent);
  read_heights(item, cylinder.z_min_m, cylinder.z_max_m);
  return cylinder;
}

Box read_box(const MapReader& item) {
  Box box;
  const double x_min_m = item.number("x_min_m", kCoordinate);
  box.min_m.head<2>() = Vec2(x_min_m, item.number("y_min_m", kCoordinate));
  const double x_max_m = item.number("x_max_m", kCoordinate);
  box.max_m.head<2>() = Vec2(x_max_m, item.number("y_max_m", kCoordinate));
  if (box.max_m.x() <= box.min_m.x()) item.refuse("x_max_m", fmt::format("more than x_min_m, {} m", box.min_m.x()));
  if (box.max_m.y() <= box.min_m.y()) item.refuse("y_max_m", fmt::format("more than y_min_m, {} m", box.min_m.y()));
  read_heights(item, box.min_m.z(), box.max_m.z());
  return box;
}

/// Obstacles are cylinders, or boxes if they have x_min_m; no-fly zones are boxes, or cylinders if they have radius_m.
void read_zones(const MapReader& root, std::string_view list, bool no_fly, std::vector<Zone>& zones) {
  const std::span<const YamlNode> items = root.list(list, kMaxZones, false);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool is_box = no_fly ? items[i].find("radius_m") == nullptr : items[i].find("x_min_m") != nullptr;
    const MapReader item = is_box ? root.item(list, i, kBox) : root.item(list, i, kCylinder);
    if (is_box) {
      zones.push_back({read_box(item), no_fly});
    } else {
      zones.push_back({read_cylinder(item), no_fly});
    }
  }
}

/// Eq. 13 with its lengths in the mission's length unit; nothing if the section is left out.
std::optional<Terrain> read_terrain(const MapReader& root, double length_unit_m) {
  if (root.find("terrain") == nullptr) return std::nullopt;
  constexpr Limits kConstant{-1000, 1000};
  const MapReader terrain = root.map("terrain", kTerrain, false);
  Terrain out;
  double Terrain::*members[] = {&Terrain::a, &Terrain::b, &Terrain::c, &Terrain::d, &Terrain::e,
                                &Terrain::f, &Terrain::g, &Terrain::h, &Terrain::l};
  for (std::size_t i = 0; i < std::size(members); ++i) out.*members[i] = terrain.number(kTerrain[i], kConstant, 0.0);
  out.unit_m = length_unit_m;
  return out;
}

void read_planner(const MapReader& planner, RendezvousOptions& options) {
  options = *defaults_of(planner.word("name", kRendezvousPlanners, options.name));
  for (const RendezvousField& field : kRendezvousFields) {
    if (const auto* real = std::get_if<double RendezvousOptions::*>(&field.member)) {
      options.** real = planner.number(field.key, {field.min, field.max, field.unit}, options.**real);
    } else {
      const auto member = std::get<std::int32_t RendezvousOptions::*>(field.member);
      options.*member = static_cast<std::int32_t>(planner.whole(field.key, static_cast<std::uint64_t>(field.min),
                                                                static_cast<std::uint64_t>(field.max),
                                                                static_cast<std::uint64_t>(options.*member)));
    }
  }
  if (const auto fault = validate(options)) throw ReadFault(planner.place_of(fault->key), "planner." + fault->message);
}

}  // namespace

Places read_sections(const YamlNode& root_node, Scenario& into) {
  const MapReader root(&root_node, "", kRoot, Place{});
  read_head(root, into.mission);
  const MapReader vehicles = root.map("vehicles", kVehicles, true);
  const MapReader formation = root.map("formation", kFormation, true);
  const MapReader lockstep = root.map("lockstep", kLockstep, false);
  const MapReader world = root.map("world", kWorld, false);

  const VehicleSpec common = read_vehicle_type(vehicles, into.world);
  Pose& pose = into.mission.formation;
  pose.position_m = read_point(formation);
  pose.heading_rad = formation.number("heading_rad", kHeading);
  Places places = read_placed(vehicles, formation, common, into.mission);
  read_zones(root, "obstacles", false, into.mission.zones);
  read_zones(root, "no_fly", true, into.mission.zones);
  into.mission.terrain = read_terrain(root, into.mission.length_unit_m);
  const MapReader planner = root.map("planner", kPlannerKeys, false);
  read_planner(planner, into.mission.planner);
  into.lockstep.round_s = planner.number("round_s", {1e-3, 60, "s"}, into.lockstep.round_s);
  into.lockstep.deadline_s = lockstep.number("deadline_s", {0.1, 3600, "s"}, into.lockstep.deadline_s);
  into.world.max_steps = static_cast<std::uint32_t>(world.whole("max_steps", 1, kMostSteps, into.world.max_steps));
  into.world.max_rounds = static_cast<std::uint32_t>(world.whole("max_rounds", 1, kMostSteps, into.world.max_rounds));
  return places;
}

}  // namespace skein::scenario
