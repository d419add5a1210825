#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "planner/core/cells/cell_window.hpp"
#include "simworld/scenario/draw.hpp"
#include "simworld/scenario/hidden.hpp"
#include "simworld/scenario/sections.hpp"
#include "simworld/scenario/spots.hpp"
#include "simworld/scenario/straight.hpp"
#include "simworld/scenario/surprise_sections.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kRoot[] = {"name",
                          "kind",
                          "seed",
                          "step_s",
                          "goal_radius_m",
                          "vehicles",
                          "area",
                          "goals",
                          "obstacles",
                          "no_fly",
                          "hidden_obstacles",
                          "forest",
                          "draw",
                          "sensor",
                          "radio",
                          "planner",
                          "lockstep",
                          "world",
                          "controller",
                          "moving_obstacles",
                          "sudden_obstacles",
                          "random_obstacles",
                          "announced"};
constexpr Keys kVehicles[] = {"type",          "speed_mps", "radius_m", "safety_radius_m",
                              "on_agent_loss", "agents",    "starts",   "max_acceleration_mps2",
                              "swap"};
constexpr Keys kArea[] = {"x_min_m", "y_min_m", "z_min_m", "x_max_m", "y_max_m", "z_max_m"};

template <typename Options, std::size_t N, std::size_t M>
constexpr auto keys_of(const std::array<OptionField<Options>, N>& fields, const std::array<Keys, M>& more) {
  std::array<Keys, N + M> keys{};
  for (std::size_t i = 0; i < M; ++i) keys[i] = more[i];
  for (std::size_t i = 0; i < N; ++i) keys[M + i] = fields[i].key;
  return keys;
}
constexpr auto kPlannerKeys = keys_of(kTransitFields, std::array<Keys, 2>{"name", "round_s"});
constexpr auto kRadioKeys = keys_of(kRadioFields, std::array<Keys, 0>{});
constexpr auto kSensorKeys = keys_of(kSensorFields, std::array<Keys, 0>{});

Box read_area(const MapReader& root) {
  const MapReader map = root.map("area", kArea, true);
  for (const Keys key : {"z_min_m", "z_max_m"}) (void)map.number(key, kHeight);  // an area has all six
  return read_box(map);
}

/// Cells are flown by vehicles that stop at once; without cells they have inertia.
VehicleSpec read_vehicle_type(const MapReader& vehicles, bool straight, WorldOptions& world) {
  static constexpr Keys kByCells[] = {"holonomic"};
  static constexpr Keys kStraightOn[] = {"multirotor"};
  VehicleSpec spec;
  (void)vehicles.word("type", straight ? kStraightOn : kByCells);
  spec.type = straight ? VehicleType::Multirotor : VehicleType::Holonomic;
  spec.speed_mps = vehicles.number("speed_mps", {0.01, 1000, "m/s"});
  if (straight) {
    spec.max_acceleration_mps2 = vehicles.number("max_acceleration_mps2", {1e-3, 1000, "m/s2"});
  } else {
    for (const Keys key : {"max_acceleration_mps2", "swap"}) {
      if (vehicles.find(key) != nullptr) vehicles.refuse(key, fmt::format("with planner.name {}", kStraight));
    }
  }
  read_body(vehicles, spec);
  check_body(vehicles, spec);
  world.on_agent_loss = read_on_agent_loss(vehicles);
  return spec;
}

void read_options(const MapReader& root, TransitMission& transit, LockstepOptions& lockstep) {
  const MapReader planner = root.map("planner", kPlannerKeys, false);
  transit.planner = *transit_defaults_of(planner.word("name", kTransitPlanners, transit.planner.name));
  read_fields(planner, kTransitFields, transit.planner);
  lockstep.round_s = planner.number("round_s", {1e-3, 60, "s"}, lockstep.round_s);
  const MapReader radio = root.map("radio", kRadioKeys, false);
  read_fields(radio, kRadioFields, transit.radio);
  const MapReader sensor = root.map("sensor", kSensorKeys, false);
  read_fields(sensor, kSensorFields, transit.sensor);
  if (const auto fault = validate(transit.planner)) {
    throw ReadFault(planner.place_of(fault->key), "planner." + fault->message);
  }
  if (const auto fault = validate(transit.radio))
    throw ReadFault(radio.place_of(fault->key), "radio." + fault->message);
}

