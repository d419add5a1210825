// The world's step: arrivals, misses, contacts, and what becomes of a lost agent's vehicle.
#include "simworld/world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

constexpr double kQuarter_rad = 1.5707963267948966;

/// Steps `from` to `to`, everybody straight on.
void fly(World& world, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t step = from; step <= to; ++step) world.advance(step, {});
}

World alone(const Vec3& start_m, const Vec3& slot_m, std::vector<Zone> zones = {}) {
  return World(test::mission_of({test::vehicle(1, start_m, 0.0, slot_m)}, std::move(zones)), OnAgentLoss::Remove);
}

TEST(World, RefusesMissionsThatCannotBeFlown) {
  EXPECT_THROW(World(test::mission_of({}), OnAgentLoss::Remove), std::invalid_argument);
  Mission still = test::abreast(1);
  still.step_s = 0.0;
  EXPECT_THROW(World(still, OnAgentLoss::Remove), std::invalid_argument);
}

TEST(World, ArrivesInTheStepAndAtTheTimeOfTheCrossing) {
  World world = alone({-25.0, 0.0, 0.0}, {0.0, 0.5, 0.0});
  fly(world, 1, 2);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Flying);
  EXPECT_FALSE(world.all_ended());
  fly(world, 3, 3);
  const VehicleRecord& vehicle = world.vehicle(1);
  EXPECT_EQ(vehicle.status, VehicleStatus::Arrived);
  EXPECT_EQ(vehicle.arrival_step, 3U);
  EXPECT_NEAR(vehicle.arrival_time_s, 2.5, 1e-12);
  EXPECT_NEAR(vehicle.flown_m, 30.0, 1e-12);
  EXPECT_EQ(vehicle.max_curvature_per_m, 0.0);
  EXPECT_TRUE(world.all_ended());
}

TEST(World, ArrivesWhenItReachesThePlaneAtTheEndOfAStep) {
  World world = alone({-20.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  fly(world, 1, 2);
  EXPECT_EQ(world.vehicle(1).arrival_step, 2U);
  EXPECT_NEAR(world.vehicle(1).arrival_time_s, 2.0, 1e-12);
}

TEST(World, DoesNotArriveBesideTheSlotOrAgainstTheFormation) {
  World beside = alone({-25.0, 0.0, 0.0}, {0.0, 1.01, 0.0});
  fly(beside, 1, 5);
  EXPECT_EQ(beside.vehicle(1).status, VehicleStatus::Flying);
  World backwards(test::mission_of({test::vehicle(1, {25.0, 0.0, 0.0}, 2.0 * kQuarter_rad, Vec3::Zero())}),
                  OnAgentLoss::Remove);
  fly(backwards, 1, 5);
  EXPECT_EQ(backwards.vehicle(1).status, VehicleStatus::Flying);
}

TEST(World, MissesItsSlotOnlyOnceThePathIsFlownAndFarOff) {
  World world = alone({-25.0, 0.0, 0.0}, {0.0, 5.0, 0.0});
  const VehicleCommand flown{1, Vec3(10.0, 0.0, 0.0), true};
  world.advance(1, {});
  world.advance(2, {&flown, 1});  // 5 m short of the plane: within a step of the slot
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Flying);
  world.advance(3, {&flown, 1});
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Flying);
  world.advance(4, {&flown, 1});
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Missed);
  EXPECT_TRUE(world.all_ended());
}

TEST(World, TurnsAVehicleAsCommandedAndNotesTheCurvature) {
  World world = alone({-25.0, 0.0, 0.0}, {100.0, 0.0, 0.0});
  const VehicleCommand left{1, Vec3(0.0, 10.0, 0.0), false};
  world.advance(1, {&left, 1});
  EXPECT_NEAR(world.vehicle(1).max_curvature_per_m, 0.1, 1e-15);
  EXPECT_NEAR(world.vehicle(1).state.position_m.y(), 10.0 * (1.0 - std::cos(1.0)), 1e-12);
}

TEST(World, CommandsGoToTheirOwnVehicle) {
  World world(test::abreast(3), OnAgentLoss::Remove);
  const VehicleCommand up{2, Vec3(10.0, 1.0, 0.0), false};
  world.advance(1, {&up, 1});
  EXPECT_EQ(world.vehicle(1).state.velocity_mps.y(), 0.0);
  EXPECT_GT(world.vehicle(2).state.velocity_mps.y(), 0.9);
  EXPECT_EQ(world.vehicle(3).state.velocity_mps.y(), 0.0);
  EXPECT_THROW((void)world.vehicle(4), std::invalid_argument);
}

