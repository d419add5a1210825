// Movers, announced zones and slow vehicles in the world: contacts, being rammed, what sensors see.
#include <gtest/gtest.h>

#include <algorithm>

#include "simworld/world/world.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

/// A multirotor of 10 m/s and 4 m/s2, radius 1 m, that starts at rest.
VehicleSpec rotor(AgentId id, const Vec3& start_m) {
  VehicleSpec spec = test::vehicle(id, start_m, 0.0, {900.0, 0.0, 0.0});
  spec.type = VehicleType::Multirotor;
  spec.max_acceleration_mps2 = 4.0;
  return spec;
}

Mover mover_at(const Vec3& place_m, MoverMotion motion, bool column = false) {
  Mover mover;
  mover.name = "moving_obstacles.1";
  mover.position_m = place_m;
  mover.radius_m = 2.0;
  mover.column = column;
  mover.motion = std::move(motion);
  return mover;
}

World world_of(std::vector<VehicleSpec> vehicles, std::vector<Mover> movers) {
  Surprises surprises;
  surprises.movers = std::move(movers);
  return World(test::mission_of(std::move(vehicles)), OnAgentLoss::Hover, {}, surprises);
}

/// Everybody is commanded the same.
void fly(World& world, std::uint32_t from, std::uint32_t to, const Vec3& velocity_mps) {
  std::vector<VehicleCommand> commands;
  for (const VehicleRecord& vehicle : world.vehicles()) commands.push_back({vehicle.spec.id, velocity_mps});
  for (std::uint32_t step = from; step <= to; ++step) world.advance(step, commands);
}

TEST(WorldMovers, WhatMeetsAMovingVehicleIsACollision) {
  World world = world_of({rotor(1, {0, 0, 0})}, {mover_at({15, 0, 0}, LineMotion{Vec3(-2, 0, 0)})});
  fly(world, 1, 8, {4, 0, 0});
  ASSERT_EQ(world.contacts().size(), 1U) << "counted once, at its first step";
  const Contact& contact = world.contacts()[0];
  EXPECT_EQ(contact.kind, ContactKind::Mover);
  EXPECT_EQ(contact.step, 3U);  // 0 m at 15, 2 at 13, 6 at 11, 10 at 9
  EXPECT_EQ(contact.vehicle, 1U);
  EXPECT_EQ(contact.other, 0U);
  EXPECT_LT(*world.min_clearance_m(), 0.0);
}

TEST(WorldMovers, WhatMeetsAVehicleAtRestRamsIt) {
  World world = world_of({rotor(1, {0, 0, 0})}, {mover_at({15, 0, 0}, LineMotion{Vec3(-2, 0, 0)})});
  fly(world, 1, 20, {0, 0, 0});
  EXPECT_EQ(world.count(ContactKind::Rammed), 1U);
  EXPECT_EQ(world.count(ContactKind::Mover), 0U);
  EXPECT_EQ(world.contacts()[0].step, 6U);
}

TEST(WorldMovers, AreCheckedBetweenTheStepsToo) {
  World world = world_of({rotor(1, {0, 0, 0})}, {mover_at({50, 0.5, 0}, LineMotion{Vec3(-100, 0, 0)})});
  fly(world, 1, 1, {0, 0, 0});
  ASSERT_EQ(world.contacts().size(), 1U);
  EXPECT_NEAR(world.contacts()[0].distance_m, 0.5, 1e-12);
  World beside = world_of({rotor(1, {0, 0, 0})}, {mover_at({50, 3.1, 0}, LineMotion{Vec3(-100, 0, 0)})});
  fly(beside, 1, 1, {0, 0, 0});
  EXPECT_TRUE(beside.contacts().empty());
  EXPECT_NEAR(*beside.min_clearance_m(), 0.1, 1e-12);
}