/// Vehicles and goals that the file gives, each moved to the centre of its cell.
void place_given(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                 Places& places) {
  TransitMission& transit = *mission.transit;
  const CellGrid grid = grid_of(*mission.transit);
  const double z_m = grid.centre_m({0, 0, 0}).z();
  const Spots starts = read_spots(vehicles, "starts", z_m);
  const std::uint64_t agents = vehicles.whole("agents", 1, starts.size(), starts.size());
  for (const auto& [id, spot] : starts) {
    if (mission.vehicles.size() == agents) break;
    mission.vehicles.push_back(common);
    mission.vehicles.back().id = id;
    mission.vehicles.back().start.position_m = grid.centre_m(grid.cell_of(spot.point_m));
    places.starts.push_back(spot.place);
  }
  for (const Spot& goal : read_goals(root, mission.vehicles, z_m)) {
    transit.goals_m.push_back(grid.centre_m(grid.cell_of(goal.point_m)));
    places.slots.push_back(goal.place);
  }
}

void place_drawn(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Scenario& into,
                 Places& places) {
  Mission& mission = into.mission;
  const bool listed = vehicles.find("starts") != nullptr;
  const std::size_t count = listed ? vehicles.list("starts", kMaxAgents, true).size() : kMaxAgents;
  const auto agents = static_cast<std::size_t>(
      vehicles.whole("agents", 1, kMaxAgents, listed ? std::optional<std::uint64_t>(count) : std::nullopt));
  const Draw draw = read_draw(root, mission.transit->area, has_own_goals(root));
  const Place place = place_of_item(*root.find("draw"));
  const TruthGrid truth(grid_of(*mission.transit), all_obstacles(mission, into.world.hidden));
  const Drawn drawn = draw_places(draw, truth, agents, common, mission.transit->goal_radius_m, mission.seed, place);
  for (std::size_t i = 0; i < agents; ++i) {
    mission.vehicles.push_back(common);
    mission.vehicles.back().id = static_cast<AgentId>(i + 1);
    mission.vehicles.back().start.position_m = drawn.starts_m[i];
  }
  mission.transit->goals_m = drawn.goals_m;
  places.starts.assign(agents, place);
  places.slots.assign(agents, place);
}

/// The cells in which a forest grows no tree: those of given starts and goals.
std::vector<Box> clearings(const Mission& mission) {
  const CellGrid grid = grid_of(*mission.transit);
  std::vector<Box> boxes;
  for (const VehicleSpec& vehicle : mission.vehicles)
    boxes.push_back(grid.box_of(grid.cell_of(vehicle.start.position_m)));
  for (const Vec3& goal_m : mission.transit->goals_m) boxes.push_back(grid.box_of(grid.cell_of(goal_m)));
  return boxes;
}

/// Nothing can be divided into cells that does not hold one, and nobody searches millions of them.
void check_grid(const MapReader& root, const TransitMission& transit) {
  constexpr double kMaxCells = 1e6;
  const Vec3 size_m = transit.area.max_m - transit.area.min_m;
  const TransitOptions& cells = transit.planner;
  if (size_m.head<2>().minCoeff() < cells.cell_m || size_m.z() < cells.cell_height_m) {
    throw ReadFault(root.place_of("area"), fmt::format("area is smaller than a cell; allowed: at least planner.cell_m, "
                                                       "{} m, by planner.cell_height_m, {} m",
                                                       cells.cell_m, cells.cell_height_m));
  }
  const double count = size_m.x() * size_m.y() / (cells.cell_m * cells.cell_m) * (size_m.z() / cells.cell_height_m);
  if (count > kMaxCells) {
    throw ReadFault(root.place_of("area"),
                    fmt::format("area has {:.0f} cells; allowed: at most {:.0f}", count, kMaxCells));
  }
  const auto seen = [&](double width_m, double edge_m) {
    return std::min(width_m, 2.0 * transit.sensor.range_m + edge_m) / edge_m + 1.0;
  };
  const double sight =
      seen(size_m.x(), cells.cell_m) * seen(size_m.y(), cells.cell_m) * seen(size_m.z(), cells.cell_height_m);
  if (sight > 4.0 * kMaxSightBytes) {
    throw ReadFault(root.map("sensor", kSensorKeys, false).place_of("range_m"),
                    fmt::format("sensor.range_m reaches {:.0f} cells; allowed: at most {:.0f}, at 2 bits a cell", sight,
                                4.0 * kMaxSightBytes));
  }
}

