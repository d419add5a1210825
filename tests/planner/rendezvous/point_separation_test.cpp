#include "planner/rendezvous/point_separation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

/// Straight ways: 1 from (0, 0) to (4, 0), 2 from (-3, 4) to (4, 4) km, headings along x. Their points of one number
/// are 3 km apart in x at the start and nothing at the end, always 4 km in y: least 4 km.
Mission two_straight_ways() {
  Mission mission = test::open_field(1);
  mission.vehicles.pop_back();
  mission.formation = {Vec3(4000.0, 0.0, 0.0), 0.0, 0.0};
  mission.vehicles[0].start = {Vec3::Zero(), 0.0, 0.0};
  mission.vehicles[0].slot_offset_m = Vec3::Zero();
  mission.vehicles[1].start = {Vec3(-3000.0, 4000.0, 0.0), 0.0, 0.0};
  mission.vehicles[1].slot_offset_m = Vec3(0.0, 4000.0, 0.0);
  return mission;
}

TEST(PointSeparation, OfStraightWaysByHand) {
  const std::vector<PlannedPath> paths{{1, {4000.0, 4000.0}}, {2, {7000.0, 7000.0}}};
  const auto separations = point_separations(two_straight_ways(), paths);
  ASSERT_EQ(separations.size(), 1U);
  EXPECT_EQ(separations[0].a, 1U);
  EXPECT_EQ(separations[0].b, 2U);
  EXPECT_NEAR(separations[0].least_m, 4000.0, 1e-6);
  EXPECT_NEAR(separations[0].required_m, 200.0, 1e-9);
}

TEST(PointSeparation, IsThatOfThePaperNotThatInFlight) {
  // At half of its way UAV 2 is at x = 0.5 km, UAV 1 at 2 km; in flight UAV 2 then has flown 3.5 km and UAV 1 as far.
  Mission mission = two_straight_ways();
  mission.planner.check_points = 3;
  mission.vehicles[1].slot_offset_m = Vec3(10000.0, 4000.0, 0.0);
  const std::vector<PlannedPath> paths{{1, {4000.0, 4000.0}}, {2, {17000.0, 17000.0}}};
  // Points: 0, 2, 4 km and -3, 5.5, 14 km: differences 3, 3.5, 10 km in x.
  EXPECT_NEAR(point_separations(mission, paths)[0].least_m, 5000.0, 1e-6);
}

TEST(PointSeparation, EveryPairInOrder) {
  const Mission mission = test::open_field(1);
  const std::vector<PlannedPath> paths{{1, {1e5, 1e5}}, {2, {1e5, 1e5}}, {3, {1e5, 1e5}}};
  const auto all = point_separations(mission, paths);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], point_separations(mission, std::span(paths).first(2))[0]);
  EXPECT_EQ(all[2], point_separations(mission, std::span(paths).last(2))[0]);
  EXPECT_EQ(all[1].a, 1U);
  EXPECT_EQ(all[1].b, 3U);
}

TEST(PointSeparation, RefusesWhatIsNoPlan) {
  const Mission mission = two_straight_ways();
  const std::vector<PlannedPath> short_one{{1, {4000.0}}};
  const std::vector<PlannedPath> stranger{{9, {4000.0, 4000.0}}};
  EXPECT_THROW((void)point_separations(mission, short_one), std::invalid_argument);
  EXPECT_THROW((void)point_separations(mission, stranger), std::invalid_argument);
  EXPECT_THROW((void)point_separations(Mission{}, short_one), std::invalid_argument);
}

}  // namespace
}  // namespace skein::rendezvous
