// --set KEY=VALUE: what it changes, and that a fault in it names the override and not the file.
#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

TEST(Overrides, ReplaceAValueOfTheFile) {
  EXPECT_EQ(scenario_of(load_small({{"vehicles.speed_mps", "30"}})).mission.vehicles[1].speed_mps, 30.0);
}

TEST(Overrides, AddAKeyAndItsSection) {
  const Scenario scenario = scenario_of(load_small({{"world.max_steps", "12"}, {"planner.generations", "9"}}));
  EXPECT_EQ(scenario.world.max_steps, 12U);
  EXPECT_EQ(scenario.mission.planner.generations, 9);
}

TEST(Overrides, NameListItemsByIdElseByPlace) {
  const Scenario scenario =
      scenario_of(load_small({{"vehicles.starts.2.x_m", "-250"}, {"obstacles.1.radius_m", "10"}}));
  EXPECT_EQ(scenario.mission.vehicles[1].start.position_m.x(), -250.0);
  EXPECT_EQ(std::get<Cylinder>(scenario.mission.zones[0].shape).radius_m, 10.0);
}

TEST(Overrides, TakeWholeListsAndMaps) {
  const Scenario scenario = scenario_of(
      load_small({{"obstacles", "[]"}, {"no_fly", "[{x_min_m: 1, y_min_m: 2000, x_max_m: 3, y_max_m: 4000}]"}}));
  ASSERT_EQ(scenario.mission.zones.size(), 1U);
  EXPECT_EQ(std::get<Box>(scenario.mission.zones[0].shape).max_m.y(), 4000.0);
}

TEST(Overrides, OfOneKeyTheLastWins) {
  EXPECT_EQ(scenario_of(load_small({{"step_s", "1"}, {"step_s", "2"}})).mission.step_s, 2.0);
}

TEST(Overrides, EnterTheScenarioHashAndNotTheText) {
  const Scenario plain = scenario_of(load_small({}));
  const Scenario changed = scenario_of(load_small({{"step_s", "2"}}));
  EXPECT_NE(plain.scenario_hash, changed.scenario_hash);
  EXPECT_EQ(plain.text, changed.text);
}

Scenario transit_with(const std::vector<Override>& overrides) {
  return scenario_of(load_scenario(kDataDir + "small-transit.yaml", overrides, std::nullopt));
}

TEST(FlagOverrides, AgentsAreTheVehiclesOfATransitOrOfARing) {
  EXPECT_EQ(transit_with({}).mission.vehicles.size(), 2U);
  const Mission one = transit_with({{std::string(kAgentsFlag), "1"}}).mission;
  ASSERT_EQ(one.vehicles.size(), 1U);
  EXPECT_EQ(one.vehicles[0].id, 1U);
  EXPECT_EQ(one.transit->goals_m.size(), 1U);
  const ScenarioResult ring =
      load_scenario(kScenarioDir + "rendezvous-ring.yaml", std::vector<Override>{{"--agents", "7"}}, std::nullopt);
  EXPECT_EQ(scenario_of(ring).mission.vehicles.size(), 7U);
}

TEST(FlagOverrides, TheControllerIsThatOfEveryKind) {
  EXPECT_EQ(transit_with({}).mission.controller.name, "apf");
  EXPECT_EQ(transit_with({{std::string(kControllerFlag), "orca"}}).mission.controller.name, "orca");
  EXPECT_EQ(scenario_of(load_small({{"--controller", "orca"}})).mission.controller.name, "orca");
  EXPECT_EQ(fault_line(load_small({{"--controller", "peach"}})),
            "--set controller.name: controller.name is 'peach'; allowed: apf, orca");
}

TEST(FlagOverrides, ExtraStepsAreOfTheWorld) {
  EXPECT_EQ(transit_with({}).world.extra_steps, 0U);
  EXPECT_EQ(transit_with({{"world.extra_steps", "12"}}).world.extra_steps, 12U);
}

struct Refused {
  const char* name;
  std::vector<Override> overrides;
  const char* line;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.name;
}

class RefusedOverride : public testing::TestWithParam<Refused> {};