/// Vehicle 1 east and vehicle 2 north, which meet at (5 + x, 0) in the middle of step 1 and are far apart at its ends.
World crossing(double late_m) {
  return World(test::mission_of({test::vehicle(1, {-5.0, 0.0, 0.0}, 0.0, {900.0, 0.0, 0.0}),
                                 test::vehicle(2, {0.0, -5.0 - late_m, 0.0}, kQuarter_rad, {900.0, 50.0, 0.0})}),
               OnAgentLoss::Remove);
}

TEST(World, SeesVehiclesThatTouchOnlyBetweenTwoSteps) {
  World world = crossing(0.0);
  EXPECT_FALSE(world.min_separation_m().has_value());
  fly(world, 1, 3);
  EXPECT_EQ(world.count(ContactKind::Vehicles), 1U);
  EXPECT_EQ(world.count(ContactKind::NearMiss), 1U);
  ASSERT_TRUE(world.min_separation_m().has_value());
  EXPECT_NEAR(*world.min_separation_m(), 0.0, 1e-12);
  const Contact& contact = world.contacts().front();
  EXPECT_EQ(contact.kind, ContactKind::Vehicles);
  EXPECT_EQ(contact.step, 1U);
  EXPECT_EQ(contact.vehicle, 1U);
  EXPECT_EQ(contact.other, 2U);
}

TEST(World, TellsANearMissFromACollision) {
  World world = crossing(6.0);  // least distance 6 / sqrt(2) = 4.2 m: over 2 m, under 10 m
  fly(world, 1, 1);
  EXPECT_EQ(world.count(ContactKind::Vehicles), 0U);
  ASSERT_EQ(world.count(ContactKind::NearMiss), 1U);
  EXPECT_NEAR(world.contacts().front().distance_m, 6.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(*world.min_separation_m(), 6.0 / std::sqrt(2.0), 1e-12);
}

TEST(World, CountsAContactOnceAStretch) {
  // side by side at 3 m for three steps, then apart, then near again
  World world(test::mission_of({test::vehicle(1, {0.0, 0.0, 0.0}, 0.0, {900.0, 0.0, 0.0}),
                                test::vehicle(2, {0.0, 3.0, 0.0}, 0.0, {900.0, 50.0, 0.0})}),
              OnAgentLoss::Remove);
  fly(world, 1, 3);
  EXPECT_EQ(world.count(ContactKind::NearMiss), 1U);
  const VehicleCommand away{2, Vec3(0.0, 10.0, 0.0), false};
  for (std::uint32_t step = 4; step <= 7; ++step) world.advance(step, {&away, 1});
  EXPECT_EQ(world.count(ContactKind::NearMiss), 1U);
  for (std::uint32_t step = 8; step <= 40 && world.count(ContactKind::NearMiss) == 1; ++step) {
    const Vec3 apart_m = world.vehicle(1).state.position_m - world.vehicle(2).state.position_m;
    const std::array commands{VehicleCommand{1, -apart_m, false}, VehicleCommand{2, apart_m, false}};
    world.advance(step, commands);
  }
  EXPECT_EQ(world.count(ContactKind::NearMiss), 2U);
}

TEST(World, CountsObstaclesAndNoFlyZonesByTheBody) {
  const Zone pillar{Cylinder{Vec2(15.0, 4.0), 3.0, -100.0, 100.0}, false};  // 1 m off the way: the body touches
  const Zone ground{Box{Vec3(30.0, -5.0, -100.0), Vec3(40.0, 5.0, 100.0)}, true};
  const Zone far{Cylinder{Vec2(15.0, 50.0), 3.0, -100.0, 100.0}, false};
  World world = alone({0.0, 0.0, 0.0}, {900.0, 0.0, 0.0}, {far, pillar, ground});
  fly(world, 1, 6);
  ASSERT_EQ(world.contacts().size(), 2U);
  EXPECT_EQ(world.contacts()[0].kind, ContactKind::VehicleObstacle);
  EXPECT_EQ(world.contacts()[0].other, 1U);
  EXPECT_EQ(world.contacts()[0].step, 2U);
  EXPECT_EQ(world.contacts()[1].kind, ContactKind::NoFly);
  EXPECT_EQ(world.contacts()[1].other, 2U);
  EXPECT_EQ(world.contacts()[1].step, 3U);
  EXPECT_NEAR(*world.min_clearance_m(), -6.0, 1e-12);  // 5 m deep in the zone, and the body's radius
}

TEST(World, WithoutZonesThereIsNoClearance) {
  World world = alone({0.0, 0.0, 0.0}, {900.0, 0.0, 0.0});
  fly(world, 1, 1);
  EXPECT_FALSE(world.min_clearance_m().has_value());
  EXPECT_FALSE(world.min_separation_m().has_value());
}

TEST(World, TakesALostAgentsVehicleAway) {
  World world(test::abreast(2), OnAgentLoss::Remove);
  fly(world, 1, 1);
  world.lose_agent(2);
  fly(world, 2, 3);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Removed);
  EXPECT_NEAR(world.vehicle(2).flown_m, 10.0, 1e-12);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Arrived);
  EXPECT_TRUE(world.all_ended());
}

