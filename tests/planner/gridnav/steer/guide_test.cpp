// Around cells in which others are held, as long as there is a way.
#include "planner/gridnav/steer/guide.hpp"

#include <gtest/gtest.h>

#include "tests/planner/gridnav/swarm_world.hpp"

namespace skein::gridnav {
namespace {

struct Setting {
  explicit Setting(const std::vector<std::string>& rows, const std::string& planner = "peach3d")
      : layout(drawn(rows, 4.0)), map(layout.grid), guide(task(planner), layout.starts[0]) {
    for (CellIndex n = 0; n < layout.grid.size(); ++n)
      changes.push_back({n, layout.occupied[n] ? CellState::Occupied : CellState::Free});
    learn(changes);
  }
  Task task(const std::string& planner) const {
    Task task;
    task.grid = layout.grid;
    task.goal_m = layout.goals_m[0];
    task.goal_radius_m = 0.9;
    task.radius_m = 0.25;
    task.step_m = 10.0;
    task.sensor_range_m = 24.0;
    task.options.name = planner;
    return task;
  }
  bool learn(const std::vector<CellChange>& now) {
    for (const CellChange& change : now) map.set(change.cell, change.state);
    return guide.learn(map, now);
  }
  Guide::Around plan(const std::vector<Cell>& held) {
    std::vector<CellIndex> cells;
    cells.reserve(held.size());
    for (const Cell& cell : held) cells.push_back(layout.grid.index_of(cell));
    return guide.plan({map, layout.grid.centre_m(layout.starts[0]), Need::SeenFree, {}}, cells);
  }

  Layout layout;
  KnownMap map;
  Guide guide;
  std::vector<CellChange> changes;
};

const std::vector<std::string> kTwoWays{"......", ".####.", "a....A"};
constexpr double kStraight_m = 20.0;

TEST(Guide, GoesAroundOneWhoIsHeldAndBackWhenTheWayIsFree) {
  Setting setting(kTwoWays);
  EXPECT_NEAR(setting.plan({}).plan.to_go_m, kStraight_m, 1e-9);
  const Guide::Around around = setting.plan({{2, 0, 0}});
  EXPECT_NEAR(around.plan.to_go_m, kStraight_m + 16.0, 1e-9);
  EXPECT_TRUE(around.changed);
  EXPECT_FALSE(around.through);
  EXPECT_FALSE(setting.plan({{2, 0, 0}}).changed);
  EXPECT_TRUE(setting.plan({}).changed);
  EXPECT_NEAR(setting.plan({}).plan.to_go_m, kStraight_m, 1e-9);
}

TEST(Guide, ComesUpWhereNoWayLeadsAround) {
  Setting setting(kTwoWays);
  const Guide::Around through = setting.plan({{2, 0, 0}, {2, 2, 0}});
  EXPECT_TRUE(through.through);
  EXPECT_NEAR(through.plan.to_go_m, kStraight_m, 1e-9);
  EXPECT_FALSE(through.plan.options.empty());
  const Guide::Around again = setting.plan({{2, 0, 0}, {2, 2, 0}});
  EXPECT_TRUE(again.through);
  EXPECT_FALSE(again.changed);
  EXPECT_NEAR(setting.plan({{2, 0, 0}}).plan.to_go_m, kStraight_m + 16.0, 1e-9);
}

TEST(Guide, AWayThatTheMapOpensIsTaken) {
  Setting setting(kTwoWays);
  EXPECT_TRUE(setting.plan({{2, 0, 0}, {2, 2, 0}}).through);
  EXPECT_TRUE(setting.learn(
      {{6 + 1, CellState::Free}, {6 + 2, CellState::Free}, {6 + 3, CellState::Free}, {6 + 4, CellState::Free}}));
  const Guide::Around around = setting.plan({{2, 0, 0}, {2, 2, 0}});
  EXPECT_FALSE(around.through);
  EXPECT_GT(around.plan.to_go_m, kStraight_m);
}

TEST(Guide, AHeldCellStaysBlockedWhenItIsSeen) {
  Setting setting(kTwoWays);
  (void)setting.plan({{2, 0, 0}});
  EXPECT_TRUE(setting.learn({{2, CellState::Free}}));
  EXPECT_NEAR(setting.plan({{2, 0, 0}}).plan.to_go_m, kStraight_m + 16.0, 1e-9);
}

TEST(Guide, WithoutAWayAtAllItSaysSo) {
  Setting setting({"###", "a#A", "###"});
  const Guide::Around none = setting.plan({{2, 1, 0}});
  EXPECT_LT(none.plan.to_go_m, 0.0);
  EXPECT_FALSE(none.through);
}

TEST(Guide, PlannersWithoutPromisesAreLeftAlone) {
  Setting setting(kTwoWays, "peach");
  const Guide::Around around = setting.plan({{2, 0, 0}});
  EXPECT_FALSE(around.changed);
  EXPECT_FALSE(around.through);
}

}  // namespace
}  // namespace skein::gridnav
