#include "simworld/scenario/random_movers.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "planner/core/random/random_stream.hpp"
#include "simworld/movers/appearance.hpp"
#include "simworld/movers/movers.hpp"

namespace skein::scenario {
namespace {

constexpr std::string_view kSection = "random_obstacles";
constexpr Keys kKeys[] = {"count",        "kind",   "speed_min_mps", "speed_max_mps", "radius_min_m",
                          "radius_max_m", "turn_s", "columns",       "clear_m",       "within"};
constexpr Keys kBox[] = {"x_min_m", "y_min_m", "x_max_m", "y_max_m", "z_min_m", "z_max_m"};
constexpr Keys kKinds[] = {"mixed", "walk", "line"};
constexpr Limits kSpeed{0, 1000, "m/s"};
constexpr int kTries = 10'000;
constexpr double kNeverTurns_s = 1e18;

struct Crowd {
  std::uint64_t count = 0;
  std::string kind;
  double speed_min_mps = 0.0;
  double speed_max_mps = 0.0;
  double radius_min_m = 0.0;
  double radius_max_m = 0.0;
  double turn_s = 0.0;
  double clear_m = 0.0;
  bool columns = false;
  Box within;
};

Crowd read_crowd(const MapReader& map, const std::optional<Box>& area, const Mission& mission) {
  Crowd crowd;
  crowd.count = map.whole("count", 0, kMaxAgents);
  crowd.kind = map.word("kind", kKinds, "mixed");
  crowd.speed_max_mps = map.number("speed_max_mps", kSpeed);
  crowd.speed_min_mps = map.number("speed_min_mps", kSpeed, 0.0);
  if (crowd.speed_max_mps < crowd.speed_min_mps) map.refuse("speed_max_mps", "at least speed_min_mps");
  crowd.radius_min_m = map.number("radius_min_m", kExtent);
  crowd.radius_max_m = map.number("radius_max_m", kExtent);
  if (crowd.radius_max_m < crowd.radius_min_m) map.refuse("radius_max_m", "at least radius_min_m");
  crowd.turn_s = map.number("turn_s", {1e-3, 1e6, "s"}, 5.0);
  crowd.within = map.find("within") == nullptr && area ? *area : read_box(map.map("within", kBox, true));
  const bool endless = crowd.within.max_m.z() - crowd.within.min_m.z() >= kUnboundedZ_m;
  crowd.columns = map.whole("columns", 0, 1, endless ? 1 : 0) == 1;
  if (endless && !crowd.columns) map.refuse("columns", "1, or a box with z_min_m and z_max_m");
  const VehicleSpec& vehicle = mission.vehicles.front();
  crowd.clear_m =
      map.number("clear_m", {0, 1e6, "m"}, least_appearance_m(vehicle, vehicle.speed_mps, 0.0, mission.step_s));
  return crowd;
}

Mover draw_one(const Crowd& crowd, RandomStream& stream) {
  Mover mover;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    mover.position_m[axis] = stream.uniform(crowd.within.min_m[axis], crowd.within.max_m[axis]);
  }
  if (crowd.columns) mover.position_m.z() = 0.0;
  mover.column = crowd.columns;
  mover.radius_m = stream.uniform(crowd.radius_min_m, crowd.radius_max_m);
  const double speed_mps = stream.uniform(crowd.speed_min_mps, crowd.speed_max_mps);
  const bool straight = stream.uniform() < 0.5 ? crowd.kind != "walk" : crowd.kind == "line";
  mover.motion = WalkMotion{speed_mps, straight ? kNeverTurns_s : crowd.turn_s, crowd.within};
  return mover;
}

/// Every start, and where it ends.
std::vector<Vec3> kept_free_m(const Mission& mission) {
  std::vector<Vec3> points_m;
  for (const VehicleSpec& vehicle : mission.vehicles) {
    points_m.push_back(vehicle.start.position_m);
    if (!mission.transit) points_m.push_back(slot_pose(mission, vehicle).position_m);
  }
  if (mission.transit) {
    points_m.insert(points_m.end(), mission.transit->goals_m.begin(), mission.transit->goals_m.end());
  }
  return points_m;
}

}  // namespace

std::vector<Mover> draw_movers(const MapReader& root, const std::optional<Box>& area, const Mission& mission) {
  const Crowd crowd = read_crowd(root.map(kSection, kKeys, true), area, mission);
  const std::vector<Vec3> free_m = kept_free_m(mission);
  const double body_m = mission.vehicles.front().radius_m;
  RandomStream stream(mission.seed, kWorldId, Purpose::Layout, 2);
  std::vector<Mover> movers;
  for (int n = 0; n < kTries && movers.size() < crowd.count; ++n) {
    Mover mover = draw_one(crowd, stream);
    const bool crowded = std::ranges::any_of(free_m, [&](const Vec3& point_m) {
      return distance_m(point_m, mover.position_m, mover.column) <= crowd.clear_m + body_m + mover.radius_m;
    });
    if (crowded) continue;
    mover.name = fmt::format("{}.{}", kSection, movers.size() + 1);
    movers.push_back(std::move(mover));
  }
  if (movers.size() == crowd.count) return movers;
  throw ReadFault(root.place_of(kSection),
                  fmt::format("{} finds no room for {} obstacles that are {} m clear of starts "
                              "and goals; allowed: fewer, a larger box, or less clear_m",
                              kSection, crowd.count, crowd.clear_m));
}

}  // namespace skein::scenario
