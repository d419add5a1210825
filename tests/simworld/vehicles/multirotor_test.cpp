// The multirotor against motions worked out by hand, and its limits over random commands.
#include "simworld/vehicles/multirotor.hpp"

#include <gtest/gtest.h>

#include "planner/core/random/random_stream.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

VehicleSpec hoverer() {
  VehicleSpec spec = test::vehicle(1, Vec3(3.0, 4.0, 5.0), 0.0, Vec3::Zero());
  spec.type = VehicleType::Multirotor;
  spec.speed_mps = 10.0;
  spec.max_acceleration_mps2 = 4.0;
  return spec;
}

TEST(Multirotor, StartsHoveringAndStaysWithoutACommand) {
  const VehicleState start = initial_state(hoverer());
  EXPECT_EQ(start.velocity_mps, Vec3::Zero());
  const VehicleStep step = advance_vehicle(hoverer(), start, Vec3::Zero(), 0.5);
  EXPECT_EQ(step.after, start);
  EXPECT_EQ(step.motion.length_m, 0.0);
  EXPECT_EQ(step.motion.curvature_per_m, 0.0);
}

TEST(Multirotor, AcceleratesAtItsLimitAndThenHoldsTheCommand) {
  VehicleState state = initial_state(hoverer());
  const Vec3 wanted(0.0, 3.0, 0.0);
  VehicleStep step = advance_vehicle(hoverer(), state, wanted, 0.5);
  EXPECT_EQ(step.after.velocity_mps, Vec3(0.0, 2.0, 0.0));
  EXPECT_EQ(step.after.position_m, Vec3(3.0, 4.5, 5.0));
  step = advance_vehicle(hoverer(), step.after, wanted, 0.5);
  EXPECT_EQ(step.after.velocity_mps, wanted);
  EXPECT_EQ(step.after.position_m, Vec3(3.0, 5.75, 5.0));
  step = advance_vehicle(hoverer(), step.after, wanted, 0.5);
  EXPECT_EQ(step.after.position_m, Vec3(3.0, 7.25, 5.0));
  EXPECT_DOUBLE_EQ(step.motion.length_m, 1.5);
}

TEST(Multirotor, ThousandsOfRandomStepsKeepBothLimits) {
  const VehicleSpec spec = hoverer();
  VehicleState state = initial_state(spec);
  RandomStream stream(1, 1, Purpose::Test, 7);
  for (int i = 0; i < 5000; ++i) {
    const double dt_s = stream.uniform(0.05, 1.0);
    const auto draw = [&] { return stream.uniform(-30.0, 30.0); };
    const VehicleStep step = advance_vehicle(spec, state, Vec3(draw(), draw(), draw()), dt_s);
    EXPECT_LE(step.after.velocity_mps.norm(), spec.speed_mps * (1.0 + 1e-12));
    EXPECT_LE((step.after.velocity_mps - state.velocity_mps).norm(), spec.max_acceleration_mps2 * dt_s * (1.0 + 1e-12));
    const Vec3 mean = 0.5 * (step.after.velocity_mps + state.velocity_mps);
    EXPECT_LT((step.after.position_m - state.position_m - dt_s * mean).norm(), 1e-9);
    EXPECT_EQ(step.motion.points_m.front(), state.position_m);
    state = step.after;
  }
}

}  // namespace
}  // namespace skein
