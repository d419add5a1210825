// Transits without cells: points given, drawn, or swapped over a sphere.
#include <algorithm>
#include <cmath>

#include "tests/simworld/scenario/scenarios.hpp"

namespace skein::test {
namespace {

using Overrides = std::vector<Override>;

constexpr const char* kText = R"(name: straight
kind: transit
seed: 3
step_s: 0.1
goal_radius_m: 1
vehicles:
  type: multirotor
  speed_mps: 10
  max_acceleration_mps2: 4
  radius_m: 0.5
  safety_radius_m: 1
  starts:
    - {id: 1, x_m: -40, y_m: 0.3, z_m: 17.2}
    - {id: 2, x_m: 40, y_m: 0}
area: {x_min_m: -60, y_min_m: -60, z_min_m: 0, x_max_m: 60, y_max_m: 60, z_max_m: 120}
goals:
  - {id: 1, x_m: 40, y_m: 1}
  - {id: 2, x_m: -40, y_m: 1}
sensor: {range_m: 30}
planner: {name: straight}
)";

/// Without starts and goals.
std::string bare_text() {
  std::string text = kText;
  text.erase(text.find("  starts:"), text.find("area:") - text.find("  starts:"));
  text.erase(text.find("goals:"), text.find("sensor:") - text.find("goals:"));
  return text;
}

ScenarioResult read_text(const std::string& text, const Overrides& overrides, std::optional<std::uint64_t> seed = {}) {
  return parse_scenario(text, "f", overrides, seed);
}

Override swap_of(int agents) {
  return {"vehicles.swap", "{agents: " + std::to_string(agents) + ", radius_m: 45, x_m: 0, y_m: 0, z_m: 60}"};
}

TEST(Straight, GivenPlacesAreTakenAsTheyAre) {
  const Mission mission = scenario_of(read_text(kText, {})).mission;
  ASSERT_EQ(mission.vehicles.size(), 2U);
  EXPECT_EQ(mission.vehicles[0].start.position_m, Vec3(-40, 0.3, 17.2));
  EXPECT_EQ(mission.vehicles[1].start.position_m, Vec3(40, 0, 60)) << "the middle of the area's height";
  EXPECT_EQ(mission.transit->goals_m[0], Vec3(40, 1, 60));
  EXPECT_EQ(mission.vehicles[0].type, VehicleType::Multirotor);
  EXPECT_EQ(mission.vehicles[0].max_acceleration_mps2, 4.0);
  EXPECT_EQ(mission.controller.sensor_range_m, 30.0) << "what has no map senses bodies";
}

TEST(Straight, DrawnPlacesKeepTheirDistancesAndFollowTheSeed) {
  const Overrides draw{
      {"draw", "{from: free}"}, {"vehicles.agents", "20"}, {"obstacles", "[{x_m: 0, y_m: 0, radius_m: 40}]"}};
  Vec3 first_m = Vec3::Zero();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scenario scenario = scenario_of(read_text(bare_text(), draw, seed));
    const Mission& mission = scenario.mission;
    ASSERT_EQ(mission.vehicles.size(), 20U);
    for (std::size_t i = 0; i < 20; ++i) {
      const Vec3& start_m = mission.vehicles[i].start.position_m;
      EXPECT_GT(start_m.head<2>().norm(), 41.0);
      EXPECT_GT((mission.transit->goals_m[i] - start_m).norm(), 1.0);
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT((mission.vehicles[j].start.position_m - start_m).norm(), 2.0);
    }
    EXPECT_NE(mission.vehicles[0].start.position_m, first_m);
    first_m = mission.vehicles[0].start.position_m;
    EXPECT_EQ(scenario_of(with_seed(scenario, seed)).mission, mission);
  }
}

TEST(Straight, ASwarmSwapsItsPlacesOverASphere) {
  for (const int agents : {2, 4, 8, 16, 32, 64}) {
    const Mission mission = scenario_of(read_text(bare_text(), {swap_of(agents)})).mission;
    const auto count = static_cast<std::size_t>(agents);
    ASSERT_EQ(mission.vehicles.size(), count);
    const Vec3 centre_m(0, 0, 60);
    double least_m = 1e9;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 start_m = mission.vehicles[i].start.position_m - centre_m;
      EXPECT_NEAR(start_m.norm(), 45.0, 1e-9);
      const Vec3 partner_m = mission.vehicles[(i + count / 2) % count].start.position_m - centre_m;
      EXPECT_LT((partner_m + start_m).norm(), 1e-9);
      const Vec3 off_m = mission.transit->goals_m[i] - centre_m + start_m;
      EXPECT_GT(off_m.norm(), 0.0);
      EXPECT_LE(off_m.cwiseAbs().maxCoeff(), 0.45 + 1e-9);
      for (std::size_t j = 0; j < i; ++j) {
        least_m = std::min(least_m, (mission.vehicles[j].start.position_m - centre_m - start_m).norm());
      }
    }
    EXPECT_GT(least_m, 0.6 * 45.0 * std::sqrt(4.0 * 3.14159 / agents)) << agents << " spread evenly";
  }
}

