// The world of a transit: holonomic motion, landing, hidden obstacles, agents that give up, looks and shortest ways.
#include <gtest/gtest.h>

#include "simworld/world/world.hpp"
#include "tests/simworld/transits.hpp"

namespace skein::test {
namespace {

const Vec3 kWest(6, 18, 6);
const Vec3 kEast(74, 18, 6);

VehicleCommand fly(AgentId id, const Vec3& velocity_mps) {
  return {id, velocity_mps, false};
}

void advance(World& world, std::uint32_t step, const std::vector<VehicleCommand>& commands) {
  world.advance(step, commands);
}

TEST(TransitWorld, FliesTheCommandAtOnceAndClipsItsSpeed) {
  World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove);
  EXPECT_EQ(world.vehicle(1).state.velocity_mps, Vec3::Zero());
  advance(world, 1, {fly(1, Vec3(3, -4, 0))});
  EXPECT_EQ(world.vehicle(1).state.position_m, Vec3(9, 14, 6));
  advance(world, 2, {fly(1, Vec3(0, 30, 0))});
  EXPECT_EQ(world.vehicle(1).state.position_m, Vec3(9, 24, 6));
  EXPECT_DOUBLE_EQ(world.vehicle(1).flown_m, 15.0);
  advance(world, 3, {fly(1, Vec3::Zero())});
  EXPECT_EQ(world.vehicle(1).state.position_m, Vec3(9, 24, 6));
  EXPECT_DOUBLE_EQ(world.vehicle(1).heading_rad, 1.5707963267948966) << "of its last motion";
}

TEST(TransitWorld, LandsWithinTheGoalRadiusAndMeetsNobodyThen) {
  World world(transit_of({crosser(1, kWest), crosser(2, Vec3(6, 30, 6))}, {Vec3(18, 18, 6), Vec3(18, 18, 6)}),
              OnAgentLoss::Remove);
  advance(world, 1, {fly(1, Vec3(9.9, 0, 0)), fly(2, Vec3::Zero())});
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Flying) << "2.1 m away";
  advance(world, 2, {fly(1, Vec3(0.1, 0, 0)), fly(2, Vec3(10, 0, 0))});
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Arrived);
  EXPECT_TRUE(world.vehicle(1).landed);
  EXPECT_EQ(world.vehicle(1).arrival_step, 2U);
  EXPECT_EQ(world.vehicle(1).state.velocity_mps, Vec3::Zero());
  const std::optional<double> before_m = world.min_separation_m();
  advance(world, 3, {fly(1, Vec3(10, 0, 0)), fly(2, Vec3(0, -10, 0))});
  EXPECT_EQ(world.vehicle(1).state.position_m, Vec3(16, 18, 6)) << "who landed obeys nobody";
  EXPECT_EQ(world.min_separation_m(), before_m);
  advance(world, 4, {fly(1, Vec3::Zero()), fly(2, Vec3(0, -2, 0))});
  EXPECT_TRUE(world.all_ended());
  EXPECT_TRUE(world.contacts().empty());
}

TEST(TransitWorld, TheStepOfTheArrivalIsCheckedLikeAnyOther) {
  World world(transit_of({crosser(1, kWest), crosser(2, Vec3(16, 18, 6))}, {Vec3(16, 18, 6), kEast}),
              OnAgentLoss::Remove);
  advance(world, 1, {fly(1, Vec3(10, 0, 0)), fly(2, Vec3::Zero())});
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Arrived);
  EXPECT_EQ(world.count(ContactKind::Vehicles), 1U);
}

TEST(TransitWorld, AHiddenObstacleIsHitBetweenTheEndsOfAStep) {
  const std::vector<Obstacle> hidden{{Cylinder{Vec2(50, 30), 3.0}, "hidden_obstacles.1"},
                                     {Cylinder{Vec2(11, 18.6), 0.2}, "hidden_obstacles.2"}};
  World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove, hidden);
  advance(world, 1, {fly(1, Vec3(10, 0, 0))});
  ASSERT_EQ(world.contacts().size(), 1U);
  EXPECT_EQ(world.contacts()[0].kind, ContactKind::Hidden);
  EXPECT_EQ(world.hidden()[world.contacts()[0].other].name, "hidden_obstacles.2");
  EXPECT_NEAR(world.contacts()[0].distance_m, 0.4, 1e-12);
  EXPECT_NEAR(*world.min_clearance_m(), -0.1, 1e-12);
}

