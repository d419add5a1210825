// What a velocity controller sees at the beginning of a step, and what it answers.
//
// All in the world frame, at one moment; what moves is taken to go on at its velocity. Source, Departs from source:
// none.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

/// A vehicle of the swarm, as it is heard.
struct Neighbour {
  AgentId id = 0;
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  double radius_m = 0.0;               ///< of the body
  double max_acceleration_mps2 = 0.0;  ///< with which it brakes
};

using ZoneShape = std::variant<Cylinder, Box>;

struct Scene {
  Vec3 position_m = Vec3::Zero();
  Vec3 velocity_mps = Vec3::Zero();
  std::span<const Neighbour> neighbours = {};  ///< by ascending id
  std::span<const Track> tracks = {};          ///< by ascending id
  std::span<const ZoneShape> zones = {};       ///< that must not be entered: obstacles, no-fly zones, closed zones
};

/// What a controller commands, and who had the say. That it flies no faster than its sensor carries is neither.
struct Steering {
  Vec3 velocity_mps = Vec3::Zero();  ///< to have at the end of the step
  bool repelled = false;             ///< something changed what the plan wants
  bool overruled = false;            ///< the safety filter changed what the controller wants
  bool braking = false;              ///< nothing but full braking was safe
};

/// The zones of a mission, as shapes.
[[nodiscard]] inline std::vector<ZoneShape> shapes_of(const Mission& mission) {
  std::vector<ZoneShape> shapes;
  for (const Zone& zone : mission.zones) shapes.push_back(zone.shape);
  return shapes;
}

}  // namespace skein
