// What a good scenario becomes, value by value, and which seed and hash it has.
#include <fmt/core.h>

#include "planner/core/geometry/frames.hpp"
#include "simworld/scenario/checks.hpp"
#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

Scenario load(const std::string& path, std::optional<std::uint64_t> seed = {}) {
  return scenario_of(load_scenario(path, {}, seed));
}

TEST(Scenario, LayoutAIsThatOfThePaper) {
  const Scenario scenario = load(kScenarioDir + "rendezvous-2d.yaml");
  const Mission& mission = scenario.mission;
  EXPECT_EQ(mission.name, "rendezvous-2d");
  EXPECT_EQ(mission.kind, MissionKind::Rendezvous);
  EXPECT_EQ(mission.seed, 1U);
  EXPECT_EQ(mission.length_unit_m, 1000.0);
  EXPECT_EQ(mission.step_s, 0.5);
  EXPECT_EQ(mission.formation.position_m, Vec3(30000, 15000, 0));  // the corrected point, not (35 km, 15 km)
  EXPECT_EQ(mission.formation.heading_rad, 0.0);
  ASSERT_EQ(mission.vehicles.size(), 3U);
  const VehicleSpec& second = mission.vehicles[1];
  EXPECT_EQ(second.id, 2U);
  EXPECT_EQ(second.start.position_m, Vec3(-1000, 10000, 0));
  EXPECT_DOUBLE_EQ(second.start.heading_rad, -3.14159265358979323846 / 4);
  EXPECT_EQ(second.slot_offset_m, Vec3(-300, -600, 0));
  EXPECT_EQ(second.type, VehicleType::ConstantSpeed);
  EXPECT_EQ(second.speed_mps, 50.0);
  EXPECT_EQ(second.max_curvature_per_m, 0.002);
  EXPECT_EQ(second.radius_m, 2.0);
  EXPECT_EQ(second.safety_radius_m, 100.0);
  EXPECT_EQ(scenario.world.on_agent_loss, OnAgentLoss::Remove);
}

TEST(Scenario, LayoutAHasTwoCirclesAndTwoRectangles) {
  const Mission mission = load(kScenarioDir + "rendezvous-2d.yaml").mission;
  ASSERT_EQ(mission.zones.size(), 4U);
  const auto& circle = std::get<Cylinder>(mission.zones[1].shape);
  EXPECT_EQ(circle.centre_m, Vec2(6500, 17500));
  EXPECT_EQ(circle.radius_m, 3000.0);
  EXPECT_FALSE(mission.zones[1].no_fly);
  const auto& box = std::get<Box>(mission.zones[2].shape);
  EXPECT_EQ(box.min_m, Vec3(20000, 2000, -kUnboundedZ_m));
  EXPECT_EQ(box.max_m, Vec3(25000, 6000, kUnboundedZ_m));
  EXPECT_TRUE(mission.zones[2].no_fly);
}

TEST(Scenario, LayoutBDiffersInItsZonesOnly) {
  Mission a = load(kScenarioDir + "rendezvous-2d.yaml").mission;
  const Mission b = load(kScenarioDir + "rendezvous-2d-b.yaml").mission;
  ASSERT_EQ(b.zones.size(), 4U);
  EXPECT_EQ(std::get<Box>(b.zones[2].shape).min_m.head<2>(), Vec2(9000, 14000));
  EXPECT_NE(a, b);
  a.name = b.name;
  a.zones = b.zones;
  EXPECT_EQ(a, b);
}

TEST(Scenario, TheThirdAxisIsThatOfThePaper) {
  const Mission mission = load(kScenarioDir + "rendezvous-3d.yaml").mission;
  EXPECT_EQ(mission.formation.position_m, Vec3(30000, 15000, 3000));
  EXPECT_EQ(mission.formation.climb_rad, 0.0);
  EXPECT_EQ(mission.vehicles[2].start.position_m, Vec3(-3000, 20000, 3300));
  EXPECT_DOUBLE_EQ(mission.vehicles[2].start.climb_rad, -3.14159265358979323846 / 7);
  EXPECT_EQ(mission.vehicles[0].max_torsion_per_m, 0.002);
  ASSERT_EQ(mission.zones.size(), 5U);
  EXPECT_EQ(std::get<Cylinder>(mission.zones[1].shape).z_max_m, 2800.0);
  EXPECT_EQ(std::get<Cylinder>(mission.zones[1].shape).z_min_m, -kUnboundedZ_m);
  EXPECT_EQ(std::get<Box>(mission.zones[4].shape).min_m, Vec3(10000, 8000, 3400));
  ASSERT_TRUE(mission.terrain.has_value());
  EXPECT_EQ(*mission.terrain, (Terrain{0.5, -1.15, 0.5, 3.42, 0.6, 0.327, 0.5, 0.08, 0.05, 1000.0}));
}

