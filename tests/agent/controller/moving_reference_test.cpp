// The moving reference: its profile by hand, and a multirotor that keeps to it on a curved path.
#include "agent/controller/moving_reference.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/ph/hermite.hpp"
#include "simworld/vehicles/multirotor.hpp"

namespace skein {
namespace {

VehicleSpec hoverer() {
  VehicleSpec spec;
  spec.type = VehicleType::Multirotor;
  spec.speed_mps = 10.0;
  spec.max_acceleration_mps2 = 4.0;
  return spec;
}

TEST(MovingReference, SpeedsUpCruisesAndSlowsDown) {
  const MovingReference reference(hoverer(), 0.5);  // 2 m/s2: 5 s and 25 m to its speed
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 5.0), 25.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 10.0), 75.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 15.0), 125.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 18.0), 146.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 20.0), 150.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(150.0, 99.0), 150.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(32.0, 4.0), 16.0) << "too short for its speed: 8 m/s half way";
  EXPECT_DOUBLE_EQ(reference.travelled_m(32.0, 8.0), 32.0);
}

TEST(MovingReference, AMultirotorKeepsToItAndEndsAtRest) {
  const rendezvous::ph::Hermite hermite({Vec2(0.0, 0.0), 1.2}, {Vec2(400.0, 100.0), -0.8});
  const auto path = hermite.path({900.0, 700.0});
  MovingReference reference(hoverer(), 0.1);
  VehicleSpec spec = hoverer();
  VehicleState state = initial_state(spec);
  const auto position_at = [&](double s_m) {
    const Vec2 p = path.position_at(s_m);
    return Vec3(p.x(), p.y(), 0.0);
  };
  double worst_m = 0.0;
  bool flown = false;
  for (int k = 0; k < 2000 && !flown; ++k) {
    const Vec3 wanted = position_at(reference.travelled_m(path.length_m(), 0.1 * k));
    worst_m = std::max(worst_m, (state.position_m - wanted).norm());
    const MovingReference::Command command = reference.command(path.length_m(), position_at, state.position_m);
    flown = command.path_flown;
    state = advance_multirotor(spec, state, command.velocity_mps, 0.1).after;
  }
  EXPECT_TRUE(flown);
  EXPECT_LT(worst_m, 0.2);
  EXPECT_LT((state.position_m - Vec3(400.0, 100.0, 0.0)).norm(), 0.1);
  EXPECT_LT(state.velocity_mps.norm(), 0.2);
}

TEST(MovingReference, BrakesToRestAndDrawsBack) {
  MovingReference reference(hoverer(), 0.5, 0.9);  // 9 m/s, 2 m/s2
  const auto on_line = [](double s_m) { return Vec3(s_m, 0.0, 0.0); };
  for (int k = 0; k < 20; ++k) (void)reference.command(500.0, on_line, Vec3::Zero());
  const double from_m = reference.travelled_m(500.0, 10.0);
  EXPECT_DOUBLE_EQ(reference.speed_mps(500.0, 10.0), 9.0);
  reference.brake(500.0, 3.0);
  reference.brake(500.0, 1.0);  // too late
  EXPECT_DOUBLE_EQ(reference.travelled_m(500.0, 9.0), from_m - 9.0) << "what was is as it was";
  EXPECT_DOUBLE_EQ(reference.travelled_m(500.0, 11.0), from_m + 9.0 - 1.5);
  EXPECT_DOUBLE_EQ(reference.rest_m(), from_m + 13.5);
  EXPECT_DOUBLE_EQ(reference.rest_s(), 13.0);
  EXPECT_DOUBLE_EQ(reference.travelled_m(500.0, 20.0), from_m + 13.5);
  reference.draw_back(500.0, from_m + 20.0);
  EXPECT_DOUBLE_EQ(reference.rest_m(), from_m + 13.5) << "never ahead";
  reference.draw_back(500.0, from_m + 5.5);
  EXPECT_DOUBLE_EQ(reference.rest_m(), from_m + 5.5);
  EXPECT_DOUBLE_EQ(reference.rest_s(), 13.0 + 2.0 * 2.0) << "8 m from rest to rest with 2 m/s2";
  EXPECT_DOUBLE_EQ(reference.travelled_m(500.0, 15.0), from_m + 9.5);
  EXPECT_DOUBLE_EQ(reference.travelled_m(500.0, 30.0), from_m + 5.5);
}

TEST(MovingReference, AReserveOfSpeedCatchesUpWithoutOvershooting) {
  const VehicleSpec spec = hoverer();
  MovingReference reference(spec, 0.1, 0.9);
  const auto on_line = [](double s_m) { return Vec3(s_m, 0.0, 0.0); };
  VehicleState state = initial_state(spec);
  state.position_m.x() = -8.0;  // behind
  double ahead_m = -1e9;
  for (int k = 0; k < 600; ++k) {
    const double at_m = reference.travelled_m(300.0, 0.1 * k);
    ahead_m = std::max(ahead_m, state.position_m.x() - at_m);
    const auto command = reference.command(300.0, on_line, state.position_m);
    state = advance_multirotor(spec, state, command.velocity_mps, 0.1).after;
  }
  EXPECT_LT(ahead_m, 0.2);
  EXPECT_NEAR(state.position_m.x(), 300.0, 0.05);
}

}  // namespace
}  // namespace skein
