// What nobody is told of, as scenarios say it: movers, announced zones, slow vehicles, controllers.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include "simworld/movers/appearance.hpp"
#include "simworld/movers/movers.hpp"

#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

using Overrides = std::vector<Override>;

const Override kSensor{"sensor", "{range_m: 24}"};

Scenario small_with(const Overrides& overrides) {
  return scenario_of(load_small(overrides));
}

std::string fault_of(const Overrides& overrides) {
  return fault_line(load_small(overrides));
}

Mover only_mover(const std::string& list, const std::string& item) {
  const Scenario scenario = small_with({kSensor, {list, "[" + item + "]"}});
  EXPECT_EQ(scenario.world.surprises.movers.size(), 1U);
  return scenario.world.surprises.movers.empty() ? Mover{} : scenario.world.surprises.movers[0];
}

TEST(SurpriseSections, LinesAndShapes) {
  const Mover sphere = only_mover("moving_obstacles", "{x_m: 1, y_m: 500, z_m: 3, radius_m: 2, vx_mps: 4, vy_mps: -5}");
  EXPECT_EQ(sphere.name, "moving_obstacles.1");
  EXPECT_EQ(sphere.position_m, Vec3(1, 500, 3));
  EXPECT_FALSE(sphere.column);
  EXPECT_FALSE(sphere.sudden);
  EXPECT_EQ(std::get<LineMotion>(sphere.motion).velocity_mps, Vec3(4, -5, 0));
  EXPECT_TRUE(only_mover("moving_obstacles", "{x_m: 1, y_m: 500, radius_m: 2, vx_mps: 4, vy_mps: 0}").column);
}

TEST(SurpriseSections, LoopsAndWalks) {
  const Mover loop = only_mover("moving_obstacles",
                                "{x_m: 1, y_m: 500, z_m: 3, radius_m: 2, speed_mps: 6, waypoints: [{x_m: 9, y_m: 500, "
                                "z_m: 3}, {x_m: 9, y_m: 600, z_m: 3}]}");
  EXPECT_EQ(std::get<LoopMotion>(loop.motion).waypoints_m.size(), 3U);
  EXPECT_EQ(speed_of(loop), 6.0);
  const Mover walk =
      only_mover("moving_obstacles",
                 "{x_m: 1, y_m: 500, radius_m: 2, speed_mps: 6, turn_s: 4, within: {x_min_m: 0, y_min_m: "
                 "400, x_max_m: 9, y_max_m: 600}}");
  EXPECT_EQ(std::get<WalkMotion>(walk.motion).turn_s, 4.0);
  EXPECT_EQ(std::get<WalkMotion>(walk.motion).within.min_m.y(), 400.0);
}

TEST(SurpriseSections, SuddenOnes) {
  const Mover timed = only_mover("sudden_obstacles", "{x_m: 1, y_m: 0, radius_m: 2, at_s: 7}");
  EXPECT_TRUE(timed.sudden) << "it may be where a vehicle starts: it waits";
  EXPECT_EQ(timed.at_s, 7.0);
  EXPECT_EQ(only_mover("sudden_obstacles", "{x_m: 1, y_m: 0, radius_m: 2, near_m: 90}").near_m, 90.0);
  const Mover ahead =
      only_mover("sudden_obstacles", "{radius_m: 2, ahead: {agent: 2, distance_m: 60, at_s: 9, column: 1}}");
  EXPECT_EQ(ahead.ahead, (AheadOf{2, 60.0}));
  EXPECT_EQ(ahead.at_s, 9.0);
  EXPECT_TRUE(ahead.column);
  EXPECT_EQ(only_mover("sudden_obstacles", "{radius_m: 2, ahead: {distance_m: 60, at_s: 9}}").ahead->agent, 0U);
}

TEST(SurpriseSections, TheSeedDrawsTimesOfAhead) {
  const Overrides timed{
      kSensor,
      {"sudden_obstacles",
       "[{radius_m: 2, ahead: {distance_m: 60, at_s: 5, at_latest_s: 25}}, {radius_m: 2, ahead: {distance_m: 60, at_s: "
       "5, at_latest_s: 25}}]"}};
  const Scenario first = small_with(timed);
  double least_s = 25.0;
  double most_s = 5.0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const std::vector<Mover> movers = scenario_of(with_seed(first, seed)).world.surprises.movers;
    ASSERT_EQ(movers.size(), 2U);
    EXPECT_NE(movers[0].at_s, movers[1].at_s);
    least_s = std::min(least_s, movers[0].at_s);
    most_s = std::max(most_s, movers[0].at_s);
  }
  EXPECT_GE(least_s, 5.0);
  EXPECT_LT(least_s, 7.0);
  EXPECT_GT(most_s, 23.0);
  EXPECT_LE(most_s, 25.0);
}

