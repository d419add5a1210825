#include "planner/gridnav/navigator.hpp"

#include <gtest/gtest.h>

#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

std::vector<CellChange> all_free(const CellGrid& grid) {
  std::vector<CellChange> changes;
  for (CellIndex n = 0; n < grid.size(); ++n) changes.push_back({n, CellState::Free});
  return changes;
}

TEST(Navigator, SaysFirstAndFliesThen) {
  const Layout layout = drawn({"a.........A"}, 4.0);
  const Mission mission = mission_of(layout, {});
  Navigator navigator(mission, 1);
  const std::vector<CellChange> free = all_free(layout.grid);
  const NavDecision first = navigator.decide({1, Vec3(2, 2, 2), free, {}});
  EXPECT_EQ(first.target_m, Vec3(2, 2, 2));
  EXPECT_EQ(first.next.decision, 2u);
  EXPECT_EQ(first.next.to_m, Vec3(12, 2, 2));
  EXPECT_NEAR(first.next.to_go_m, 40.0, 1e-9);
  const NavDecision second = navigator.decide({2, Vec3(2, 2, 2), {}, {}});
  EXPECT_EQ(second.target_m, Vec3(12, 2, 2));
  EXPECT_EQ(second.next.from_m, Vec3(12, 2, 2));
}

TEST(Navigator, DoesNotFlyWhatIsSeenBlockedMeanwhile) {
  const Layout layout = drawn({"a.........A"}, 4.0);
  Navigator navigator(mission_of(layout, {}), 1);
  EXPECT_EQ(navigator.decide({1, Vec3(2, 2, 2), all_free(layout.grid), {}}).status, NavStatus::Flying);
  const std::vector<CellChange> wall{{2, CellState::Occupied}};
  const NavDecision blocked = navigator.decide({2, Vec3(2, 2, 2), wall, {}});
  EXPECT_EQ(blocked.target_m, Vec3(2, 2, 2));
  EXPECT_EQ(blocked.status, NavStatus::Unreachable);
  EXPECT_LT(navigator.to_go_m(), 0.0);
  const std::vector<CellChange> gone{{2, CellState::Free}};
  EXPECT_EQ(navigator.decide({3, Vec3(2, 2, 2), gone, {}}).status, NavStatus::Flying);
  EXPECT_EQ(navigator.decide({4, Vec3(2, 2, 2), {}, {}}).target_m, Vec3(12, 2, 2));
}

TEST(Navigator, StaysIfItIsNotWhereItSaid) {
  const Layout layout = drawn({"a.........A"}, 4.0);
  Navigator navigator(mission_of(layout, {}), 1);
  EXPECT_EQ(navigator.decide({1, Vec3(2, 2, 2), all_free(layout.grid), {}}).status, NavStatus::Flying);
  EXPECT_EQ(navigator.decide({2, Vec3(2.5, 2, 2), {}, {}}).target_m, Vec3(2.5, 2, 2));
}

TEST(Navigator, HasArrivedWithinTheGoalRadius) {
  const Layout layout = drawn({"a.........A"}, 4.0);
  Navigator navigator(mission_of(layout, {}), 1);
  const NavDecision at_goal = navigator.decide({1, Vec3(41.2, 2, 2), all_free(layout.grid), {}});
  EXPECT_EQ(at_goal.status, NavStatus::Arrived);
  EXPECT_EQ(at_goal.target_m, Vec3(41.2, 2, 2));
}

TEST(Navigator, RefusesWhatItCannotServe) {
  const Layout layout = drawn({"a.........A"}, 4.0);
  Mission mission = mission_of(layout, {});
  EXPECT_THROW(Navigator(mission, 2), std::invalid_argument);
  Mission outside = mission;
  outside.transit->goals_m[0].x() = 99;
  EXPECT_THROW(Navigator(outside, 1), std::invalid_argument);
  Mission start_outside = mission;
  start_outside.vehicles[0].start.position_m.y() = -3;
  EXPECT_THROW(Navigator(start_outside, 1), std::invalid_argument);
  Mission unnamed = mission;
  unnamed.transit->planner.name = "none";
  EXPECT_THROW(Navigator(unnamed, 1), std::invalid_argument);
  Mission no_transit = mission;
  no_transit.transit.reset();
  EXPECT_THROW(Navigator(no_transit, 1), std::invalid_argument);
  Navigator navigator(mission, 1);
  const std::vector<CellChange> beyond{{11, CellState::Free}};
  EXPECT_THROW(static_cast<void>(navigator.decide({1, Vec3(2, 2, 2), beyond, {}})), std::invalid_argument);
}

}  // namespace
}  // namespace skein::gridnav