TEST(WorldMovers, AColumnHasNoEndsASphereDoes) {
  const Vec3 above(0, 0, 100);
  World column = world_of({rotor(1, {0, 0, 0})}, {mover_at(above, StillMotion{}, true)});
  World sphere = world_of({rotor(1, {0, 0, 0})}, {mover_at(above, StillMotion{}, false)});
  fly(column, 1, 1, {0, 0, 0});
  fly(sphere, 1, 1, {0, 0, 0});
  EXPECT_EQ(column.contacts().size(), 1U);
  EXPECT_TRUE(sphere.contacts().empty());
}

TEST(WorldMovers, AreSeenWithinRangeOfTheirSurface) {
  World world = world_of({rotor(1, {0, 0, 0}), rotor(2, {0, 500, 0})}, {mover_at({26, 0, 0}, LineMotion{Vec3(0, 1, 0)}),
                                                                        mover_at({0, 520, 700}, StillMotion{}, true)});
  EXPECT_TRUE(world.tracks_of(1, 23.9).empty());
  const auto seen = world.tracks_of(1, 24.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0], (Track{1, Vec3(26, 0, 0), Vec3(0, 1, 0), 2.0, false, false}));
  const auto other = world.tracks_of(2, 24.0);
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(other[0], (Track{2, Vec3(0, 520, 700), Vec3::Zero(), 2.0, true, true}));
}

TEST(WorldMovers, WhatAppearsIsSeenBeforeTheStepInWhichItIsThere) {
  Mover mover = mover_at({26, 0, 0}, StillMotion{});
  mover.sudden = true;
  mover.at_s = 2.0;
  World world = world_of({rotor(1, {0, 0, 0})}, {mover});
  fly(world, 1, 1, {0, 0, 0});
  EXPECT_TRUE(world.tracks_of(1, 100.0).empty());
  fly(world, 2, 2, {0, 0, 0});
  EXPECT_EQ(world.tracks_of(1, 100.0).size(), 1U);
  EXPECT_EQ(world.movers()[0].appeared_step, 3U);
}

TEST(WorldMovers, ChangeTheHashOnlyIfThereAreAny) {
  const auto hash_of = [](const World& world) {
    StateHash hash;
    world.add_to(hash);
    return hash.value();
  };
  World with = world_of({rotor(1, {0, 0, 0})}, {mover_at({500, 0, 0}, StillMotion{})});
  World without = world_of({rotor(1, {0, 0, 0})}, {});
  const World plain(test::mission_of({rotor(1, {0, 0, 0})}), OnAgentLoss::Hover);
  EXPECT_NE(hash_of(with), hash_of(without));
  EXPECT_EQ(hash_of(plain), hash_of(without));
}

/// A zone of 30 m about the origin, announced from 10 s to 20 s and up to 4 s early; nobody is late.
World zoned(const Vec3& start_m, std::optional<Aircraft> aircraft = {}) {
  Mission mission = test::mission_of({rotor(1, start_m)});
  Announcement zone;
  zone.shape = Cylinder{Vec2(0, 0), 30.0};
  zone.from_s = 10.0;
  zone.to_s = 20.0;
  zone.early_s = 4.0;
  mission.announced = {zone};
  Surprises surprises;
  surprises.traffic = {{0.0, aircraft}};
  return World(mission, OnAgentLoss::Hover, {}, surprises);
}

TEST(WorldZones, NobodyMayBeInAnUnconfirmedOne) {
  World inside = zoned({30.5, 0, 0});
  fly(inside, 1, 6, {0, 0, 0});
  EXPECT_TRUE(inside.contacts().empty());
  fly(inside, 7, 40, {0, 0, 0});
  ASSERT_EQ(inside.contacts().size(), 1U);
  EXPECT_EQ(inside.contacts()[0].kind, ContactKind::ZoneEntry);
  EXPECT_EQ(inside.contacts()[0].step, 7U);
  World outside = zoned({31.1, 0, 0});
  fly(outside, 1, 40, {0, 0, 0});
  EXPECT_TRUE(outside.contacts().empty());
}

TEST(WorldZones, AreClearInTheEndAndThenMayBeEntered) {
  World world = zoned({300, 0, 0});
  std::uint32_t step = 1;
  for (; world.zone_states(step)[0] != ZoneState::Clear; ++step) fly(world, step, step, {0, 0, 0});
  EXPECT_GE(step, 18U);
  EXPECT_LE(step, 22U);
  fly(world, step, step + 60, {-10, 0, 0});
  EXPECT_TRUE(world.contacts().empty());
  EXPECT_LT(world.vehicle(1).state.position_m.x(), 0.0);
}