TEST(SurpriseSections, CrossingOnesMove) {
  const Mover mover =
      only_mover("moving_obstacles", "{radius_m: 2, ahead: {distance_m: 60, at_s: 5, crossing_mps: 4}}");
  EXPECT_TRUE(mover.ahead->crosses);
  EXPECT_EQ(speed_of(mover), 4.0);
}

TEST(SurpriseSections, RandomOnesFollowTheSeedAndKeepClear) {
  const Overrides crowd{kSensor,
                        {"random_obstacles",
                         "{count: 10, speed_min_mps: 1, speed_max_mps: 5, radius_min_m: 0.5, radius_max_m: 2, clear_m: "
                         "30, within: {x_min_m: -100, y_min_m: -100, x_max_m: 100, y_max_m: 100}}"}};
  const Scenario first = small_with(crowd);
  const std::vector<Mover>& movers = first.world.surprises.movers;
  ASSERT_EQ(movers.size(), 10U);
  int straight = 0;
  for (const Mover& mover : movers) {
    EXPECT_TRUE(mover.column);
    EXPECT_GE(mover.radius_m, 0.5);
    EXPECT_LE(mover.radius_m, 2.0);
    EXPECT_GE(speed_of(mover), 1.0);
    EXPECT_LE(speed_of(mover), 5.0);
    EXPECT_GT(distance_m(Vec3::Zero(), mover.position_m, true), 30.0 + mover.radius_m + 2.0)
        << "vehicle 1 starts there";
    straight += std::get<WalkMotion>(mover.motion).turn_s > 1e6 ? 1 : 0;
  }
  EXPECT_GT(straight, 0);
  EXPECT_LT(straight, 10);
  EXPECT_EQ(small_with(crowd).world, first.world);
  const Scenario other = scenario_of(with_seed(first, 99));
  EXPECT_NE(other.world.surprises.movers, movers);
  EXPECT_EQ(scenario_of(with_seed(other, 7)).world, first.world);
}

TEST(SurpriseSections, AnnouncedZonesAndWhatIsNotAnnounced) {
  const Scenario scenario = small_with(
      {{"announced",
        "[{x_m: 1, y_m: 2, radius_m: 30, z_max_m: 80, from_s: 100, to_s: 130, early_s: 10, late_s: 60, clear_s: 8, "
        "aircraft: {radius_m: 5, from: {x_m: 0, y_m: 0}, to: {x_m: 9, y_m: 0, z_m: 60}}}, "
        "{x_min_m: 0, y_min_m: 0, x_max_m: 5, y_max_m: 5, from_s: 1, to_s: 2}]"}});
  ASSERT_EQ(scenario.mission.announced.size(), 2U);
  const Announcement& zone = scenario.mission.announced[0];
  EXPECT_EQ(std::get<Cylinder>(zone.shape).z_max_m, 80.0);
  EXPECT_EQ(zone.from_s, 100.0);
  EXPECT_EQ(zone.to_s, 130.0);
  EXPECT_EQ(zone.early_s, 10.0);
  EXPECT_EQ(zone.clear_s, 8.0);
  EXPECT_TRUE(std::holds_alternative<Box>(scenario.mission.announced[1].shape));
  const std::vector<Traffic>& traffic = scenario.world.surprises.traffic;
  ASSERT_EQ(traffic.size(), 2U);
  EXPECT_EQ(traffic[0].late_s, 60.0);
  EXPECT_EQ(traffic[0].aircraft, (Aircraft{5.0, Vec3(0, 0, 0), Vec3(9, 0, 60)}));
  EXPECT_FALSE(traffic[1].aircraft);
}

TEST(SurpriseSections, ControllerSensorAndSlowVehicles) {
  const Scenario scenario = small_with(
      {kSensor, {"controller", "{name: orca, margin_m: 0.5}"}, {"world.slow", "[{id: 2, factor: 0.8, from_s: 5}]"}});
  EXPECT_EQ(scenario.mission.controller.name, "orca");
  EXPECT_EQ(scenario.mission.controller.margin_m, 0.5);
  EXPECT_EQ(scenario.mission.controller.sensor_range_m, 24.0);
  EXPECT_EQ(scenario.world.surprises.slow, (std::vector<SlowVehicle>{{2, 0.8, 5.0}}));
  EXPECT_EQ(small_with({}).mission.controller, ControllerOptions{});
}

