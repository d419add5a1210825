// Small transits for the tests of the world: a plane of 4 m cells, 80 m by 40 m, vehicles of 10 m/s, steps of 1 s.
#pragma once

#include "tests/simworld/missions.hpp"

namespace skein::test {

inline VehicleSpec crosser(AgentId id, const Vec3& start_m) {
  VehicleSpec spec;
  spec.id = id;
  spec.start.position_m = start_m;
  spec.type = VehicleType::Holonomic;
  spec.speed_mps = 10.0;
  spec.radius_m = 0.5;
  spec.safety_radius_m = 1.0;
  return spec;
}

/// Each vehicle with a goal of its own, reached within 2 m.
inline Mission transit_of(std::vector<VehicleSpec> vehicles, std::vector<Vec3> goals_m) {
  Mission mission = mission_of(std::move(vehicles));
  mission.kind = MissionKind::Transit;
  mission.transit.emplace();
  mission.transit->area = {Vec3(0, 0, 4), Vec3(80, 40, 8)};
  mission.transit->goals_m = std::move(goals_m);
  mission.transit->goal_radius_m = 2.0;
  return mission;
}

}  // namespace skein::test