TEST(WorldZones, AnAircraftIsThereDuringTheOccupation) {
  World world = zoned({300, 0, 0}, Aircraft{5.0, Vec3(-30, 0, 0), Vec3(30, 0, 50)});
  bool seen = false;
  for (std::uint32_t step = 1; step <= 30; ++step) {
    const bool there = !world.tracks_of(1, 1000.0).empty();
    seen = seen || there;
    if (there) {
      EXPECT_EQ(world.zone_states(step)[0], ZoneState::Occupied) << step;
    }
    fly(world, step, step, {0, 0, 0});
  }
  EXPECT_TRUE(seen);
  EXPECT_TRUE(world.tracks_of(1, 1000.0).empty());
}

TEST(WorldSlow, AVehicleIsSlowerThanItsSpecSaysFromItsTimeOn) {
  Surprises surprises;
  surprises.slow = {{1, 0.8, 2.0}};
  World world(test::mission_of({test::vehicle(1, {0, 0, 0}, 0.0, {900, 0, 0}), rotor(2, {0, 50, 0})}),
              OnAgentLoss::Hover, {}, surprises);
  fly(world, 1, 2, {10, 0, 0});
  EXPECT_NEAR(world.vehicle(1).state.position_m.x(), 20.0, 1e-9);
  fly(world, 3, 6, {10, 0, 0});
  EXPECT_NEAR(world.vehicle(1).state.position_m.x(), 52.0, 1e-9);
  EXPECT_EQ(world.vehicle(1).spec.speed_mps, 10.0);
  EXPECT_NEAR(world.vehicle(2).state.velocity_mps.x(), 10.0, 1e-12);
}

TEST(WorldObedience, EndsWithTheAgent) {
  World world = world_of({rotor(1, {0, 0, 0}), rotor(2, {0, 50, 0})}, {});
  fly(world, 1, 1, {1, 0, 0});
  EXPECT_TRUE(world.obeys(1));
  world.lose_agent(1);
  EXPECT_FALSE(world.obeys(1));
  EXPECT_TRUE(world.obeys(2));
  world.return_agent(1);
  EXPECT_FALSE(world.obeys(1)) << "of a swarm that does not plan anew";
}

TEST(WorldObedience, OfASwarmThatPlansAnewWhoComesBackIsTakenUp) {
  Mission mission = test::mission_of({rotor(1, {0, 0, 0}), rotor(2, {0, 50, 0})});
  mission.planner.replan = 1;
  World world(mission, OnAgentLoss::Hover);
  fly(world, 1, 1, {1, 0, 0});
  world.lose_agent(1);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Hovering);
  world.return_agent(1);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Rejoined);
  EXPECT_TRUE(world.obeys(1));
  world.take_up(1);
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Flying);
}

TEST(WorldStraight, ATransitWithoutCellsHasNoTruth) {
  Mission mission = test::mission_of({rotor(1, {0, 0, 0})});
  mission.kind = MissionKind::Transit;
  TransitMission& transit = mission.transit.emplace();
  transit.area = {Vec3(-10, -10, -10), Vec3(100, 10, 10)};
  transit.goals_m = {Vec3(20, 0, 0)};
  transit.goal_radius_m = 1.0;
  transit.planner.name = kStraight;
  World world(mission, OnAgentLoss::Remove);
  EXPECT_EQ(world.truth(), nullptr);
  EXPECT_TRUE(world.shortest_paths_m().empty());
  for (std::uint32_t step = 1; step <= 20 && !world.all_ended(); ++step) {
    const double left_m = 20.0 - world.vehicle(1).state.position_m.x();
    fly(world, step, step, {std::min(4.0, left_m), 0, 0});
  }
  EXPECT_EQ(world.vehicle(1).status, VehicleStatus::Arrived);
}

}  // namespace
}  // namespace skein
