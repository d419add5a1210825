// Small missions for the tests of the world: 10 m/s, steps of 1 s, so that a step is 10 m.
#pragma once

#include <utility>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein::test {

/// A vehicle of radius 1 m and safety radius 5 m that turns in a circle of 10 m at the tightest.
inline VehicleSpec vehicle(AgentId id, const Vec3& start_m, double heading_rad, const Vec3& slot_m) {
  VehicleSpec spec;
  spec.id = id;
  spec.start = {start_m, heading_rad, 0.0};
  spec.slot_offset_m = slot_m;
  spec.speed_mps = 10.0;
  spec.max_curvature_per_m = 0.1;
  spec.radius_m = 1.0;
  spec.safety_radius_m = 5.0;
  return spec;
}

/// The formation is at the origin and heads east, so that a slot is where its offset says.
inline Mission mission_of(std::vector<VehicleSpec> vehicles, std::vector<Zone> zones = {}) {
  Mission mission;
  mission.name = "small";
  mission.seed = 5;
  mission.step_s = 1.0;
  mission.arrival_radius_m = 1.0;
  mission.vehicles = std::move(vehicles);
  mission.zones = std::move(zones);
  return mission;
}

/// Vehicles 1 to `count` side by side, 100 m apart, each 25 m west of its slot and heading for it.
inline Mission abreast(AgentId count) {
  std::vector<VehicleSpec> vehicles;
  for (AgentId id = 1; id <= count; ++id) {
    const double y_m = 100.0 * id;
    vehicles.push_back(vehicle(id, {-25.0, y_m, 0.0}, 0.0, {0.0, y_m, 0.0}));
  }
  return mission_of(std::move(vehicles));
}

}  // namespace skein::test
