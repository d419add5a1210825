// peach and peach3d-paper: what Algorithms 1 to 3 do on small maps.
#include <gtest/gtest.h>

#include "planner/gridnav/steer/potential_table.hpp"
#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

Task task_on(const CellGrid& grid, const Cell& goal) {
  Task task;
  task.grid = grid;
  task.goal_m = grid.centre_m(goal);
  task.radius_m = 0.25;
  task.step_m = 10.0;
  task.sensor_range_m = 24.0;
  return task;
}

TEST(PotentialTable, AddsGoalObstaclesRaisesAndNeighbours) {
  const CellGrid grid{Vec3::Zero(), 2, 2, 10, 10, 1};
  PotentialTable table(task_on(grid, {9, 5, 0}));
  const CellIndex at = grid.index_of({5, 2, 0});
  EXPECT_DOUBLE_EQ(table.sum(at), 5.0);  // a 3-4-5 triangle
  const std::vector<CellChange> two{{grid.index_of({5, 3, 0}), CellState::Occupied},
                                    {grid.index_of({6, 3, 0}), CellState::Occupied}};
  EXPECT_TRUE(table.learn(two));
  EXPECT_DOUBLE_EQ(table.sum(at), 10.0) << "alpha / 2 once";
  table.raise(at, 3.0);
  EXPECT_DOUBLE_EQ(table.sum(at), 13.0);
  Other other;
  other.next_m = grid.centre_m({4, 1, 0});
  table.avoid(grid.centre_m({5, 2, 0}), std::vector<Other>{other});
  EXPECT_DOUBLE_EQ(table.sum(at), 23.0);
  const std::vector<CellChange> marked{{grid.index_of({1, 5, 0}), CellState::Revisited}};
  EXPECT_FALSE(table.learn(marked));
  EXPECT_DOUBLE_EQ(table.sum(grid.index_of({1, 5, 0})), 13.0);
}

class PaperPlanner : public testing::TestWithParam<const char*> {};

TEST_P(PaperPlanner, FliesStraightWhereNothingIs) {
  Conditions conditions;
  conditions.planner = GetParam();
  const Outcome outcome = fly(drawn({"a..............A"}, 4.0), conditions);
  EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived);
  EXPECT_NEAR(outcome.flights[0].length_m, 60.0, 1.0);
}

TEST_P(PaperPlanner, LeavesADeadEnd) {
  Conditions conditions;
  conditions.planner = GetParam();
  const Outcome outcome = fly(drawn({"............", "....####....", ".......#....", "a......#...A", ".......#....",
                                     "....####....", "............"},
                                    4.0),
                              conditions);
  EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived) << outcome.decisions;
  EXPECT_EQ(outcome.hits, 0u);
}

TEST_P(PaperPlanner, NineNeverTouchAndMostArrive) {
  int arrived = 0;
  for (const double cell_m : {2.0, 4.0, 6.0}) {
    Conditions conditions;
    conditions.planner = GetParam();
    const Outcome outcome = fly(power_station(cell_m, 9), conditions);
    EXPECT_GE(outcome.closest_m, 0.5);
    EXPECT_EQ(outcome.hits, 0u);
    arrived += outcome.count(NavStatus::Arrived);
  }
  EXPECT_GE(arrived, 24);
}

INSTANTIATE_TEST_SUITE_P(Names, PaperPlanner, testing::Values("peach", "peach3d-paper"));

}  // namespace
}  // namespace skein::gridnav
