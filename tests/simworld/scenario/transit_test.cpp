// What a transit scenario becomes, and what its example files promise: room for all, and paths to every goal.
#include <fmt/core.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "simworld/sensing/shortest_paths.hpp"
#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

using Overrides = std::vector<Override>;

ScenarioResult load_example(const std::string& name, const Overrides& set = {},
                            std::optional<std::uint64_t> seed = {}) {
  return load_scenario(kScenarioDir + "transit-" + name + ".yaml", set, seed);
}

ScenarioResult load_small_transit(const Overrides& set = {}, std::optional<std::uint64_t> seed = {}) {
  return load_scenario(kDataDir + "small-transit.yaml", set, seed);
}

/// By vehicle, the shortest way with full knowledge.
std::vector<std::optional<double>> paths_m(const Scenario& scenario) {
  const TruthGrid truth(grid_of(*scenario.mission.transit), all_obstacles(scenario.mission, scenario.world.hidden));
  std::vector<Vec3> starts_m;
  for (const VehicleSpec& vehicle : scenario.mission.vehicles) starts_m.push_back(vehicle.start.position_m);
  return shortest_paths_m(truth, starts_m, scenario.mission.transit->goals_m);
}

TEST(Transit, TheSmallOneIsReadValueByValue) {
  const Scenario scenario = scenario_of(load_small_transit());
  const Mission& mission = scenario.mission;
  EXPECT_EQ(mission.kind, MissionKind::Transit);
  EXPECT_EQ(mission.seed, 7U);
  EXPECT_EQ(mission.step_s, 0.5);
  ASSERT_EQ(mission.vehicles.size(), 2U);
  EXPECT_EQ(mission.vehicles[1].id, 2U);
  EXPECT_EQ(mission.vehicles[1].type, VehicleType::Holonomic);
  EXPECT_EQ(mission.vehicles[1].speed_mps, 10.0);
  EXPECT_EQ(mission.vehicles[1].start.position_m, Vec3(6, 18, 6)) << "the centre of the cell of (5, 17)";
  ASSERT_TRUE(mission.transit.has_value());
  EXPECT_EQ(mission.transit->area, (Box{Vec3(0, 0, 4), Vec3(80, 40, 8)}));
  EXPECT_EQ(mission.transit->goals_m, (std::vector<Vec3>{Vec3(70, 22, 6), Vec3(70, 22, 6)}));
  EXPECT_EQ(mission.transit->goal_radius_m, 3.0);
  EXPECT_EQ(mission.transit->planner.name, "peach3d");
  EXPECT_EQ(mission.transit->planner.decision_s, 1.0);
  EXPECT_EQ(mission.transit->radio.range_m, 90.0);
  EXPECT_EQ(mission.transit->sensor.miss, 0.01);
  EXPECT_TRUE(mission.zones.empty());
  ASSERT_EQ(scenario.world.hidden.size(), 1U);
  EXPECT_EQ(scenario.world.hidden[0].name, "hidden_obstacles.1");
}

TEST(Transit, ObstaclesAreHiddenFromTheMission) {
  const Scenario with = scenario_of(load_small_transit());
  const Scenario without = scenario_of(load_small_transit({{"hidden_obstacles", "[]"}}));
  EXPECT_EQ(with.mission, without.mission);
  EXPECT_EQ(mission_hash(with.mission), mission_hash(without.mission));
  EXPECT_NE(with.scenario_hash, without.scenario_hash);
}

TEST(Transit, EveryShapeIsReadByItsKeys) {
  const Scenario scenario =
      scenario_of(load_small_transit({{"hidden_obstacles",
                                       "[{x_m: 40, y_m: 20, radius_m: 3}, {x_m: 50, y_m: 20, z_m: 6, radius_m: 3}, "
                                       "{terrain: {e: 2}}, {file: pyramid.obj, x_m: 30, y_m: 30, z_m: 4, scale: 2}, "
                                       "{x_min_m: 1, y_min_m: 2, x_max_m: 3, y_max_m: 4, z_max_m: 5}]"}}));
  const std::vector<Obstacle>& hidden = scenario.world.hidden;
  ASSERT_EQ(hidden.size(), 5U);
  EXPECT_EQ(std::get<Cylinder>(hidden[0].shape).radius_m, 3.0);
  EXPECT_EQ(std::get<Sphere>(hidden[1].shape).centre_m, Vec3(50, 20, 6));
  EXPECT_EQ(std::get<Terrain>(hidden[2].shape).e, 2.0);
  EXPECT_EQ(std::get<Mesh>(hidden[3].shape).triangles(), 6U);
  EXPECT_EQ(std::get<Mesh>(hidden[3].shape).bounds(), (Box{Vec3(26, 26, 4), Vec3(34, 34, 10)}));
  EXPECT_EQ(std::get<Box>(hidden[4].shape).max_m, Vec3(3, 4, 5));
}

