#include "planner/gridnav/field/goal_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "planner/core/random/random_stream.hpp"

namespace skein::gridnav {
namespace {

/// All values from nothing, by Dijkstra over the field's own moves.
std::vector<Cost> from_nothing(const CellGrid& grid, const Cell& goal, const std::vector<bool>& blocked) {
  GoalField field(grid, goal, goal);
  for (CellIndex n = 0; n < grid.size(); ++n) field.set_blocked(n, blocked[n]);
  std::vector<Cost> best(grid.size(), kInfinite);
  using Item = std::pair<Cost, CellIndex>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  queue.push({0, grid.index_of(goal)});
  best[grid.index_of(goal)] = 0;
  std::vector<GoalField::Step> steps;
  while (!queue.empty()) {
    const auto [cost, cell] = queue.top();
    queue.pop();
    if (cost > best[cell]) continue;
    field.steps_from(cell, steps);
    for (const GoalField::Step& step : steps) {
      if (cost + step.cost >= best[step.cell]) continue;
      best[step.cell] = cost + step.cost;
      queue.push({best[step.cell], step.cell});
    }
  }
  return best;
}

TEST(GoalField, CountsMovesByTheirLength) {
  GoalField field({Vec3::Zero(), 2.0, 2.0, 5, 4, 1}, {4, 3, 0}, {0, 0, 0});
  EXPECT_EQ(field.value(0), 3u * 1448u + 1024u);
  EXPECT_NEAR(field.metres(field.value(0)), 2.0 * (3 * std::sqrt(2.0) + 1), 1e-2);
  EXPECT_EQ(field.value(field.goal()), 0u);
}

TEST(GoalField, CutsNoCorner) {
  // Of the two cells beside the diagonal one is blocked: the way leads past the other.
  GoalField field({Vec3::Zero(), 1.0, 1.0, 2, 2, 1}, {1, 1, 0}, {0, 0, 0});
  field.set_blocked(1, true);
  EXPECT_EQ(field.value(0), 2048u);
  field.set_blocked(2, true);
  EXPECT_EQ(field.value(0), kInfinite);
  field.set_blocked(2, false);
  EXPECT_EQ(field.value(0), 2048u);
}

TEST(GoalField, BlockedGoalIsOutOfReach) {
  GoalField field({Vec3::Zero(), 1.0, 1.0, 3, 1, 1}, {2, 0, 0}, {0, 0, 0});
  EXPECT_EQ(field.value(0), 2048u);
  field.set_blocked(2, true);
  EXPECT_EQ(field.value(0), kInfinite);
}

TEST(GoalField, LevelsCountByTheirHeight) {
  GoalField field({Vec3::Zero(), 2.0, 4.0, 2, 2, 3}, {0, 0, 2}, {0, 0, 0});
  EXPECT_EQ(field.value(0), 4u * 1024u);
}

void expect_repair_equals_rebuild(std::uint64_t seed, const CellGrid& grid) {
  RandomStream stream(seed, 0, Purpose::Test, 40);
  const auto any_cell = [&] { return grid.cell_at(static_cast<CellIndex>(stream.below(grid.size()))); };
  const Cell goal = any_cell();
  GoalField field(grid, goal, any_cell());
  std::vector<bool> blocked(grid.size(), false);
  const double density = stream.uniform(0.1, 0.6);
  for (int round = 0; round < 30; ++round) {
    const std::uint64_t changes = stream.below(round % 3 == 0 ? grid.size() / 4 : 4) + 1;
    for (std::uint64_t n = 0; n < changes; ++n) {
      const auto cell = static_cast<CellIndex>(stream.below(grid.size()));
      blocked[cell] = stream.uniform() < density;
      field.set_blocked(cell, blocked[cell]);
    }
    const std::vector<Cost> expected = from_nothing(grid, goal, blocked);
    const CellIndex start = grid.index_of(any_cell());
    field.move_start(start);
    ASSERT_EQ(field.value(start), expected[start]) << "seed " << seed << " round " << round;
    for (int asked = 0; asked < 5; ++asked) {
      const CellIndex cell = grid.index_of(any_cell());
      ASSERT_EQ(field.value(cell), expected[cell]) << "seed " << seed << " round " << round << " cell " << cell;
    }
  }
}

TEST(GoalField, RepairedEqualsFromNothing) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) expect_repair_equals_rebuild(seed, {Vec3::Zero(), 2, 2, 23, 17, 1});
}

TEST(GoalField, RepairedEqualsFromNothingInSpace) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) expect_repair_equals_rebuild(seed, {Vec3::Zero(), 2, 3, 9, 8, 5});
}

TEST(GoalField, AFarChangeCostsNothing) {
  const CellGrid grid{Vec3::Zero(), 2, 2, 125, 125, 1};
  GoalField field(grid, {124, 62, 0}, {60, 62, 0});
  EXPECT_LT(field.value(grid.index_of({60, 62, 0})), kInfinite);
  const std::uint64_t before = field.expanded();
  field.set_blocked(grid.index_of({3, 3, 0}), true);
  EXPECT_LT(field.value(grid.index_of({60, 62, 0})), kInfinite);
  EXPECT_EQ(field.expanded(), before);
}

}  // namespace
}  // namespace skein::gridnav
