// Each reason for which a plan does not hold, on both sides of its limit.
#include "agent/behaviours/plan_check.hpp"

#include <gtest/gtest.h>

#include "planner/rendezvous/ph/hermite.hpp"

namespace skein {
namespace {

/// 100 m straight to the east, 20 m high.
FlightPath straight() {
  const rendezvous::ph::Hermite hermite({Vec2(0.0, 0.0), 0.0}, {Vec2(100.0, 0.0), 0.0});
  return {rendezvous::ph::JoinedPlanarPath(hermite.path({100.0, 100.0})), 20.0};
}

Track column(double x_m, double y_m, double radius_m) {
  Track track;
  track.id = 1;
  track.position_m = Vec3(x_m, y_m, 0.0);
  track.radius_m = radius_m;
  track.column = true;
  track.fixed = true;
  return track;
}

TEST(PlanCheck, AnObstacleBlocksFromItsRadiusAndTheDistanceToBeKept) {
  EXPECT_TRUE(blocks(straight(), 0.0, column(50.0, 4.9, 2.0), 3.0));
  EXPECT_FALSE(blocks(straight(), 0.0, column(50.0, 5.1, 2.0), 3.0));
}

TEST(PlanCheck, WhatLiesBehindOrBeyondBlocksNothing) {
  EXPECT_TRUE(blocks(straight(), 54.0, column(50.0, 0.0, 2.0), 3.0));
  EXPECT_FALSE(blocks(straight(), 56.0, column(50.0, 0.0, 2.0), 3.0));
  EXPECT_FALSE(blocks(straight(), 0.0, column(50.0, 0.0, 2.0), 3.0, 44.0));
  EXPECT_TRUE(blocks(straight(), 0.0, column(104.0, 0.0, 2.0), 3.0));
}

TEST(PlanCheck, ASphereBlocksOnlyAtItsHeight) {
  Track sphere = column(50.0, 0.0, 2.0);
  sphere.column = false;
  sphere.position_m.z() = 26.0;
  EXPECT_FALSE(blocks(straight(), 0.0, sphere, 3.0));
  sphere.position_m.z() = 24.0;
  EXPECT_TRUE(blocks(straight(), 0.0, sphere, 3.0));
}

TEST(SpeedWatch, FindsTheSpeedThatIsNotExceededThoughMoreIsCommanded) {
  SpeedWatch watch(0.1);
  for (int k = 0; k < 30; ++k) watch.note(0.4 * k, 10.0);
  EXPECT_FALSE(watch.limit_mps()) << "it speeds up";
  for (int k = 0; k < 30; ++k) watch.note(8.0, 10.0);
  ASSERT_TRUE(watch.limit_mps());
  EXPECT_DOUBLE_EQ(*watch.limit_mps(), 8.0);
  watch.note(9.5, 10.0);
  EXPECT_DOUBLE_EQ(*watch.limit_mps(), 9.5) << "it can do better after all";
}

TEST(SpeedWatch, WhoDoesWhatIsCommandedHasNoLimit) {
  SpeedWatch watch(0.1);
  for (int k = 0; k < 100; ++k) watch.note(5.0, 5.05);
  EXPECT_FALSE(watch.limit_mps());
}

Lateness behind(double deviation_m) {
  return {deviation_m, 10.0, 1.0, 30.0, false};
}

TEST(LateWatch, IsLateFarFromTheReferenceForAWhile) {
  LateWatch watch(0.1);
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(watch.note(behind(10.5 + 0.1 * k)));
  EXPECT_TRUE(watch.note(behind(11.0)));
}

TEST(LateWatch, WhoIsHeldOffOrCatchesUpInTimeIsNotLate) {
  LateWatch held(0.1);
  LateWatch catching(0.1);
  for (int k = 0; k < 50; ++k) {
    Lateness now = behind(12.0 + 0.1 * k);
    now.held_off = true;
    EXPECT_FALSE(held.note(now));
    EXPECT_FALSE(catching.note(behind(20.0 - 0.1 * k)));
  }
}

TEST(LateWatch, TwiceTheLimitIsTooFarWhateverHoldsItOff) {
  LateWatch watch(0.1);
  bool late = false;
  for (int k = 0; k < 10; ++k) {
    Lateness now = behind(20.1 + 0.1 * k);
    now.held_off = true;
    late = watch.note(now);
  }
  EXPECT_TRUE(late);
}

TEST(LateWatch, WhoCatchesUpTooSlowlyIsLate) {
  LateWatch watch(0.1);
  bool late = false;
  for (int k = 0; k < 10; ++k) {
    Lateness now = behind(9.0 - 0.01 * k);
    now.left_s = 1.0;
    late = watch.note(now);
  }
  EXPECT_TRUE(late);
}

}  // namespace
}  // namespace skein
