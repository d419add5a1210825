#include "simworld/scenario/surprise_sections.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "planner/core/random/random_stream.hpp"
#include "simworld/movers/movers.hpp"
#include "simworld/scenario/random_movers.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kMover[] = {"x_m",       "y_m",       "z_m",    "radius_m", "vx_mps", "vy_mps", "vz_mps",
                           "waypoints", "speed_mps", "turn_s", "within",   "at_s",   "near_m", "ahead"};
constexpr Keys kPoint[] = {"x_m", "y_m", "z_m"};
constexpr Keys kBox[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr Keys kAhead[] = {"agent", "distance_m", "at_s", "at_latest_s", "column", "crossing_mps"};
constexpr Keys kAnnounced[] = {"x_m",     "y_m",    "radius_m", "x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m",
                               "z_max_m", "from_s", "to_s",     "early_s", "late_s",  "clear_s", "aircraft"};
constexpr Keys kAircraft[] = {"radius_m", "from", "to"};

constexpr Limits kVelocity{-1000, 1000, "m/s"};
constexpr Limits kSpeed{0.01, 1000, "m/s"};
constexpr Limits kTime{0, 1e7, "s"};
constexpr std::size_t kMaxMovers = 256;    // as many tracks as a sense sample holds
constexpr std::size_t kMaxAnnounced = 64;  // as many states
constexpr std::size_t kMaxWaypoints = 256;

constexpr auto kControllerKeys = [] {
  std::array<Keys, kControllerFields.size()> keys{"name"};
  std::size_t next = 1;
  for (const auto& field : kControllerFields) {
    if (field.key != "sensor_range_m") keys[next++] = field.key;
  }
  return keys;
}();

MoverMotion read_loop(const MapReader& item, const Mover& mover) {
  LoopMotion loop{{mover.position_m}, item.number("speed_mps", kSpeed)};
  const auto points = item.list("waypoints", kMaxWaypoints, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const MapReader point = item.item("waypoints", i, kPoint);
    loop.waypoints_m.push_back(read_point(point));
    if (mover.column) loop.waypoints_m.back().z() = 0.0;
    if (loop.waypoints_m.back() == loop.waypoints_m[i]) point.refuse("x_m", "a place other than the one before");
  }
  if (points.empty()) item.refuse("waypoints", "1 to 256 places after that of the item");
  return loop;
}

/// Keys of other motions would mean nothing.
void refuse_others(const MapReader& item, std::initializer_list<Keys> own, Keys motion) {
  for (const Keys key : {"vx_mps", "vy_mps", "vz_mps", "waypoints", "speed_mps", "turn_s", "within"}) {
    if (item.find(key) == nullptr || std::ranges::find(own, key) != own.end()) continue;
    item.refuse(key, fmt::format("no such key of what {}", motion));
  }
}

MoverMotion read_motion(const MapReader& item, const Mover& mover, const std::optional<Box>& area) {
  if (mover.ahead && mover.ahead->crosses) {
    refuse_others(item, {}, "crosses");
    return LineMotion{Vec3(item.map("ahead", kAhead, true).number("crossing_mps", kSpeed), 0.0, 0.0)};
  }
  if (item.find("vx_mps") != nullptr) {
    refuse_others(item, {"vx_mps", "vy_mps", "vz_mps"}, "flies a line");
    const double vx_mps = item.number("vx_mps", kVelocity);
    const double vy_mps = item.number("vy_mps", kVelocity);
    return LineMotion{Vec3(vx_mps, vy_mps, mover.column ? 0.0 : item.number("vz_mps", kVelocity, 0.0))};
  }
  if (item.find("waypoints") != nullptr) {
    if (mover.ahead) item.refuse("waypoints", "no loop with ahead");
    refuse_others(item, {"waypoints", "speed_mps"}, "flies a loop");
    return read_loop(item, mover);
  }
  if (item.find("turn_s") == nullptr) {
    refuse_others(item, {}, "stands");
    return StillMotion{};
  }
  refuse_others(item, {"speed_mps", "turn_s", "within"}, "walks");
  WalkMotion walk{item.number("speed_mps", kSpeed), item.number("turn_s", {1e-3, 1e6, "s"}), {}};
  walk.within = item.find("within") == nullptr && area ? *area : read_box(item.map("within", kBox, true));
  return walk;
}

/// @param index of the mover: of the stream from which its moment is drawn
void read_ahead(const MapReader& item, const Mission& mission, std::size_t index, Mover& mover) {
  const MapReader map = item.map("ahead", kAhead, true);
  for (const Keys key : {"x_m", "y_m", "z_m", "at_s", "near_m"}) {
    if (item.find(key) != nullptr) item.refuse(key, "no such key beside ahead");
  }
  AheadOf ahead{static_cast<AgentId>(map.whole("agent", 0, kMaxAgents, 0)), map.number("distance_m", kExtent)};
  if (ahead.agent != 0 &&
      std::ranges::find(mission.vehicles, ahead.agent, &VehicleSpec::id) == mission.vehicles.end()) {
    map.refuse("agent", "the id of a vehicle, or 0: one that the seed draws");
  }
  ahead.crosses = map.find("crossing_mps") != nullptr;
  mover.ahead = ahead;
  mover.at_s = map.number("at_s", kTime);
  if (map.find("at_latest_s") != nullptr) {
    const double latest_s = map.number("at_latest_s", {mover.at_s, kTime.max, "s"});
    RandomStream stream(mission.seed, kWorldId, Purpose::Layout, 100 + index);
    mover.at_s = stream.uniform(mover.at_s, latest_s);
  }
  mover.column = map.whole("column", 0, 1, 0) == 1;
}

Mover read_mover(const MapReader& item, const std::optional<Box>& area, const Mission& mission, std::size_t index) {
  Mover mover;
  mover.radius_m = item.number("radius_m", kExtent);
  if (item.find("ahead") != nullptr) {
    read_ahead(item, mission, index, mover);
  } else {
    mover.position_m = read_point(item);
    mover.column = item.find("z_m") == nullptr;
    mover.at_s = item.number("at_s", kTime, 0.0);
    mover.near_m = item.number("near_m", {0, 1e6, "m"}, 0.0);
  }
  mover.sudden = mover.ahead || item.find("at_s") != nullptr || mover.near_m > 0.0;
  mover.motion = read_motion(item, mover, area);
  return mover;
}

/// What is there from the start stands or moves beside everybody.
void check_clear(const MapReader& item, const Mover& mover, const Mission& mission) {
  if (mover.sudden) return;
  for (const VehicleSpec& vehicle : mission.vehicles) {
    const double apart_m = distance_m(vehicle.start.position_m, mover.position_m, mover.column);
    const double least_m = vehicle.radius_m + mover.radius_m;
    if (apart_m > least_m) continue;
    item.refuse("x_m", fmt::format("more than {} m from the start of vehicle {}, their radii", least_m, vehicle.id));
  }
}

void read_movers(const MapReader& root, std::string_view list, const std::optional<Box>& area, Scenario& into) {
  const bool moving = list == "moving_obstacles";
  const auto items = root.list(list, kMaxMovers, false);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const MapReader item = root.item(list, i, kMover);
    Mover mover = read_mover(item, area, into.mission, into.world.surprises.movers.size());
    mover.name = fmt::format("{}.{}", list, i + 1);
    if (moving && std::holds_alternative<StillMotion>(mover.motion)) {
      throw ReadFault(place_of_item(items[i]), fmt::format("{} does not move; allowed: with vx_mps and vy_mps, with "
                                                           "waypoints, or with turn_s",
                                                           mover.name));
    }
    if (!moving && !mover.sudden) {
      throw ReadFault(place_of_item(items[i]),
                      fmt::format("{} is not sudden; allowed: with at_s, near_m or ahead", mover.name));
    }
    check_clear(item, mover, into.mission);
    into.world.surprises.movers.push_back(std::move(mover));
  }
}