TEST(Transit, GoalsAreOneForAllOrOneEach) {
  const Overrides own{{"goals", "[{id: 2, x_m: 70, y_m: 6}, {id: 1, x_m: 70, y_m: 30}]"}};
  const Mission mission = scenario_of(load_small_transit(own)).mission;
  EXPECT_EQ(mission.transit->goals_m, (std::vector<Vec3>{Vec3(70, 30, 6), Vec3(70, 6, 6)}));
  EXPECT_THAT(fault_line(load_small_transit({{"goals", "[{id: 2, x_m: 70, y_m: 6}]"}})),
              testing::HasSubstr("goals has none for vehicle 1; allowed: one for each start, or one point for all"));
}

TEST(Transit, AgentsKeepsTheFirstVehicles) {
  const Mission mission = scenario_of(load_example("power-station", {{"vehicles.agents", "3"}})).mission;
  EXPECT_EQ(ids_of(mission), (std::vector<AgentId>{1, 2, 3}));
  EXPECT_EQ(mission.transit->goals_m.size(), 3U);
}

TEST(Transit, ThePowerStationHasItsShortestPaths) {
  const std::vector<std::pair<std::string, std::vector<double>>> table{
      {"2", {539, 526, 555, 543, 556, 522, 538, 532, 572}},
      {"4", {564, 540, 588, 557, 581, 547, 571, 533, 605}},
      {"6", {622, 616, 612, 633, 629, 615, 605, 609, 629}}};
  for (const auto& [cell_m, expected_m] : table) {
    const auto lengths_m = paths_m(scenario_of(load_example("power-station", {{"planner.cell_m", cell_m}})));
    ASSERT_EQ(lengths_m.size(), 9U);
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_EQ(std::floor(lengths_m[i].value() + 0.5), expected_m[i])
          << "cells of " << cell_m << " m, start " << i + 1;
    }
  }
}

TEST(Transit, EveryExampleHasPathsForAllAtItsCellSizes) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> examples{{"power-station", {"2", "4", "6"}},
                                                                               {"power-station-3d", {"4"}},
                                                                               {"corridor", {"1", "2", "3", "4"}},
                                                                               {"forest", {"2", "4"}},
                                                                               {"maze", {"2", "4"}},
                                                                               {"partition", {"2", "4"}}};
  for (const auto& [name, sizes_m] : examples) {
    for (const std::string& cell_m : sizes_m) {
      for (const auto& length_m : paths_m(scenario_of(load_example(name, {{"planner.cell_m", cell_m}})))) {
        EXPECT_TRUE(length_m.has_value()) << name << ", cells of " << cell_m << " m";
      }
    }
  }
}

template <typename Options, std::size_t N>
void expect_rows(const std::string& page, std::string_view section, const std::array<OptionField<Options>, N>& fields) {
  for (const OptionField<Options>& field : fields) {
    const std::string_view unit = field.unit.empty() ? "-" : field.unit;
    const std::string row = fmt::format("| `{}.{}` | {} | {} to {} | {} |", section, field.key, unit, field.min,
                                        field.max, Options{}.*field.member);
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(Transit, ThePageNamesEveryOptionWithUnitRangeAndDefault) {
  const std::string page = text_of(SKEIN_SOURCE_DIR "/docs/scenario.md");
  expect_rows(page, "planner", kTransitFields);
  expect_rows(page, "radio", kRadioFields);
  expect_rows(page, "sensor", kSensorFields);
}

TEST(TransitDraw, FollowsTheSeedAndKeepsItsPromise) {
  const Overrides draw{{"draw", "{from: connected}"}, {"vehicles.agents", "9"}};
  std::vector<std::vector<Vec3>> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scenario scenario = scenario_of(load_example("power-station", draw, seed));
    for (const auto& length_m : paths_m(scenario)) EXPECT_TRUE(length_m.has_value());
    EXPECT_EQ(scenario_of(load_example("power-station", draw, seed)).mission, scenario.mission);
    seen.push_back(scenario.mission.transit->goals_m);
  }
  std::ranges::sort(seen, [](const auto& a, const auto& b) { return a[0].x() < b[0].x(); });
  EXPECT_NE(seen.front(), seen.back());
}

TEST(TransitDraw, StaysWithinItsBoxesAndApart) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mission mission = scenario_of(load_example("forest", {}, seed)).mission;
    ASSERT_EQ(mission.vehicles.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_LT(mission.vehicles[i].start.position_m.x(), 24.0);
      EXPECT_GT(mission.transit->goals_m[i].x(), 176.0);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_NE(mission.vehicles[i].start.position_m, mission.vehicles[j].start.position_m);
        EXPECT_NE(mission.transit->goals_m[i], mission.transit->goals_m[j]);
      }
    }
  }
}

