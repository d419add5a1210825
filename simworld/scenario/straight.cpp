#include "simworld/scenario/straight.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "planner/core/geometry/distance.hpp"
#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/scenario/draw.hpp"
#include "simworld/scenario/spots.hpp"

namespace skein::scenario {
namespace {

constexpr Keys kSwap[] = {"agents", "radius_m", "x_m", "y_m", "z_m"};
constexpr int kTries = 10'000;
constexpr double kJitter = 0.01;  // of the radius
constexpr double kGolden = 0.61803398874989484820;

void add_vehicle(const VehicleSpec& common, AgentId id, const Vec3& start_m, Mission& mission) {
  VehicleSpec& vehicle = mission.vehicles.emplace_back(common);
  vehicle.id = id;
  vehicle.start.position_m = start_m;
}

void place_listed(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                  Places& places) {
  const Box& area = mission.transit->area;
  const double z_m = 0.5 * (area.min_m.z() + area.max_m.z());
  const Spots starts = read_spots(vehicles, "starts", z_m);
  const std::uint64_t agents = vehicles.whole("agents", 1, starts.size(), starts.size());
  for (const auto& [id, spot] : starts) {
    if (mission.vehicles.size() == agents) break;
    add_vehicle(common, id, spot.point_m, mission);
    places.starts.push_back(spot.place);
  }
  for (const Spot& goal : read_goals(root, mission.vehicles, z_m)) {
    mission.transit->goals_m.push_back(goal.point_m);
    places.slots.push_back(goal.place);
  }
}

bool is_free(const Mission& mission, const VehicleSpec& common, const Vec3& point_m) {
  return std::ranges::none_of(mission.zones, [&](const Zone& zone) {
    return std::visit([&](const auto& shape) { return signed_distance(point_m, shape); }, zone.shape) <=
           common.safety_radius_m;
  });
}

/// A point of the box that keeps its distances, or nothing. @param goal_m to be farther away from than the goal radius
std::optional<Vec3> draw_point(const Box& box, std::span<const Vec3> others_m, const Vec3* goal_m,
                               const VehicleSpec& common, const Mission& mission, RandomStream& stream) {
  for (int n = 0; n < kTries; ++n) {
    Vec3 point_m;
    for (Eigen::Index axis = 0; axis < 3; ++axis) point_m[axis] = stream.uniform(box.min_m[axis], box.max_m[axis]);
    const bool crowded = std::ranges::any_of(
        others_m, [&](const Vec3& other_m) { return (other_m - point_m).norm() <= 2.0 * common.safety_radius_m; });
    const bool there = goal_m != nullptr && (*goal_m - point_m).norm() <= mission.transit->goal_radius_m;
    if (!crowded && !there && is_free(mission, common, point_m)) return point_m;
  }
  return std::nullopt;
}

void place_drawn(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                 Places& places) {
  const auto agents = vehicles.whole("agents", 1, kMaxAgents);
  const Draw draw = read_draw(root, mission.transit->area, true);
  const MapReader map = root.map("draw", kDrawKeys, true);
  if (draw.connected) map.refuse("from", fmt::format("free, with planner.name {}", kStraight));
  const Place place = place_of_item(*root.find("draw"));
  RandomStream stream(mission.seed, kWorldId, Purpose::Layout, 1);
  std::vector<Vec3> starts_m;
  std::vector<Vec3>& goals_m = mission.transit->goals_m;
  const auto found = [&](const std::optional<Vec3>& point_m) {
    if (point_m) return *point_m;
    throw ReadFault(place, fmt::format("draw finds no starts and goals for {} vehicles; allowed: an area with enough "
                                       "room",
                                       agents));
  };
  for (std::uint64_t i = 0; i < agents; ++i) {
    const bool another = i == 0 || draw.own_goals;
    goals_m.push_back(another ? found(draw_point(draw.goals, goals_m, nullptr, common, mission, stream)) : goals_m[0]);
  }
  for (std::uint64_t i = 0; i < agents; ++i) {
    starts_m.push_back(found(draw_point(draw.starts, starts_m, &goals_m[i], common, mission, stream)));
    add_vehicle(common, static_cast<AgentId>(i + 1), starts_m.back(), mission);
  }
  places.starts.assign(agents, place);
  places.slots.assign(agents, place);
}

/// A turn about any axis, uniform (Shoemake 1992).
Eigen::Quaterniond drawn_turn(RandomStream& stream) {
  const double u = stream.uniform();
  const math::SinCos a = math::sincos(stream.uniform(0.0, math::kTwoPi));
  const math::SinCos b = math::sincos(stream.uniform(0.0, math::kTwoPi));
  return {std::sqrt(1.0 - u) * a.sin, std::sqrt(1.0 - u) * a.cos, std::sqrt(u) * b.sin, std::sqrt(u) * b.cos};
}

void place_swap(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                Places& places) {
  for (const Keys key : {"starts", "agents"}) {
    if (vehicles.find(key) != nullptr) vehicles.refuse(key, "no such key beside vehicles.swap");
  }
  for (const Keys key : {"goals", "draw"}) {
    if (root.find(key) != nullptr) root.refuse(key, "no such key beside vehicles.swap");
  }
  const MapReader swap = vehicles.map("swap", kSwap, true);
  const std::uint64_t agents = swap.whole("agents", 2, kMaxAgents);
  if (agents % 2 != 0) swap.refuse("agents", "an even number: pairs swap their places");
  const double radius_m = swap.number("radius_m", kExtent);
  const Vec3 centre_m = read_point(swap);
  RandomStream stream(mission.seed, kWorldId, Purpose::Layout, 3);
  const Eigen::Quaterniond turn = drawn_turn(stream);
  std::vector<Vec3> upper_m;
  for (std::uint64_t i = 0; i < agents / 2; ++i) {
    const double z = static_cast<double>(2 * i + 1) / static_cast<double>(agents);
    const math::SinCos angle = math::sincos(static_cast<double>(i) * kGolden * math::kPi);
    const double across = std::sqrt(1.0 - z * z);
    upper_m.push_back(radius_m * (turn * Vec3(across * angle.cos, across * angle.sin, z)));
  }
  for (std::uint64_t i = 0; i < agents; ++i) {
    const Vec3 offset_m = i < agents / 2 ? upper_m[i] : Vec3(-upper_m[i - agents / 2]);
    add_vehicle(common, static_cast<AgentId>(i + 1), centre_m + offset_m, mission);
    Vec3 jitter_m;
    for (Eigen::Index axis = 0; axis < 3; ++axis) jitter_m[axis] = stream.uniform(-kJitter, kJitter) * radius_m;
    mission.transit->goals_m.push_back(centre_m - offset_m + jitter_m);
  }
  const Place place = place_of_item(*vehicles.find("swap"));
  places.starts.assign(agents, place);
  places.slots = places.starts;
}

}  // namespace

void place_straight(const MapReader& root, const MapReader& vehicles, const VehicleSpec& common, Mission& mission,
                    Places& places) {
  if (vehicles.find("swap") != nullptr) {
    place_swap(root, vehicles, common, mission, places);
  } else if (root.find("draw") != nullptr) {
    place_drawn(root, vehicles, common, mission, places);
  } else {
    place_listed(root, vehicles, common, mission, places);
  }
}

}  // namespace skein::scenario
