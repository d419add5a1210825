#include "planner/core/geometry/braking.hpp"

#include <gtest/gtest.h>

#include "agent/controller/manoeuvre.hpp"
#include "planner/core/geometry/distance.hpp"
#include "planner/core/random/random_stream.hpp"
#include "tests/agent/controller/closed_loop.hpp"

namespace skein {
namespace {

constexpr Brakes kBrakes{4.0, 0.1};

TEST(Braking, ByHand) {
  // 1 m/s at 0.4 m/s a step: 1 -> 0.6 -> 0.2 -> 0 is 0.08 + 0.04 + 0.01 m
  EXPECT_EQ(braking_steps(kBrakes, 1.0), 3.0);
  EXPECT_NEAR(braking_distance_m(kBrakes, 1.0), 0.13, 1e-12);
  EXPECT_NEAR(braked_m(kBrakes, 1.0, 1.0), 0.08, 1e-12);
  EXPECT_NEAR(braked_m(kBrakes, 1.0, 2.0), 0.12, 1e-12);
  EXPECT_NEAR(braked_m(kBrakes, 1.0, 9.0), 0.13, 1e-12);
  EXPECT_NEAR(stopping_distance_m(kBrakes, 1.0), 0.23, 1e-12);
  EXPECT_NEAR(stopping_time_s(kBrakes, 1.0), 0.4, 1e-12);
  EXPECT_EQ(braking_distance_m(kBrakes, 0.0), 0.0);
}

TEST(Braking, WithoutInertiaIsAtOnce) {
  EXPECT_EQ(braking_distance_m({0.0, 0.1}, 10.0), 0.0);
  EXPECT_NEAR(stopping_time_s({0.0, 0.1}, 10.0), 0.1, 1e-15);
}

TEST(Braking, IsWhatTheWorldsMultirotorDoes) {
  const VehicleSpec spec = test::multirotor_spec(1);
  for (std::uint64_t n = 0; n < 2000; ++n) {
    RandomStream random(1, 0, Purpose::Test, n);
    const double speed_mps = random.uniform(0.0, 10.0);
    const Vec3 along = Vec3(random.normal(), random.normal(), random.normal()).normalized();
    VehicleState state{Vec3::Zero(), speed_mps * along};
    double steps = 0.0;
    for (; state.velocity_mps.norm() > 1e-9; ++steps) {
      ASSERT_NEAR(state.position_m.norm(), braked_m(kBrakes, speed_mps, steps), 1e-9);
      state = advance_multirotor(spec, state, Vec3::Zero(), 0.1).after;
    }
    ASSERT_EQ(steps, braking_steps(kBrakes, speed_mps));
    ASSERT_NEAR(state.position_m.norm(), braking_distance_m(kBrakes, speed_mps), 1e-9);
    ASSERT_GE(stopping_bound_m(kBrakes, speed_mps), stopping_distance_m(kBrakes, speed_mps));
    ASSERT_GE(braking_distance_m(kBrakes, speed_mps), speed_mps * speed_mps / 8.0 - 1e-12);
    ASSERT_LE(braking_distance_m(kBrakes, speed_mps), speed_mps * speed_mps / 8.0 + 0.04 / 8.0 + 1e-12);
  }
}

TEST(Manoeuvre, IsTheWayFlown) {
  const VehicleSpec spec = test::multirotor_spec(1);
  for (std::uint64_t n = 0; n < 2000; ++n) {
    RandomStream random(2, 0, Purpose::Test, n);
    const auto any = [&] { return Vec3(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-6, 6)); };
    VehicleState state{any(), any()};
    const Vec3 command_mps = any();
    const Vec3 v1_mps = after_step(kBrakes, spec.speed_mps, state.velocity_mps, command_mps);
    const Manoeuvre m = manoeuvre(kBrakes, state.position_m, state.velocity_mps, v1_mps);
    double way_m = 0.0;
    double steps = 0.0;
    for (; steps == 0.0 || state.velocity_mps.norm() > 1e-9; ++steps) {
      const VehicleStep step = advance_multirotor(spec, state, steps == 0.0 ? command_mps : Vec3(Vec3::Zero()), 0.1);
      for (const Vec3& point_m : step.motion.points_m) {
        const double off_m = steps == 0.0 ? point_to_segment(point_m, m.start_m, m.turn_m) - m.bow_m
                                          : point_to_segment(point_m, m.turn_m, m.end_m);
        ASSERT_LE(off_m, 1e-9);
      }
      way_m += step.motion.length_m;
      state = step.after;
    }
    ASSERT_EQ(steps, m.steps);
    ASSERT_NEAR((state.position_m - m.end_m).norm(), 0.0, 1e-9);
    ASSERT_GE(m.length_m, way_m - 1e-9);
  }
}

}  // namespace
}  // namespace skein