TEST(TransitDraw, FreeCellsNeedNoPath) {
  const Overrides thick{{"draw.from", "free"}, {"forest.density_per_m2", "0.03"}};
  int without = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const auto& length_m : paths_m(scenario_of(load_example("forest", thick, seed)))) without += !length_m;
  }
  EXPECT_GT(without, 25);
}

TEST(TransitDraw, AnotherSeedDrawsAgain) {
  const Scenario first = scenario_of(load_example("forest", {}, 1));
  const Scenario second = scenario_of(with_seed(first, 2));
  const Scenario loaded = scenario_of(load_example("forest", {}, 2));
  EXPECT_EQ(second.mission, loaded.mission);
  EXPECT_EQ(second.world, loaded.world);
  EXPECT_NE(second.world.hidden, first.world.hidden);
  EXPECT_EQ(second.scenario_hash, first.scenario_hash);
}

TEST(TransitForest, LeavesGivenStartsAndGoalsFree) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Overrides forest{{"forest", "{trees: 60, radius_min_m: 1, radius_max_m: 3}"}};
    const Scenario scenario = scenario_of(load_small_transit(forest, seed));
    EXPECT_GT(scenario.world.hidden.size(), 30U);
    EXPECT_LT(scenario.world.hidden.size(), 61U);
  }
}

TEST(Transit, WhatDoesNotFitIsRefused) {
  const auto fault = [](const Overrides& set) { return fault_line(load_small_transit(set)); };
  const auto says = [](const std::string& text) { return testing::HasSubstr(text); };
  EXPECT_THAT(fault({{"vehicles.starts.1.x_m", "34"}}), says("the start of vehicle 1 is in an occupied cell"));
  EXPECT_THAT(fault({{"vehicles.starts.1.x_m", "81"}}), says("the start of vehicle 1 is outside the cells"));
  EXPECT_THAT(fault({{"vehicles.starts.1.z_m", "9"}}), says("no fault")) << "a plane has no height";
  EXPECT_THAT(fault({{"goals.x_m", "34"}}), says("the goal of vehicle 1 is in an occupied cell"));
  EXPECT_THAT(fault({{"vehicles.starts.1.y_m", "19"}}), says("different cells, at least 1 m, their safety radii"));
  EXPECT_THAT(fault({{"goal_radius_m", "90"}}), says("allowed: more than goal_radius_m, 90 m"));
  EXPECT_THAT(fault({{"planner.decision_s", "0.7"}}),
              says("--set planner.decision_s: planner.decision_s is 0.7 s; allowed: a whole number of steps of 0.5 s"));
  EXPECT_THAT(fault({{"planner.cell_m", "0.4"}}), says("smaller than a vehicle; allowed: at least 0.5 m"));
  EXPECT_THAT(fault({{"planner.cell_m", "50"}}), says("area is smaller than a cell"));
  EXPECT_THAT(fault({{"planner.patience", "1.5"}}), says("allowed: whole numbers"));
  EXPECT_THAT(fault({{"area.x_max_m", "1e6"}, {"area.y_max_m", "1e6"}}), says("allowed: at most 1000000"));
  EXPECT_THAT(fault({{"hidden_obstacles", "[{file: none.obj, x_m: 1, y_m: 1, z_m: 1}]"}}), says("cannot be read"));
  EXPECT_THAT(fault({{"draw", "{from: connected}"},
                     {"hidden_obstacles.1.y_max_m", "41"},
                     {"hidden_obstacles.1.x_min_m", "-1"},
                     {"hidden_obstacles.1.x_max_m", "90"}}),
              says("draw finds no starts and goals for 2 vehicles"));
  EXPECT_THAT(fault({{"forest", "{trees: 5, density_per_m2: 0.1, radius_min_m: 1, radius_max_m: 2}"}}),
              says("no density beside forest.trees"));
  EXPECT_THAT(fault({{"formation", "{}"}}), says("unknown key 'formation'"));
  EXPECT_THAT(fault({{"vehicles.type", "multirotor"}}), says("allowed: holonomic"));
}

}  // namespace
}  // namespace skein::test