TEST(SurpriseSections, ThePageNamesEveryControllerOption) {
  const std::string page = text_of(SKEIN_SOURCE_DIR "/docs/scenario.md");
  for (const auto& field : kControllerFields) {
    if (field.key == "sensor_range_m") continue;
    const std::string_view unit = field.unit.empty() ? "-" : field.unit;
    const std::string row = fmt::format("| `controller.{}` | {} | {} to {} | {} |", field.key, unit, field.min,
                                        field.max, ControllerOptions{}.*field.member);
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

struct Refused {
  const char* name;
  Overrides overrides;
  const char* line;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.name;
}

class RefusedSurprise : public testing::TestWithParam<Refused> {};

TEST_P(RefusedSurprise, IsNamed) {
  EXPECT_EQ(fault_of(GetParam().overrides), GetParam().line);
}

const Override kSmallWalk{"moving_obstacles", "[{x_m: 1, y_m: 500, radius_m: 2, vx_mps: 4, vy_mps: 0}]"};

const Refused kRefused[] = {
    {"Unseen",
     {kSmallWalk},
     "--set moving_obstacles: moving_obstacles that nobody can see; allowed: with sensor.range_m of more than 0 m"},
    {"StillMover",
     {kSensor, {"moving_obstacles", "[{x_m: 1, y_m: 500, radius_m: 2}]"}},
     "--set moving_obstacles: moving_obstacles.1 does not move; allowed: with vx_mps and vy_mps, with waypoints, or "
     "with "
     "turn_s"},
    {"KeyOfAnotherMotion",
     {kSensor, {"moving_obstacles", "[{x_m: 1, y_m: 500, radius_m: 2, vx_mps: 4, vy_mps: 0, turn_s: 3}]"}},
     "--set moving_obstacles: moving_obstacles.1.turn_s is 3; allowed: no such key of what flies a line"},
    {"NotSudden",
     {kSensor, {"sudden_obstacles", "[{x_m: 1, y_m: 500, radius_m: 2}]"}},
     "--set sudden_obstacles: sudden_obstacles.1 is not sudden; allowed: with at_s, near_m or ahead"},
    {"OnAStart",
     {kSensor, {"moving_obstacles", "[{x_m: 3, y_m: 0, radius_m: 2, vx_mps: 4, vy_mps: 0}]"}},
     "--set moving_obstacles: moving_obstacles.1.x_m is 3; allowed: more than 4 m from the start of vehicle 1, their "
     "radii"},
    {"NoSuchUav",
     {kSensor, {"sudden_obstacles", "[{radius_m: 2, ahead: {agent: 7, distance_m: 60, at_s: 9}}]"}},
     "--set sudden_obstacles: sudden_obstacles.1.ahead.agent is 7; allowed: the id of a vehicle, or 0: one that the "
     "seed "
     "draws"},
    {"AheadAndAPlace",
     {kSensor, {"sudden_obstacles", "[{radius_m: 2, x_m: 4, ahead: {distance_m: 60, at_s: 9}}]"}},
     "--set sudden_obstacles: sudden_obstacles.1.x_m is 4; allowed: no such key beside ahead"},
    {"NoRoom",
     {kSensor,
      {"random_obstacles",
       "{count: 1, speed_max_mps: 5, radius_min_m: 0.5, radius_max_m: 2, clear_m: 300, within: {x_min_m: -100, "
       "y_min_m: "
       "-100, x_max_m: 100, y_max_m: 100}}"}},
     "--set random_obstacles: random_obstacles finds no room for 1 obstacles that are 300 m clear of starts and goals; "
     "allowed: fewer, a larger box, or less clear_m"},
    {"EndsBeforeItBegins",
     {{"announced", "[{x_m: 1, y_m: 2, radius_m: 30, from_s: 100, to_s: 100}]"}},
     "--set announced: announced.1.to_s is 100; allowed: more than from_s, 100 s"},
    {"SlowStranger",
     {{"world.slow", "[{id: 9, factor: 0.8}]"}},
     "--set world.slow: world.slow.1 is of vehicle 9, which there is not; allowed: the id of a vehicle"},
    {"NoController",
     {{"controller.name", "peach"}},
     "--set controller.name: controller.name is 'peach'; allowed: apf, orca"},
    {"SensorRangeOfTheController",
     {{"controller.sensor_range_m", "3"}},
     "--set controller.sensor_range_m: unknown key 'sensor_range_m' in controller; allowed: name, filter, "
     "obstacle_speed_mps, margin_m, horizon_s, deviation_m"},
};

INSTANTIATE_TEST_SUITE_P(Lines, RefusedSurprise, testing::ValuesIn(kRefused),
                         [](const auto& refused) { return refused.param.name; });

TEST(SurpriseSections, ATransitByCellsHasNone) {
  const Overrides moving{kSmallWalk};
  EXPECT_EQ(fault_line(load_scenario(kDataDir + "small-transit.yaml", moving, std::nullopt)),
            "--set moving_obstacles: moving_obstacles in a transit by cells; allowed: with planner.name straight");
}

}  // namespace
}  // namespace skein::test
