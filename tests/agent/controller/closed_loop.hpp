// Point masses that fly under the controller among moving obstacles, to the step: the world without its process.
//
// Every UAV sees the obstacles whose surface is within the sensor's range, and hears the others within the radio's; all
// command at once, all move. Contact is continuous between steps. A UAV that stands still throughout the step in which
// an obstacle comes is rammed at rest; any other contact is a collision.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "agent/controller/apf.hpp"
#include "agent/controller/velocity_controller.hpp"
#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein::test {

enum class Moves { Straight, Loop, Walk };

/// A sphere, or a column, that moves at one speed: on and on between the area's borders, from waypoint to waypoint, or
/// with a turn now and then.
struct Obstacle {
  Track track;
  Moves moves = Moves::Straight;
  std::vector<Vec3> waypoints_m;
  std::size_t next = 0;
  double turn_probability = 0.0;  ///< a step
};

struct Flyer {
  VehicleSpec spec;
  Vec3 goal_m = Vec3::Zero();
  VehicleState state;
  double way_m = 0.0;
  double arrival_s = -1.0;  ///< none yet
  Steering last;
};

struct Tally {
  int collisions = 0;       ///< beginnings of contact with an obstacle, moving; steps in contact with a zone
  int peer_collisions = 0;  ///< beginnings of contact of two UAVs
  int rammed_at_rest = 0;
  int arrived = 0;
  int overruled = 0;  ///< steps of a UAV
  int braking = 0;
  int steps = 0;
  double least_m = std::numeric_limits<double>::infinity();  ///< between surfaces, to obstacles
  double least_peer_m = std::numeric_limits<double>::infinity();
};

struct Loop {
  ControllerOptions options;
  double step_s = 0.1;
  double peer_range_m = std::numeric_limits<double>::infinity();
  double arrival_m = 0.5;
  Vec3 low_m = Vec3::Zero();  ///< of the area in which obstacles stay
  Vec3 high_m = Vec3(100.0, 100.0, 0.0);
  std::uint64_t seed = 0;
  std::vector<Flyer> flyers;
  std::vector<Obstacle> obstacles;
  std::vector<ZoneShape> zones;  ///< known to all; to touch one counts as a collision

  /// Until all have arrived, or for so long.
  Tally run(double limit_s);

 private:
  void turn(std::size_t n, std::uint64_t step);
  [[nodiscard]] std::vector<Neighbour> neighbours_of(std::size_t n) const;
  [[nodiscard]] Steering command(std::size_t n) const;
  void check(std::size_t n, const Motion& motion, bool still, Tally& tally);

  std::vector<std::vector<bool>> touching_;
};

inline VehicleSpec multirotor_spec(AgentId id, double radius_m = 0.5, double speed_mps = 10.0) {
  VehicleSpec spec;
  spec.id = id;
  spec.type = VehicleType::Multirotor;
  spec.speed_mps = speed_mps;
  spec.max_acceleration_mps2 = 4.0;
  spec.radius_m = radius_m;
  return spec;
}

}  // namespace skein::test