TEST(Scenario, ARingPutsEverySlotOppositeItsStart) {
  const std::vector<Override> many{{"vehicles.ring.agents", "25"}, {"formation.heading_rad", "0.7"}};
  const Mission mission = scenario_of(load_scenario(kScenarioDir + "rendezvous-ring.yaml", many, {})).mission;
  ASSERT_EQ(mission.vehicles.size(), 25U);
  for (std::size_t k = 0; k < 25; ++k) {
    const VehicleSpec& vehicle = mission.vehicles[k];
    EXPECT_EQ(vehicle.id, k + 1);
    const Vec3& start_m = vehicle.start.position_m;
    EXPECT_NEAR(start_m.norm(), 10000.0, 1e-6);
    EXPECT_LT((slot_pose(mission, vehicle).position_m + 0.2 * start_m).norm(), 1e-6);
    EXPECT_NEAR(direction_of(vehicle.start).dot(-start_m.normalized()), 0.5403023058681398, 1e-9) << "cos 1";
  }
  EXPECT_TRUE(scenario::notes_of(mission).empty());
}

TEST(Scenario, ARingStandsForStartsAndSlots) {
  const std::string ring = kScenarioDir + "rendezvous-ring.yaml";
  const auto line = [&](const std::vector<Override>& changes) { return fault_line(load_scenario(ring, changes, {})); };
  EXPECT_EQ(line({{"vehicles.starts", "[]"}}),
            "--set vehicles.starts: vehicles.starts is a list; allowed: no such list beside vehicles.ring");
  EXPECT_EQ(line({{"vehicles.ring.agents", "1"}}),
            "--set vehicles.ring.agents: vehicles.ring.agents is 1; allowed: a whole number from 2 to 256");
  EXPECT_EQ(fault_line(load_small({{"vehicles.ring.agents", "4"}})).substr(kDataDir.size()),
            "small.yaml:14:5: vehicles.starts is a list; allowed: no such list beside vehicles.ring");
}

TEST(Scenario, VehiclesThatCannotChangeTheirLengthAreNamed) {
  const Mission straight = scenario_of(load_small({{"vehicles.starts.2.y_m", "700"}})).mission;
  const std::vector<std::string> notes = scenario::notes_of(straight);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].substr(0, 51), "vehicle 2 cannot change the length of its path: it ");
  EXPECT_TRUE(scenario::notes_of(scenario_of(load_small({})).mission).empty());
}

TEST(Scenario, ZonesOfEitherShapeAreObstaclesOrNoFly) {
  const Mission mission =
      scenario_of(
          load_small({{"obstacles", "[{x_min_m: 4000, y_min_m: 3000, x_max_m: 5000, y_max_m: 3500, z_max_m: 9}]"},
                      {"no_fly", "[{x_m: 4000, y_m: 5000, radius_m: 50, z_min_m: -5, z_max_m: 5}]"}}))
          .mission;
  ASSERT_EQ(mission.zones.size(), 2U);
  EXPECT_EQ(std::get<Box>(mission.zones[0].shape).max_m, Vec3(5000, 3500, 9));
  EXPECT_FALSE(mission.zones[0].no_fly);
  EXPECT_EQ(std::get<Cylinder>(mission.zones[1].shape).z_min_m, -5.0);
  EXPECT_TRUE(mission.zones[1].no_fly);
}

TEST(Scenario, WhatHasNoRoomInHeightIsRefused) {
  EXPECT_EQ(fault_line(load_small({{"terrain", "{e: 10}"}})).substr(kDataDir.size()),
            "small.yaml:14:7: the start of vehicle 1 is 10 m below the terrain; allowed: more than 2 m above it, its "
            "radius on the steepest slope");
  EXPECT_EQ(fault_line(load_small({{"obstacles.1.z_min_m", "9"}, {"obstacles.1.z_max_m", "3"}})),
            "--set obstacles.1.z_max_m: obstacles.1.z_max_m is 3; allowed: more than z_min_m, 9 m");
}

TEST(Scenario, AStartUnderneathAnObstacleHasRoom) {
  const std::vector<Override> above{{"obstacles.1.x_m", "0"}, {"obstacles.1.y_m", "0"}, {"obstacles.1.z_min_m", "10"}};
  EXPECT_EQ(scenario_of(load_small(above)).mission.zones.size(), 2U);
}

TEST(Scenario, WhatIsLeftOutHasItsDefault) {
  const Scenario scenario = load(kDataDir + "small.yaml");
  RendezvousOptions planner;
  planner.particles = 10;
  EXPECT_EQ(scenario.mission.planner, planner);
  EXPECT_EQ(scenario.lockstep, LockstepOptions{});
  EXPECT_EQ(scenario.world, WorldOptions{});
  EXPECT_EQ(scenario.mission.length_unit_m, 1.0);
  EXPECT_FALSE(scenario.mission.terrain.has_value());
  EXPECT_EQ(scenario.mission.vehicles[0].max_torsion_per_m, kUnlimitedTorsion_per_m);
  EXPECT_EQ(scenario.mission.vehicles[0].start.position_m.z(), 0.0);
}

