#include "groundstation/watch/planned_path.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/groundstation/watch/samples.hpp"

namespace skein::watch {
namespace {

TEST(PlannedPath, LeadsFromTheStartToTheSlot) {
  const std::array particle{10000.0, 10000.0};
  const std::vector<Vec3> line_m = planned_line(two_fly_east(), 2, particle, std::nullopt);
  ASSERT_GE(line_m.size(), 2U);
  EXPECT_NEAR((line_m.front() - Vec3(0.0, 500.0, 0.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((line_m.back() - Vec3(10000.0, 500.0, 0.0)).norm(), 0.0, 1e-6);
}

TEST(PlannedPath, OneMadeUnderWayStartsThere) {
  const std::array particle{8000.0, 8000.0};
  const Pose from{{2000.0, 900.0, 0.0}, 0.0, 0.0};
  const std::vector<Vec3> line_m = planned_line(two_fly_east(), 2, particle, from);
  ASSERT_GE(line_m.size(), 2U);
  EXPECT_NEAR((line_m.front() - from.position_m).norm(), 0.0, 1e-6);
}

TEST(PlannedPath, WhatIsNoPathIsEmpty) {
  const std::array odd{1.0, 2.0, 3.0};
  EXPECT_TRUE(planned_line(two_fly_east(), 1, odd, std::nullopt).empty());
  EXPECT_TRUE(planned_line(two_fly_east(), 9, std::array{1.0, 1.0}, std::nullopt).empty());
  EXPECT_TRUE(planned_line(two_fly_east(), 1, {}, std::nullopt).empty());
}

TEST(PlannedPath, WhatIsLeftIsMeasuredAlongTheLine) {
  const std::vector<Vec3> corner_m{{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}, {100.0, 50.0, 0.0}};
  EXPECT_DOUBLE_EQ(left_m(corner_m, {0.0, 0.0, 0.0}), 150.0);
  EXPECT_DOUBLE_EQ(left_m(corner_m, {60.0, -7.0, 0.0}), 90.0);
  EXPECT_DOUBLE_EQ(left_m(corner_m, {103.0, 20.0, 0.0}), 30.0);
  EXPECT_DOUBLE_EQ(left_m(corner_m, {200.0, 90.0, 0.0}), 0.0);
}

TEST(PlannedPath, AnIntentLeadsThroughItsNextCells) {
  Mission mission = two_fly_east();
  mission.transit = TransitMission{};
  mission.transit->area = Box{{0.0, 0.0, 0.0}, {40.0, 40.0, 4.0}};
  Intent intent;
  intent.to_m = {6.0, 2.0, 2.0};
  intent.next_cells = {2, 3, 13, 4000000};
  const std::vector<Vec3> line_m = intended_line(mission, intent, {2.0, 2.0, 2.0});
  ASSERT_EQ(line_m.size(), 5U);  // the last cell is none of the area
  EXPECT_EQ(line_m[2], Vec3(10.0, 2.0, 2.0));
  EXPECT_EQ(line_m[4], Vec3(14.0, 6.0, 2.0));
}

}  // namespace
}  // namespace skein::watch
