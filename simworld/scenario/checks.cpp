#include "simworld/scenario/checks.hpp"

#include <fmt/core.h>

#include <cmath>

#include "planner/core/geometry/distance.hpp"
#include "planner/core/geometry/frames.hpp"

namespace skein::scenario {
namespace {

/// What is checked the same way: the starts, then the slots in the world frame.
struct Spots {
  std::string_view what;
  std::vector<Vec3> at_m;
  const std::vector<Place>& places;
};

double distance_to(const Zone& zone, const Vec3& point_m) {
  return std::visit([&](const auto& shape) { return signed_distance(point_m, shape); }, zone.shape);
}

void check_separation(const Mission& mission, const Spots& spots) {
  for (std::size_t j = 0; j < spots.at_m.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const VehicleSpec& a = mission.vehicles[i];
      const VehicleSpec& b = mission.vehicles[j];
      const double apart_m = (spots.at_m[i] - spots.at_m[j]).norm();
      const double least_m = a.safety_radius_m + b.safety_radius_m;
      if (apart_m >= least_m) continue;
      const Place& place = spots.places[i].set_key.empty() ? spots.places[j] : spots.places[i];
      throw ReadFault(place, fmt::format("the {}s of vehicles {} and {} are {} m apart; allowed: at least {} m, their "
                                         "safety radii together",
                                         spots.what, a.id, b.id, apart_m, least_m));
    }
  }
}

void check_clearance(const Mission& mission, const Spots& spots) {
  for (std::size_t i = 0; i < spots.at_m.size(); ++i) {
    const VehicleSpec& vehicle = mission.vehicles[i];
    std::size_t obstacles = 0;
    std::size_t areas = 0;
    for (const Zone& zone : mission.zones) {
      const std::size_t number = zone.no_fly ? ++areas : ++obstacles;
      const double apart_m = distance_to(zone, spots.at_m[i]);
      if (apart_m > vehicle.radius_m) continue;
      throw ReadFault(spots.places[i],
                      fmt::format("the {} of vehicle {} is {} m {} {}.{}; allowed: more than {} m from it, its radius",
                                  spots.what, vehicle.id, std::fabs(apart_m), apart_m < 0.0 ? "inside" : "from",
                                  zone.no_fly ? "no_fly" : "obstacles", number, vehicle.radius_m));
    }
  }
}

void check_height(const Mission& mission, const Spots& spots) {
  const double tilt = tilt_of(*mission.terrain);
  for (std::size_t i = 0; i < spots.at_m.size(); ++i) {
    const VehicleSpec& vehicle = mission.vehicles[i];
    const double height_m = height_above_m(*mission.terrain, spots.at_m[i]);
    if (height_m > vehicle.radius_m * tilt) continue;
    throw ReadFault(spots.places[i], fmt::format("the {} of vehicle {} is {} m {} the terrain; allowed: more than {} m "
                                                 "above it, its radius on the steepest slope",
                                                 spots.what, vehicle.id, std::fabs(height_m),
                                                 height_m < 0.0 ? "below" : "above", vehicle.radius_m * tilt));
  }
}

/// Cosine above which two directions count as one: 0.1 milliradian.
constexpr double kSameDirection = 1.0 - 5e-9;

}  // namespace

std::vector<std::string> notes_of(const Mission& mission) {
  std::vector<std::string> notes;
  if (mission.transit) return notes;  // its vehicles have no slots
  for (const VehicleSpec& vehicle : mission.vehicles) {
    const Pose slot = slot_pose(mission, vehicle);
    const Vec3 along = (slot.position_m - vehicle.start.position_m).normalized();
    if (along.dot(direction_of(vehicle.start)) < kSameDirection || along.dot(direction_of(slot)) < kSameDirection) {
      continue;
    }
    notes.push_back(
        fmt::format("vehicle {} cannot change the length of its path: it starts and arrives along the "
                    "straight line; turn its start, or the formation",
                    vehicle.id));
  }
  return notes;
}

void check_mission(const Mission& mission, const Places& places) {
  Spots starts{"start", {}, places.starts};
  Spots slots{"slot", {}, places.slots};
  for (const VehicleSpec& vehicle : mission.vehicles) {
    starts.at_m.push_back(vehicle.start.position_m);
    slots.at_m.push_back(slot_pose(mission, vehicle).position_m);
  }
  check_separation(mission, starts);
  check_separation(mission, slots);
  check_clearance(mission, starts);
  check_clearance(mission, slots);
  if (mission.terrain) {
    check_height(mission, starts);
    check_height(mission, slots);
  }
  for (std::size_t i = 0; i < mission.vehicles.size(); ++i) {
    const double apart_m = (starts.at_m[i] - slots.at_m[i]).norm();
    if (apart_m > mission.arrival_radius_m) continue;
    throw ReadFault(places.starts[i],
                    fmt::format("vehicle {} starts {} m from its slot; allowed: more than arrival_radius_m, {} m",
                                mission.vehicles[i].id, apart_m, mission.arrival_radius_m));
  }
}

}  // namespace skein::scenario