TEST(Scenario, VehiclesAreByAscendingIdWhateverTheOrderOfTheFile) {
  const std::vector<Override> swapped{
      {"vehicles.starts", "[{id: 200, x_m: 5, y_m: 600, heading_rad: 1}, {id: 3, x_m: 0, y_m: 0, heading_rad: -1}]"},
      {"formation.slots", "[{id: 3, x_m: 1, y_m: 0}, {id: 200, x_m: 2, y_m: 300}]"}};
  const Mission mission = scenario_of(load_small(swapped)).mission;
  ASSERT_EQ(mission.vehicles.size(), 2U);
  EXPECT_EQ(mission.vehicles[0].id, 3U);
  EXPECT_EQ(mission.vehicles[0].slot_offset_m.x(), 1.0);
  EXPECT_EQ(mission.vehicles[1].start.heading_rad, 1.0);
}

TEST(Scenario, ClutterHasThePosesOfTheOpenField) {
  const Mission mission = load(kScenarioDir + "rendezvous-clutter.yaml").mission;
  const Mission open = load(kScenarioDir + "rendezvous-2d.yaml").mission;
  EXPECT_EQ(mission.vehicles, open.vehicles);
  EXPECT_EQ(mission.zones.size(), 7U);
  EXPECT_EQ(mission.planner, open.planner);
}

TEST(Scenario, EveryPlannerOptionHasItsKey) {
  for (const RendezvousField& field : kRendezvousFields) {
    const std::string value =
        field.key == "search_min_chords" ? "0.5" : std::to_string(static_cast<int>(field.min + 1));
    const Scenario scenario = scenario_of(load_small({{"planner." + std::string(field.key), value}}));
    const double read =
        std::visit([&](auto member) { return static_cast<double>(scenario.mission.planner.*member); }, field.member);
    EXPECT_EQ(read, std::stod(value)) << field.key;
  }
}

TEST(Scenario, ThePageNamesEveryPlannerOptionWithUnitRangeAndDefault) {
  const std::string page = text_of(SKEIN_SOURCE_DIR "/docs/scenario.md");
  for (const RendezvousField& field : kRendezvousFields) {
    const bool whole = std::holds_alternative<std::int32_t RendezvousOptions::*>(field.member);
    const double standard =
        std::visit([](auto member) { return static_cast<double>(RendezvousOptions{}.*member); }, field.member);
    const std::string unit(whole ? "whole" : field.unit.empty() ? "-" : field.unit);
    const std::string row =
        fmt::format("| `planner.{}` | {} | {} to {} | {} |", field.key, unit, field.min, field.max, standard);
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(Scenario, WordsAndWorldOptionsAreRead) {
  const Scenario scenario = scenario_of(load_small({{"vehicles.on_agent_loss", "continue"},
                                                    {"lockstep.deadline_s", "2.5"},
                                                    {"world.max_rounds", "77"},
                                                    {"name", "'12'"}}));
  EXPECT_EQ(scenario.world.on_agent_loss, OnAgentLoss::Continue);
  EXPECT_EQ(scenario.lockstep.deadline_s, 2.5);
  EXPECT_EQ(scenario.world.max_rounds, 77U);
  EXPECT_EQ(scenario.mission.name, "12");
  EXPECT_EQ(scenario_of(load_small({{"vehicles.on_agent_loss", "hover"}})).world.on_agent_loss, OnAgentLoss::Hover);
}

TEST(Scenario, TheGivenSeedReplacesThatOfTheFileAndOfOverrides) {
  const std::string path = kDataDir + "small.yaml";
  EXPECT_EQ(load(path).mission.seed, 7U);
  EXPECT_EQ(load(path, 18446744073709551615U).mission.seed, 18446744073709551615U);
  const std::vector<Override> set{{"seed", "3"}};
  EXPECT_EQ(scenario_of(load_scenario(path, set, 9)).mission.seed, 9U);
  EXPECT_EQ(scenario_of(load_scenario(path, set, std::nullopt)).mission.seed, 3U);
}

TEST(Scenario, HashIsOfTheTextAndNotOfSeedOrPath) {
  const Scenario a = load(kDataDir + "small.yaml", 1);
  const Scenario b = load(kDataDir + "small.yaml", 2);
  EXPECT_EQ(a.scenario_hash, b.scenario_hash);
  EXPECT_EQ(a.path, kDataDir + "small.yaml");
  EXPECT_EQ(a.text, text_of(a.path));
  EXPECT_NE(scenario_of(parse_scenario(a.text + "# more\n", a.path, {}, 1)).scenario_hash, a.scenario_hash);
  EXPECT_EQ(scenario_of(parse_scenario(a.text, "elsewhere", {}, 1)).scenario_hash, a.scenario_hash);
}

TEST(Scenario, SlotsAreCheckedWhereTheFormationHeadingTurnsThem) {
  // Turned by a right angle, slot 2 (0, 200) lies 200 m west of the formation centre, in the obstacle.
  const std::vector<Override> turned{
      {"formation.heading_rad", "1.5707963267948966"}, {"obstacles.1.x_m", "8800"}, {"obstacles.1.radius_m", "50"}};
  EXPECT_EQ(fault_line(load_small(turned)).substr(kDataDir.size()),
            "small.yaml:22:7: the slot of vehicle 2 is 50 m inside obstacles.1; allowed: more than 2 m from it, its "
            "radius");
}

}  // namespace
}  // namespace skein::test
