#include "simworld/scenario/sections.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "planner/core/options/rendezvous_options.hpp"
#include "simworld/scenario/common.hpp"
#include "simworld/scenario/reader.hpp"
#include "simworld/scenario/ring.hpp"
#include "simworld/scenario/surprise_sections.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kRoot[] = {"name",
                          "kind",
                          "seed",
                          "length_unit_m",
                          "step_s",
                          "arrival_radius_m",
                          "vehicles",
                          "formation",
                          "obstacles",
                          "no_fly",
                          "terrain",
                          "planner",
                          "lockstep",
                          "world",
                          "sensor",
                          "controller",
                          "moving_obstacles",
                          "sudden_obstacles",
                          "random_obstacles",
                          "announced"};
constexpr Keys kSensor[] = {"range_m"};
constexpr Keys kVehicles[] = {
    "type",   "speed_mps", "max_curvature_per_m",  "max_torsion_per_m", "radius_m", "safety_radius_m", "on_agent_loss",
    "starts", "ring",      "max_acceleration_mps2"};
constexpr Keys kStart[] = {"id", "x_m", "y_m", "z_m", "heading_rad", "climb_rad"};
constexpr Keys kFormation[] = {"x_m", "y_m", "z_m", "heading_rad", "slots"};
constexpr Keys kSlot[] = {"id", "x_m", "y_m", "z_m"};

constexpr Limits kClimb{-1.5707963267948966, 1.5707963267948966, "rad"};
constexpr Limits kHeading{-6.283185307179586, 6.283185307179586, "rad"};

constexpr auto kPlannerKeys = [] {
  std::array<Keys, kRendezvousFields.size() + 2> keys{"name"};
  for (std::size_t i = 0; i < kRendezvousFields.size(); ++i) keys[i + 1] = kRendezvousFields[i].key;
  keys.back() = "round_s";
  return keys;
}();

/// What is common to all vehicles, as a spec without id, start and slot.
VehicleSpec read_vehicle_type(const MapReader& vehicles, WorldOptions& world) {
  static constexpr Keys kTypes[] = {"constant_speed", "multirotor"};
  VehicleSpec spec;
  const bool hovers = vehicles.word("type", kTypes) == "multirotor";
  spec.type = hovers ? VehicleType::Multirotor : VehicleType::ConstantSpeed;
  spec.speed_mps = vehicles.number("speed_mps", {0.01, 1000, "m/s"});
  spec.max_curvature_per_m = vehicles.number("max_curvature_per_m", {1e-6, 10, "per m"});
  read_body(vehicles, spec);
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
  check_body(vehicles, spec);
  world.on_agent_loss = read_on_agent_loss(vehicles);
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

Places read_rendezvous(const YamlNode& root_node, std::optional<std::uint64_t> seed, Scenario& into) {
  const MapReader root(&root_node, "", kRoot, Place{});
  read_head(root, seed, into.mission);
  into.mission.length_unit_m = root.number("length_unit_m", {1e-3, 1e6, "m"}, 1.0);
  into.mission.arrival_radius_m = root.number("arrival_radius_m", {1e-6, 1e5, "m"});
  const MapReader vehicles = root.map("vehicles", kVehicles, true);
  const MapReader formation = root.map("formation", kFormation, true);
  const VehicleSpec common = read_vehicle_type(vehicles, into.world);
  Pose& pose = into.mission.formation;
  pose.position_m = read_point(formation);
  pose.heading_rad = formation.number("heading_rad", kHeading);
  Places places = read_placed(vehicles, formation, common, into.mission);
  read_zones(root, "obstacles", false, into.mission.zones);
  read_zones(root, "no_fly", true, into.mission.zones);
  if (root.find("terrain") != nullptr) {
    into.mission.terrain = read_terrain_map(root, "terrain", into.mission.length_unit_m);
  }
  const MapReader planner = root.map("planner", kPlannerKeys, false);
  read_planner(planner, into.mission.planner);
  into.lockstep.round_s = planner.number("round_s", {1e-3, 60, "s"}, into.lockstep.round_s);
  read_lockstep_and_world(root, into);
  read_controller(root, into.mission.controller);
  into.mission.controller.sensor_range_m = root.map("sensor", kSensor, false).number("range_m", {0, 1e6, "m"}, 0.0);
  read_surprises(root, std::nullopt, into);
  return places;
}

}  // namespace skein::scenario
