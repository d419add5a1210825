// The mission of an attempt under way, and the heading by which who waits leaves.
#include "planner/rendezvous/replan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/planner.hpp"
#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

Track obstacle(std::uint32_t id, double x_m, double radius_m, bool column) {
  Track track;
  track.id = id;
  track.position_m = Vec3(x_m, 5.0, 30.0);
  track.radius_m = radius_m;
  track.column = column;
  track.fixed = true;
  return track;
}

Joiner joiner(AgentId agent, double speed_mps, std::vector<Track> obstacles) {
  Joiner result;
  result.agent = agent;
  result.revision.pose.position_m = Vec3(1000.0 * agent, 3000.0 * agent, 0.0);
  result.revision.pose.heading_rad = 0.1 * agent;
  result.revision.speed_mps = speed_mps;
  result.revision.obstacles = std::move(obstacles);
  return result;
}

TEST(Replan, TheMissionIsOfThoseThatJoinFromTheirPosesAtTheLeastSpeed) {
  const Mission mission = test::layout_a(7);
  const std::vector<Joiner> joiners{joiner(1, 50.0, {obstacle(4, 9.0, 3.0, true)}),
                                    joiner(3, 40.0, {obstacle(2, 8.0, 1.0, false), obstacle(4, 9.5, 3.0, true)})};
  const Mission next = revised(mission, joiners, 12);
  ASSERT_EQ(next.vehicles.size(), 2U);
  EXPECT_EQ(next.vehicles[0].id, 1U);
  EXPECT_EQ(next.vehicles[1].id, 3U);
  EXPECT_EQ(next.vehicles[1].start, joiners[1].revision.pose);
  EXPECT_EQ(next.vehicles[0].speed_mps, 40.0);
  EXPECT_EQ(next.vehicles[1].speed_mps, 40.0);
  EXPECT_NE(next.seed, mission.seed);
  EXPECT_NE(next.seed, revised(mission, joiners, 13).seed);
  ASSERT_EQ(next.zones.size(), mission.zones.size() + 2);
  const auto& sphere = std::get<Cylinder>(next.zones[mission.zones.size()].shape);
  EXPECT_EQ(sphere.z_min_m, 29.0);
  EXPECT_EQ(sphere.z_max_m, 31.0);
  const auto& column = std::get<Cylinder>(next.zones.back().shape);
  EXPECT_EQ(column.centre_m, Vec2(9.0, 5.0)) << "as the lowest agent that knows it says";
  EXPECT_EQ(column.z_max_m, kUnboundedZ_m);
  EXPECT_NO_THROW(Planner(next, 3));
}

TEST(Replan, WhoLeavesFromRestTakesAWayAroundWhatIsAhead) {
  Mission mission = test::open_field(1);
  const Vec3 place_m(25000.0, 15600.0, 0.0);
  const auto free = best_departure(mission, 3, place_m, {});
  ASSERT_TRUE(free);
  Track ahead;
  ahead.id = 1;
  ahead.position_m = Vec3(26500.0, 15600.0, 0.0);
  ahead.radius_m = 500.0;
  ahead.column = true;
  const auto around = best_departure(mission, 3, place_m, std::span(&ahead, 1));
  ASSERT_TRUE(around);
  EXPECT_NEAR(free->heading_rad, 0.0, 1e-9) << "straight to the slot";
  EXPECT_GT(std::fabs(around->heading_rad), 0.2);
  EXPECT_GT(around->length_m, free->length_m);
  const auto longer = best_departure(mission, 3, place_m, {}, 1.1 * free->length_m);
  ASSERT_TRUE(longer);
  EXPECT_GE(longer->length_m, 1.1 * free->length_m);
}

TEST(Replan, NobodyLeavesFromWithinAnObstacleOrFromItsSlot) {
  const Mission mission = test::open_field(1);
  Track on_it;
  on_it.position_m = Vec3(25000.0, 15600.0, 0.0);
  on_it.radius_m = 50.0;
  on_it.column = true;
  EXPECT_FALSE(best_departure(mission, 3, on_it.position_m, std::span(&on_it, 1)));
  EXPECT_FALSE(best_departure(mission, 3, slot_pose(mission, mission.vehicles[2]).position_m, {}));
}

TEST(Replan, WithoutAWayTheHeadingOfMostRoomNearestToTheSlotCounts) {
  const Mission mission = test::open_field(1);
  const Vec3 place_m(20000.0, 15600.0, 0.0);
  EXPECT_NEAR(clearest_heading(mission, 3, place_m, {}, 3000.0), 0.0, 0.05);
  Track wall;
  wall.position_m = Vec3(21500.0, 15600.0, 0.0);
  wall.radius_m = 1000.0;
  wall.column = true;
  const double heading_rad = clearest_heading(mission, 3, place_m, std::span(&wall, 1), 3000.0);
  EXPECT_GT(std::fabs(heading_rad), 0.6);
  EXPECT_LT(std::fabs(heading_rad), math::kPi / 2.0);
}

TEST(Replan, PlansKeepAReserveOfSeparationAsFarAsTheSlotsAllow) {
  Mission mission = test::open_field(1);
  EXPECT_DOUBLE_EQ(with_reserve(mission).vehicles[0].safety_radius_m, 125.0);
  for (VehicleSpec& vehicle : mission.vehicles) vehicle.safety_radius_m = 500.0;
  const Mission tight = with_reserve(mission);
  EXPECT_LT(tight.vehicles[0].safety_radius_m, 550.0);
  EXPECT_GE(tight.vehicles[0].safety_radius_m, 500.0);
}

}  // namespace
}  // namespace skein::rendezvous