TEST(TransitWorld, TheLeastClearanceIsThatOfTheNearestShape) {
  const std::vector<Obstacle> hidden{{Box{Vec3(30, 0, 0), Vec3(34, 4, 9)}, "a"},
                                     {Sphere{Vec3(20, 22, 6), 2.0}, "b"},
                                     {Cylinder{Vec2(70, 38), 1.0}, "c"}};
  World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove, hidden);
  advance(world, 1, {fly(1, Vec3(10, 0, 0))});
  EXPECT_NEAR(*world.min_clearance_m(), std::sqrt(32.0) - 2.5, 1e-12);
  advance(world, 2, {fly(1, Vec3(10, 0, 0))});
  EXPECT_NEAR(*world.min_clearance_m(), 1.5, 1e-12);
}

TEST(TransitWorld, WhoGivesUpEndsTheRunUnlessItArrives) {
  World world(transit_of({crosser(1, kWest), crosser(2, Vec3(6, 30, 6))}, {kEast, Vec3(14, 30, 6)}),
              OnAgentLoss::Remove);
  world.note_given_up(1, NavStatus::Unreachable);
  world.note_given_up(2, NavStatus::Deadlock);
  EXPECT_TRUE(world.all_ended());
  EXPECT_EQ(name_of(world.vehicle(1).status), "unreachable");
  EXPECT_EQ(name_of(world.vehicle(2).status), "deadlock");
  world.note_given_up(1, NavStatus::Flying);
  EXPECT_FALSE(world.all_ended());
  advance(world, 1, {fly(1, Vec3::Zero()), fly(2, Vec3(7, 0, 0))});
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Arrived);
  world.note_given_up(2, NavStatus::Unreachable);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Arrived);
}

TEST(TransitWorld, ALostAgentThatGaveUpIsLost) {
  World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove);
  advance(world, 1, {fly(1, Vec3(10, 0, 0))});
  world.lose_agent(1);
  world.note_given_up(1, NavStatus::Unreachable);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Removed);
  EXPECT_TRUE(world.look_of(1, 2).empty());
}

TEST(TransitWorld, LooksFromWhereItsVehiclesAre) {
  const std::vector<Obstacle> hidden{{Box{Vec3(16, 0, 0), Vec3(20, 40, 9)}, "wall"}};
  Mission mission = transit_of({crosser(1, kWest)}, {kEast});
  mission.transit->sensor.period_s = 2.0;
  World world(mission, OnAgentLoss::Remove, hidden);
  const CellWindow seen = world.look_of(1, 1);
  EXPECT_EQ(seen.at({4, 4, 0}), CellState::Occupied);
  EXPECT_EQ(seen.at({3, 4, 0}), CellState::Free);
  EXPECT_EQ(seen.at({5, 4, 0}), CellState::Unknown);
  EXPECT_TRUE(world.look_of(1, 2).empty());
  EXPECT_FALSE(world.look_of(1, 3).empty());
}

TEST(TransitWorld, KnowsTheShortestWays) {
  const std::vector<Obstacle> wall{{Box{Vec3(40, 0, 0), Vec3(44, 32, 9)}, "wall"}};
  const World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove, wall);
  EXPECT_NEAR(*world.shortest_paths_m()[0], 44.0 + 8 * 4.0 * std::sqrt(2.0) - 8.0, 1e-9);
  EXPECT_EQ(World(abreast(2), OnAgentLoss::Remove).shortest_paths_m().size(), 0U);
  const std::vector<Obstacle> closed{{Box{Vec3(40, 0, 0), Vec3(44, 40, 9)}, "wall"}};
  EXPECT_EQ(World(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Remove, closed).shortest_paths_m()[0],
            std::nullopt);
}

TEST(TransitWorld, HoversWhereItsAgentWasLost) {
  World world(transit_of({crosser(1, kWest)}, {kEast}), OnAgentLoss::Hover);
  advance(world, 1, {fly(1, Vec3(10, 0, 0))});
  world.lose_agent(1);
  advance(world, 2, {});
  EXPECT_EQ(world.vehicle(1).state.position_m, Vec3(16, 18, 6));
}

}  // namespace
}  // namespace skein::test