TEST(Straight, ASwapIsTurnedByTheSeed) {
  const Scenario first = scenario_of(read_text(bare_text(), {swap_of(4)}, 1));
  const Scenario second = scenario_of(with_seed(first, 2));
  EXPECT_GT((first.mission.vehicles[0].start.position_m - second.mission.vehicles[0].start.position_m).norm(), 1.0);
  EXPECT_EQ(scenario_of(with_seed(second, 1)).mission, first.mission);
}

TEST(Straight, TheFlagOfAgentsIsThatOfTheSwap) {
  const Overrides set{swap_of(4), {std::string(kAgentsFlag), "16"}};
  EXPECT_EQ(scenario_of(read_text(bare_text(), set)).mission.vehicles.size(), 16U);
}

TEST(Straight, RandomObstaclesAreInTheArea) {
  const Scenario scenario = scenario_of(read_text(
      bare_text(),
      {swap_of(4), {"random_obstacles", "{count: 10, speed_max_mps: 5, radius_min_m: 0.5, radius_max_m: 2}"}}));
  ASSERT_EQ(scenario.world.surprises.movers.size(), 10U);
  for (const Mover& mover : scenario.world.surprises.movers) {
    EXPECT_FALSE(mover.column);
    EXPECT_EQ(std::get<WalkMotion>(mover.motion).within, scenario.mission.transit->area);
    for (const VehicleSpec& vehicle : scenario.mission.vehicles) {
      EXPECT_GT((vehicle.start.position_m - mover.position_m).norm(), 13.5 + 0.5 + mover.radius_m);
    }
  }
}

struct Refused {
  const char* name;
  bool bare;
  Overrides overrides;
  const char* line;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.name;
}

class RefusedStraight : public testing::TestWithParam<Refused> {};

TEST_P(RefusedStraight, IsNamed) {
  EXPECT_EQ(fault_line(read_text(GetParam().bare ? bare_text() : kText, GetParam().overrides)), GetParam().line);
}

const Refused kRefused[] = {
    {"Hidden",
     false,
     {{"hidden_obstacles", "[{x_m: 0, y_m: 0, radius_m: 1}]"}},
     "--set hidden_obstacles: hidden_obstacles with planner.name straight, which has no map; allowed: "
     "sudden_obstacles"},
    {"Holonomic",
     false,
     {{"vehicles.type", "holonomic"}},
     "--set vehicles.type: vehicles.type is 'holonomic'; allowed: multirotor"},
    {"Odd",
     true,
     {swap_of(5)},
     "--set vehicles.swap: vehicles.swap.agents is 5; allowed: an even number: pairs swap their places"},
    {"SwapAndStarts",
     false,
     {swap_of(4)},
     "f:13:5: vehicles.starts is a list; allowed: no such key beside vehicles.swap"},
    {"Crowded",
     true,
     {{"vehicles.swap", "{agents: 64, radius_m: 3, x_m: 0, y_m: 0, z_m: 60}"}},
     "--set vehicles.swap: vehicles 1 and 4 start 1.3877859285706455 m apart; allowed: at least 2 m, their safety "
     "radii "
     "together"},
    {"OutsideTheArea",
     false,
     {{"goals.1.x_m", "61"}},
     "--set goals.1.x_m: the goal of vehicle 1, (61, 1, 60), is outside the area; allowed: a point inside"},
    {"InAnObstacle",
     false,
     {{"obstacles", "[{x_m: 40, y_m: 1, radius_m: 1.2}]"}},
     "f:17:5: the goal of vehicle 1 is in an obstacle or no-fly zone; allowed: more than 0.5 m from it, its radius"},
    {"AtItsGoal",
     false,
     {{"goals.2.x_m", "40"}, {"goals.2.y_m", "0.5"}},
     "f:14:7: vehicle 2 starts 0.5 m from its goal; allowed: more than goal_radius_m, 1 m"},
    {"DrawByPaths",
     true,
     {{"draw", "{from: connected}"}, {"vehicles.agents", "2"}},
     "--set draw: draw.from is 'connected'; allowed: free, with planner.name straight"},
    {"SwapByCells",
     true,
     {swap_of(4), {"planner.name", "peach"}, {"vehicles.type", "holonomic"}, {"vehicles.max_acceleration_mps2", "4"}},
     "--set vehicles.max_acceleration_mps2: vehicles.max_acceleration_mps2 is 4; allowed: with planner.name straight"},
};

INSTANTIATE_TEST_SUITE_P(Lines, RefusedStraight, testing::ValuesIn(kRefused),
                         [](const auto& refused) { return refused.param.name; });

}  // namespace
}  // namespace skein::test