Traffic read_traffic(const MapReader& item) {
  Traffic traffic;
  traffic.late_s = item.number("late_s", kTime, 0.0);
  if (item.find("aircraft") == nullptr) return traffic;
  const MapReader map = item.map("aircraft", kAircraft, true);
  Aircraft aircraft;
  aircraft.radius_m = map.number("radius_m", kExtent);
  aircraft.from_m = read_point(map.map("from", kPoint, true));
  aircraft.to_m = read_point(map.map("to", kPoint, true));
  traffic.aircraft = aircraft;
  return traffic;
}

void read_announced(const MapReader& root, Scenario& into) {
  const auto items = root.list("announced", kMaxAnnounced, false);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const MapReader item = root.item("announced", i, kAnnounced);
    Announcement announced;
    if (items[i].find("x_min_m") != nullptr) {
      announced.shape = read_box(item);
    } else {
      announced.shape = read_cylinder(item);
    }
    announced.from_s = item.number("from_s", kTime);
    announced.to_s = item.number("to_s", kTime);
    if (announced.to_s <= announced.from_s)
      item.refuse("to_s", fmt::format("more than from_s, {} s", announced.from_s));
    announced.early_s = item.number("early_s", kTime, 0.0);
    announced.clear_s = item.number("clear_s", kTime, 0.0);
    into.mission.announced.push_back(announced);
    into.world.surprises.traffic.push_back(read_traffic(item));
  }
}