TEST(World, LetsALostAgentsVehicleContinueOnlyInTheAir) {
  World grounded(test::abreast(2), OnAgentLoss::Continue);
  grounded.lose_agent(2);
  EXPECT_EQ(grounded.vehicle(2).status, VehicleStatus::Removed);
  World world(test::abreast(2), OnAgentLoss::Continue);
  fly(world, 1, 1);
  world.lose_agent(2);
  fly(world, 2, 3);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Adrift);
  EXPECT_EQ(world.vehicle(2).arrival_step, 0U);
  EXPECT_NEAR(world.vehicle(2).flown_m, 30.0, 1e-12);
  EXPECT_TRUE(world.all_ended());
}

TEST(World, ALostAgentsVehicleMayWaitInACircle) {
  World world(test::abreast(2), OnAgentLoss::Hover);
  fly(world, 1, 1);
  const Vec3 where_m = world.vehicle(2).state.position_m;
  world.lose_agent(2);
  fly(world, 2, 40);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Hovering);
  EXPECT_LE((world.vehicle(2).state.position_m - where_m).norm(), 20.0 + 1e-9);  // the circle's diameter
  EXPECT_NEAR(world.vehicle(2).state.velocity_mps.norm(), 10.0, 1e-9);
  EXPECT_TRUE(world.all_ended());
  world.return_agent(2);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Hovering);
}

TEST(World, AReturnedAgentTakesItsVehicleOver) {
  World world(test::abreast(2), OnAgentLoss::Continue);
  fly(world, 1, 1);
  world.lose_agent(2);
  world.return_agent(2);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Rejoined);
  const VehicleCommand left{2, Vec3(0.0, 10.0, 0.0), false};
  world.advance(2, {&left, 1});
  EXPECT_GT(world.vehicle(2).state.velocity_mps.y(), 1.0);
  fly(world, 3, 3);
  EXPECT_TRUE(world.all_ended()) << "it is not waited for: it has no plan";
  world.lose_agent(2);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Adrift);
}

TEST(World, ARemovedVehicleStaysAway) {
  World world(test::abreast(2), OnAgentLoss::Continue);
  world.lose_agent(2);  // on the ground
  world.return_agent(2);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Removed);
  fly(world, 1, 1);
  world.lose_agent(2);
  EXPECT_EQ(world.vehicle(2).status, VehicleStatus::Removed);
}

TEST(World, RemovedVehiclesTouchNothing) {
  World world = crossing(0.0);
  world.lose_agent(2);
  fly(world, 1, 3);
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_FALSE(world.min_separation_m().has_value());
  EXPECT_THROW(world.lose_agent(9), std::invalid_argument);
}

TEST(World, HashTellsStatesApart) {
  const auto hash_of = [](const World& world) {
    StateHash hash;
    world.add_to(hash);
    return hash.value();
  };
  World first(test::abreast(2), OnAgentLoss::Remove);
  World second(test::abreast(2), OnAgentLoss::Remove);
  EXPECT_EQ(hash_of(first), hash_of(second));
  first.advance(1, {});
  EXPECT_NE(hash_of(first), hash_of(second));
  second.advance(1, {});
  EXPECT_EQ(hash_of(first), hash_of(second));
  second.lose_agent(1);
  EXPECT_NE(hash_of(first), hash_of(second));
}

}  // namespace
}  // namespace skein
