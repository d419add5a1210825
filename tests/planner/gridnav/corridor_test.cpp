// Two that meet in a corridor one cell wide.
#include <gtest/gtest.h>

#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

void expect_all_arrive(const std::vector<std::string>& rows, double loss = 0.0) {
  for (const double cell_m : {2.0, 4.0, 7.0}) {
    Conditions conditions;
    conditions.loss = loss;
    const Layout layout = drawn(rows, cell_m);
    const Outcome outcome = fly(layout, conditions);
    EXPECT_EQ(outcome.count(NavStatus::Arrived), static_cast<int>(layout.starts.size()))
        << "cells of " << cell_m << " m, after " << outcome.decisions;
    EXPECT_GE(outcome.closest_m, 0.5);
    EXPECT_EQ(outcome.hits, 0u);
  }
}

TEST(Corridor, BayInTheMiddle) {
  expect_all_arrive({"#########.#########",  //
                     "a.B.............A.b"});
}

TEST(Corridor, BayNearOneEnd) {
  expect_all_arrive({"####.##############",  //
                     "aB................b",  //
                     "##################A"});
}

TEST(Corridor, RoomsAtBothEnds) {
  expect_all_arrive({"...##########...",  //
                     "aB............Ab",  //
                     "...##########..."});
}

TEST(Corridor, Junction) {
  expect_all_arrive({"#####.#####",  //
                     "#####.#####",  //
                     "aB........A",  //
                     "#####.####b",  //
                     "#####.#####"});
}

TEST(Corridor, TwoAgainstOneWithBays) {
  expect_all_arrive({"####.####.####.####",  //
                     "acB............AC.b"});
}

TEST(Corridor, BayWithLostIntents) {
  expect_all_arrive({"#########.#########",  //
                     "a.B.............A.b"},
                    0.3);
}

TEST(Corridor, AHovererGivesWay) {
  // b has no way to its goal, and stands in the only way of a.
  const Layout layout = drawn({"########.#######B", "a......b.....A##."}, 4.0);
  const Outcome outcome = fly(layout, {});
  EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived) << outcome.decisions;
  EXPECT_EQ(outcome.flights[1].status, NavStatus::Unreachable);
  EXPECT_GE(outcome.closest_m, 0.5);
}

TEST(Corridor, WithoutBayEndsAsDeadlock) {
  for (const double cell_m : {2.0, 4.0, 7.0}) {
    Layout layout = drawn({"a................b"}, cell_m);
    layout.goals_m = {layout.grid.centre_m(layout.starts[1]), layout.grid.centre_m(layout.starts[0])};
    Conditions conditions;
    conditions.goal_radius_m = 0.4;  // so that two do not fit into it
    const Outcome outcome = fly(layout, conditions);
    EXPECT_EQ(outcome.count(NavStatus::Deadlock), 2) << "cells of " << cell_m;
    EXPECT_LT(outcome.decisions, 1500u);
    EXPECT_GE(outcome.closest_m, 0.5);
  }
}

}  // namespace
}  // namespace skein::gridnav
