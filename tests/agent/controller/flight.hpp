// A vehicle of papers/001 (50 m/s, 2 per km, steps of 0.5 s) that flies a path under the path follower.
#pragma once

#include <algorithm>
#include <limits>

#include "agent/controller/path_follower.hpp"
#include "planner/core/geometry/frames.hpp"
#include "simworld/vehicles/constant_speed.hpp"

namespace skein::test {

inline constexpr double kStep_s = 0.5;

inline VehicleSpec paper_vehicle() {
  VehicleSpec spec;
  spec.id = 1;
  spec.speed_mps = 50.0;
  spec.max_curvature_per_m = 0.002;
  return spec;
}
inline const VehicleSpec kSpec = paper_vehicle();

struct Flown {
  int steps = 0;                     ///< until the follower said that the path is flown
  double end_error_m = 0.0;          ///< least distance of the flight from the path's end
  double settled_error_m = 0.0;      ///< largest distance from the path after the first 30 steps
  double max_curvature_per_m = 0.0;  ///< of the flight
};

/// Flies from `start` until the follower says that the path lies behind; 10000 steps at most.
inline Flown fly(const rendezvous::ph::JoinedPlanarPath& path, const Pose& start) {
  VehicleSpec spec = kSpec;
  spec.start = start;
  PathFollower follower(spec, kStep_s);
  VehicleState state = initial_state(spec);
  Flown flown;
  flown.end_error_m = std::numeric_limits<double>::infinity();
  const Vec2 end_m = path.position(1.0);
  double nearest_m = 0.0;
  for (bool over = false; !over && flown.steps < 10000; ++flown.steps) {
    const PathFollower::Command command = follower.command(path, pose_of(state));
    over = command.path_flown;
    const VehicleStep step = advance_constant_speed(spec, state, command.velocity_mps, kStep_s);
    for (std::size_t i = 1; i < kMotionPoints; ++i) {
      const Vec2 from_m = step.motion.points_m[i - 1].head<2>();
      const Vec2 along_m = step.motion.points_m[i].head<2>() - from_m;
      const double part = std::clamp((end_m - from_m).dot(along_m) / along_m.squaredNorm(), 0.0, 1.0);
      flown.end_error_m = std::min(flown.end_error_m, (from_m + part * along_m - end_m).norm());
    }
    const Vec2 here_m = state.position_m.head<2>();
    for (int i = 0; i < 4; ++i) {  // the nearest place of the path
      nearest_m += (here_m - path.position_at(nearest_m)).dot(direction_of_heading(path.heading_at(nearest_m)));
    }
    const double off_m = (path.position_at(nearest_m) - here_m).norm();
    if (flown.steps > 30 && !over) flown.settled_error_m = std::max(flown.settled_error_m, off_m);
    flown.max_curvature_per_m = std::max(flown.max_curvature_per_m, step.motion.curvature_per_m);
    state = step.after;
  }
  return flown;
}

}  // namespace skein::test
