// The path follower in space: it steers in both planes, and in a level plane as the planar one does.
#include <gtest/gtest.h>

#include <algorithm>

#include "agent/controller/path_follower.hpp"
#include "planner/core/geometry/frames.hpp"
#include "planner/rendezvous/ph/spatial_hermite.hpp"
#include "simworld/vehicles/constant_speed.hpp"

namespace skein {
namespace {

constexpr double kStep_s = 0.5;

VehicleSpec paper_vehicle(const Pose& start) {
  VehicleSpec spec;
  spec.id = 1;
  spec.start = start;
  spec.speed_mps = 50.0;
  spec.max_curvature_per_m = 0.002;
  return spec;
}

struct Flown {
  double settled_error_m = 0.0;  ///< largest distance from the path after the first 30 steps
  double end_error_m = 1e9;      ///< least distance from the path's end
  int steps = 0;
};

template <typename Path>
Flown fly(const Path& path, const Pose& start, const Vec3& end_m) {
  const VehicleSpec spec = paper_vehicle(start);
  PathFollower follower(spec, kStep_s);
  VehicleState state = initial_state(spec);
  Flown flown;
  double nearest_m = 0.0;
  for (bool over = false; !over && flown.steps < 5000; ++flown.steps) {
    const PathFollower::Command command = follower.command(path, pose_of(state));
    over = command.path_flown;
    state = advance_constant_speed(spec, state, command.velocity_mps, kStep_s).after;
    nearest_m += 25.0;
    if constexpr (requires { path.direction(0.0); }) {
      for (int i = 0; i < 4; ++i) {
        const double q = path.parameter_at(nearest_m);
        nearest_m += (state.position_m - path.position(q)).dot(path.direction(q));
      }
      const double off_m = (path.position_at(nearest_m) - state.position_m).norm();
      if (flown.steps > 30 && nearest_m < path.length_m())
        flown.settled_error_m = std::max(flown.settled_error_m, off_m);
    }
    flown.end_error_m = std::min(flown.end_error_m, (state.position_m - end_m).norm());
  }
  return flown;
}

const Pose kStart{Vec3(2000.0, -5000.0, 2300.0), 0.52, 0.26};
const Pose kEnd{Vec3(20000.0, 6000.0, 3000.0), 0.35, 0.0};

TEST(SpatialFollower, StaysOnAPathThatClimbsAndTurns) {
  const rendezvous::ph::SpatialPath path = rendezvous::ph::SpatialHermite(kStart, kEnd).path({9000.0, 15000.0});
  const Flown flown = fly(path, kStart, kEnd.position_m);
  EXPECT_LT(flown.settled_error_m, 0.05);
  EXPECT_LT(flown.end_error_m, 25.0);
  EXPECT_NEAR(flown.steps, path.length_m() / 25.0, 2.0);
}

TEST(SpatialFollower, ReturnsFromAnOffsetInAnyDirection) {
  const rendezvous::ph::SpatialPath path = rendezvous::ph::SpatialHermite(kStart, kEnd).path({9000.0, 15000.0});
  for (const Vec3& offset_m : {Vec3(0, 0, 20), Vec3(0, 0, -20), Vec3(-10, 15, 0), Vec3(10, -15, 5)}) {
    Pose start = kStart;
    start.position_m += offset_m;
    EXPECT_LT(fly(path, start, kEnd.position_m).settled_error_m, 0.05) << offset_m.transpose();
  }
}

TEST(SpatialFollower, CommandsTheSpeedAndGoesStraightOnBeyondTheEnd) {
  const rendezvous::ph::SpatialPath path = rendezvous::ph::SpatialHermite(kStart, kEnd).path({9000.0, 15000.0});
  PathFollower follower(paper_vehicle(kStart), kStep_s);
  EXPECT_NEAR(follower.command(path, kStart).velocity_mps.norm(), 50.0, 1e-12);
  Pose beyond = kEnd;
  beyond.position_m += 100.0 * direction_of(kEnd);
  PathFollower late(paper_vehicle(kStart), kStep_s);
  for (int i = 0; i < 900; ++i) (void)late.command(path, beyond);
  const PathFollower::Command command = late.command(path, beyond);
  EXPECT_TRUE(command.path_flown);
  EXPECT_NEAR((command.velocity_mps - 50.0 * direction_of(kEnd)).norm(), 0.0, 1e-9);
}

TEST(SpatialFollower, OnALevelPathItSteersAsInThePlane) {
  Pose start = kStart;
  Pose end = kEnd;
  start.climb_rad = 0.0;
  end.position_m.z() = start.position_m.z();
  const rendezvous::ph::Controls m{9000.0, 15000.0};
  const auto flat = rendezvous::ph::Hermite({start.position_m.head<2>(), start.heading_rad},
                                            {end.position_m.head<2>(), end.heading_rad})
                        .path(m);
  const auto path = rendezvous::ph::SpatialHermite(start, end).path(m);
  PathFollower planar(paper_vehicle(start), kStep_s);
  PathFollower spatial(paper_vehicle(start), kStep_s);
  VehicleState state = initial_state(paper_vehicle(start));
  for (int i = 0; i < 800; ++i) {
    const Pose pose = pose_of(state);
    const Vec3 in_plane = planar.command(flat, pose).velocity_mps;
    EXPECT_NEAR((spatial.command(path, pose).velocity_mps - in_plane).norm(), 0.0, 1e-3) << "step " << i;
    state = advance_constant_speed(paper_vehicle(start), state, in_plane, kStep_s).after;
  }
}

}  // namespace
}  // namespace skein