/// Movers must be seen, and only some kinds of missions mind what moves.
void check_sensed(const MapReader& root, const Scenario& scenario) {
  const bool cells = scenario.mission.transit && scenario.mission.transit->planner.name != kStraight;
  for (const Keys key : {"moving_obstacles", "sudden_obstacles", "random_obstacles", "announced"}) {
    if (root.find(key) == nullptr) continue;
    if (cells) {
      throw ReadFault(root.place_of(key),
                      fmt::format("{} in a transit by cells; allowed: with planner.name {}", key, kStraight));
    }
    if (key == "announced" || scenario.mission.controller.sensor_range_m > 0.0) continue;
    throw ReadFault(root.place_of(key),
                    fmt::format("{} that nobody can see; allowed: with sensor.range_m of more than 0 m", key));
  }
}

void check_counts(const MapReader& root, const Scenario& scenario) {
  const Surprises& surprises = scenario.world.surprises;
  const auto flights =
      std::ranges::count_if(surprises.traffic, [](const Traffic& t) { return t.aircraft.has_value(); });
  const std::size_t count = surprises.movers.size() + static_cast<std::size_t>(flights);
  if (count > kMaxMovers) {
    throw ReadFault(root.place_of("random_obstacles"),
                    fmt::format("{} obstacles and aircraft move or appear; allowed: {}", count, kMaxMovers));
  }
  const std::vector<VehicleSpec>& vehicles = scenario.mission.vehicles;
  for (std::size_t i = 0; i < surprises.slow.size(); ++i) {
    if (std::ranges::find(vehicles, surprises.slow[i].id, &VehicleSpec::id) != vehicles.end()) continue;
    throw ReadFault(root.place_of("world"), fmt::format("world.slow.{} is of vehicle {}, which there is not; allowed: "
                                                        "the id of a vehicle",
                                                        i + 1, surprises.slow[i].id));
  }
}

}  // namespace

void read_controller(const MapReader& root, ControllerOptions& options) {
  const MapReader map = root.map("controller", kControllerKeys, false);
  options.name = map.word("name", kControllers, options.name);
  for (const auto& field : kControllerFields) {
    if (field.key == "sensor_range_m") continue;
    options.*field.member = map.number(field.key, {field.min, field.max, field.unit}, options.*field.member);
  }
  if (const auto fault = validate(options)) throw ReadFault(map.place_of(fault->key), "controller." + fault->message);
}

void read_surprises(const MapReader& root, const std::optional<Box>& area, Scenario& into) {
  check_sensed(root, into);
  read_movers(root, "moving_obstacles", area, into);
  read_movers(root, "sudden_obstacles", area, into);
  if (root.find("random_obstacles") != nullptr) {
    for (Mover& mover : draw_movers(root, area, into.mission)) into.world.surprises.movers.push_back(std::move(mover));
  }
  read_announced(root, into);
  check_counts(root, into);
}

}  // namespace skein::scenario