TEST_P(RefusedOverride, IsNamed) {
  EXPECT_EQ(fault_line(load_small(GetParam().overrides)), GetParam().line);
}

const Refused kRefused[] = {
    {"ExtraStepsUnderNone",
     {{"world.extra_steps", "-1"}},
     "--set world.extra_steps: world.extra_steps is -1; allowed: a whole number from 0 to 10000000"},
    {"UnknownKey",
     {{"vehicles.speed", "3"}},
     "--set vehicles.speed: unknown key 'speed' in vehicles; allowed: type, speed_mps, max_curvature_per_m, "
     "max_torsion_per_m, radius_m, "
     "safety_radius_m, on_agent_loss, starts, ring, max_acceleration_mps2"},
    {"MisspeltSection",
     {{"plannr.particles", "3"}},
     "--set plannr.particles: unknown key 'plannr'; did you mean 'planner'?"},
    {"OutOfRange",
     {{"planner.particles", "1"}},
     "--set planner.particles: planner.particles is 1; allowed: a whole number from 2 to 10000"},
    {"WrongType", {{"step_s", "soon"}}, "--set step_s: step_s is 'soon'; allowed: a number from 0.001 to 60 s"},
    {"NoValue", {{"step_s", ""}}, "--set step_s: step_s is empty; allowed: a number from 0.001 to 60 s"},
    {"EmptyKey",
     {{"", "1"}},
     "--set '': the key has an empty part; allowed: words joined by dots, such as planner.particles"},
    {"EmptyPart",
     {{"planner..particles", "1"}},
     "--set planner..particles: the key has an empty part; allowed: words joined by dots, such as planner.particles"},
    {"TrailingDot",
     {{"planner.", "1"}},
     "--set planner.: the key has an empty part; allowed: words joined by dots, such as planner.particles"},
    {"NoSuchItem",
     {{"vehicles.starts.7.x_m", "1"}},
     "--set vehicles.starts.7.x_m: vehicles.starts has no item '7'; allowed: 1, 2"},
    {"ItemOfEmptyList",
     {{"obstacles", "[]"}, {"obstacles.1.x_m", "1"}},
     "--set obstacles.1.x_m: obstacles has no item '1'; allowed: none, the list is empty"},
    {"PartOfAValue",
     {{"step_s.x", "1"}},
     "--set step_s.x: step_s is a single value and has no part 'x'; allowed: --set step_s=VALUE"},
    {"BadYaml",
     {{"obstacles", "[1"}},
     "--set obstacles: a key is a list or a map (is a bracket open?); allowed: a word before the colon"},
    {"Alias",
     {{"step_s", "*x"}},
     "--set step_s: not valid YAML: the referenced anchor is not defined; allowed: the form of docs/scenario.md"},
    {"LineBreakInKey",
     {{"a\nb", "1"}},
     "--set a\\x0ab: unknown key 'a\\x0ab'; allowed: name, kind, seed, length_unit_m, step_s, arrival_radius_m, "
     "vehicles, formation, obstacles, no_fly, terrain, planner, lockstep, world, sensor, controller, moving_obstacles, "
     "sudden_obstacles, random_obstacles, announced"},
    {"StartMovedIntoAnObstacle",
     {{"vehicles.starts.1.x_m", "4000"}, {"vehicles.starts.1.y_m", "500"}},
     "--set vehicles.starts.1.x_m: the start of vehicle 1 is 300 m inside obstacles.1; allowed: more than 2 m from it, "
     "its radius"},
    {"StartMovedToAnother",
     {{"vehicles.starts.1.y_m", "999"}},
     "--set vehicles.starts.1.y_m: the starts of vehicles 1 and 2 are 1 m apart; allowed: at least 200 m, their safety "
     "radii together"},
    {"PlannerBoundsCrossed",
     {{"planner.search_max_chords", "0.01"}, {"planner.search_min_chords", "0.02"}},
     "--set planner.search_min_chords: planner.search_min_chords is 0.02; allowed: less than search_max_chords, 0.01"},
};

INSTANTIATE_TEST_SUITE_P(Lines, RefusedOverride, testing::ValuesIn(kRefused),
                         [](const auto& refused) { return refused.param.name; });

}  // namespace
}  // namespace skein::test