void read_hidden_parts(const MapReader& root, Scenario& into, std::optional<Forest>& forest) {
  const std::size_t cut = into.path.rfind('/');
  into.world.hidden = read_hidden(root, cut == std::string::npos ? "" : into.path.substr(0, cut + 1));
  forest = read_forest(root, into.mission.transit->area);
  if (into.mission.transit->planner.name != kStraight) return;
  for (const Keys key : {"hidden_obstacles", "forest"}) {
    if (root.find(key) == nullptr) continue;
    throw ReadFault(root.place_of(key), fmt::format("{} with planner.name {}, which has no map; allowed: "
                                                    "sudden_obstacles",
                                                    key, kStraight));
  }
}

/// Vehicles with starts and goals; a forest grows between those that are given.
void place_all(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common,
               const std::optional<Forest>& forest, Scenario& into, Places& places) {
  Mission& mission = into.mission;
  const bool drawn = root.find("draw") != nullptr;
  if (!drawn) place_given(root, vehicles, common, mission, places);
  if (forest) {
    const std::vector<Obstacle> trees = grow(*forest, mission.transit->area, clearings(mission), mission.seed);
    into.world.hidden.insert(into.world.hidden.end(), trees.begin(), trees.end());
  }
  if (drawn) place_drawn(root, vehicles, common, into, places);
}

/// What is no cell of a map is sensed where something moves, and by who has no map.
void set_sensor(const MapReader& root, Mission& mission) {
  const bool moves =
      std::ranges::any_of(std::array<Keys, 3>{"moving_obstacles", "sudden_obstacles", "random_obstacles"},
                          [&](Keys key) { return root.find(key) != nullptr; });
  if (moves || mission.transit->planner.name == kStraight) {
    mission.controller.sensor_range_m = mission.transit->sensor.range_m;
  }
}

}  // namespace

Places read_transit(const YamlNode& root_node, std::optional<std::uint64_t> seed, Scenario& into) {
  const MapReader root(&root_node, "", kRoot, Place{});
  Mission& mission = into.mission;
  read_head(root, seed, mission);
  TransitMission& transit = mission.transit.emplace();
  transit.goal_radius_m = root.number("goal_radius_m", {1e-3, 1e5, "m"});
  mission.arrival_radius_m = transit.goal_radius_m;
  const MapReader vehicles = root.map("vehicles", kVehicles, true);
  transit.area = read_area(root);
  read_options(root, transit, into.lockstep);
  const bool straight = transit.planner.name == kStraight;
  const VehicleSpec common = read_vehicle_type(vehicles, straight, into.world);
  if (!straight) check_grid(root, transit);
  read_zones(root, "obstacles", false, mission.zones);
  read_zones(root, "no_fly", true, mission.zones);
  std::optional<Forest> forest;
  read_hidden_parts(root, into, forest);
  read_lockstep_and_world(root, into);
  Places places;
  const MapReader planner = root.map("planner", kPlannerKeys, false);
  places.cells = planner.place_of("cell_m");
  places.decision = planner.place_of("decision_s");
  if (straight) {
    place_straight(root, vehicles, common, mission, places);
  } else {
    place_all(root, vehicles, common, forest, into, places);
  }
  read_controller(root, mission.controller);
  set_sensor(root, mission);
  read_surprises(root, transit.area, into);
  return places;
}

}  // namespace skein::scenario
