// What navigators do by command, alone and among others: they stay, fly to the nearest place, and go on.
#include "planner/gridnav/errand.hpp"

#include <gtest/gtest.h>

#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

using What = Told::What;

Conditions with(std::vector<Told> told) {
  Conditions conditions;
  conditions.told = std::move(told);
  return conditions;
}

Vec3 centre(std::int32_t i, std::int32_t j) {
  return {4.0 * i + 2, 4.0 * j + 2, 2};
}

void expect_clean(const Outcome& outcome) {
  EXPECT_EQ(outcome.hits, 0U);
  EXPECT_GE(outcome.closest_m, 0.5);
}

const std::vector<std::string> kHall{"..........", "a........A", ".........."};

TEST(Errand, WhoIsHeldStaysAndGoesOn) {
  const Layout layout = drawn(kHall, 4.0);
  const Outcome held = fly(layout, with({{3, 1, What::Hold}}));
  EXPECT_EQ(held.flights[0].status, NavStatus::Held);
  EXPECT_EQ(held.flights[0].places_m.back(), centre(0, 1) + Vec3(10, 0, 0)) << "where it was when it was told";
  const Outcome plain = fly(layout, {});
  const Outcome resumed = fly(layout, with({{3, 1, What::Hold}, {20, 1, What::Resume}}));
  EXPECT_EQ(resumed.flights[0].status, NavStatus::Arrived);
  EXPECT_GE(resumed.decisions, plain.decisions + 17);
  EXPECT_NEAR(resumed.flights[0].length_m, plain.flights[0].length_m, 1e-6);
}

TEST(Errand, AHoldThatIsTakenBackChangesNothing) {
  const Layout layout = drawn(kHall, 4.0);
  EXPECT_EQ(fly(layout, with({{3, 1, What::Hold}, {3, 1, What::Resume}})).decisions, fly(layout, {}).decisions);
}

TEST(Errand, FliesToThePointAndHoldsThere) {
  const Layout layout = drawn(kHall, 4.0);
  const Vec3 point_m(25, 9, 2);
  const Outcome sent = fly(layout, with({{2, 1, What::Goto, point_m}}));
  EXPECT_EQ(sent.flights[0].status, NavStatus::Held);
  EXPECT_NEAR((sent.flights[0].places_m.back() - point_m).norm(), 0.0, 1e-6);
  EXPECT_EQ(fly(layout, with({{2, 1, What::Goto, point_m}, {12, 1, What::Resume}})).flights[0].status,
            NavStatus::Arrived);
}

TEST(Errand, FliesNoFasterThanItIsTold) {
  const Layout layout = drawn(kHall, 4.0);
  const Outcome sent = fly(layout, with({{1, 1, What::Goto, centre(8, 1), 0.5}}));
  EXPECT_EQ(sent.flights[0].status, NavStatus::Held);
  EXPECT_NEAR((sent.flights[0].places_m.back() - centre(8, 1)).norm(), 0.0, 1e-6);
  for (std::size_t k = 2; k < sent.flights[0].places_m.size(); ++k)
    EXPECT_LE((sent.flights[0].places_m[k] - sent.flights[0].places_m[k - 1]).norm(), 0.5 + 1e-9);
}

TEST(Errand, HoldsAtTheNearestCellThatItCanReach) {
  const Layout layout = drawn({"....###...", "a...#.#..A", "....###..."}, 4.0);
  const Outcome sent = fly(layout, with({{2, 1, What::Goto, centre(5, 1)}}));
  EXPECT_EQ(sent.flights[0].status, NavStatus::Held);
  EXPECT_NEAR((sent.flights[0].places_m.back() - centre(3, 1)).norm(), 0.0, 1e-6);
  const Outcome into_wall = fly(layout, with({{2, 1, What::Goto, centre(4, 0) + Vec3(-1, -1, 0)}}));
  EXPECT_NEAR((into_wall.flights[0].places_m.back() - centre(3, 0)).norm(), 0.0, 1e-6);
}

TEST(Errand, SaysHowItStandsToThePoint) {
  const Layout layout = drawn({"a#.", "..A"}, 4.0);
  Navigator navigator(mission_of(layout, {}), 1);
  std::vector<CellChange> seen;
  for (CellIndex n = 0; n < layout.grid.size(); ++n)
    seen.push_back({n, layout.occupied[n] ? CellState::Occupied : CellState::Free});
  EXPECT_FALSE(navigator.errand().has_value());
  navigator.go_to(centre(1, 1), 10.0);
  EXPECT_EQ(navigator.errand(), ErrandState::UnderWay);
  Vec3 place_m = centre(0, 1);
  for (std::uint32_t k = 1; k <= 5; ++k) {
    place_m =
        navigator.decide({k, place_m, k == 1 ? std::span<const CellChange>(seen) : std::span<const CellChange>(), {}})
            .target_m;
  }
  EXPECT_EQ(navigator.errand(), ErrandState::Short);
  navigator.hold();
  EXPECT_EQ(navigator.errand(), ErrandState::Stays);
  navigator.resume();
  EXPECT_FALSE(navigator.errand().has_value());
}

TEST(Errand, OthersFlyAroundOneWhoIsHeld) {
  const Layout layout = drawn({"..........", "a..b....BA", ".########."}, 4.0);
  const Outcome outcome = fly(layout, with({{1, 2, What::Hold}}));
  EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived);
  EXPECT_EQ(outcome.flights[1].status, NavStatus::Held);
  EXPECT_EQ(outcome.flights[1].length_m, 0.0);
  expect_clean(outcome);
}

TEST(Errand, AWayAroundIsNotLeftForTheStraightLine) {
  const Layout layout = drawn({"....B...", ".######.", "a...b..A"}, 4.0);
  Conditions conditions = with({{1, 2, What::Hold}});
  conditions.radius_m = 1.9;
  conditions.most_decisions = 100;
  const Outcome outcome = fly(layout, conditions);
  EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived);
  EXPECT_NEAR(outcome.flights[0].length_m, 64.0, 1e-6) << "44 m around, once it heard of it 10 m on";
  EXPECT_GE(outcome.closest_m, 3.8);
}

TEST(Errand, WhoWaitsForOneThatIsHeldSaysNeitherUnreachableNorDeadlock) {
  const Layout layout = drawn({"##########", "a..b....BA", "##########"}, 4.0);
  Conditions conditions = with({{1, 2, What::Hold}});
  conditions.radius_m = 1.9;  // nobody gets past in this corridor
  conditions.most_decisions = 600;
  const Outcome waits = fly(layout, conditions);
  EXPECT_EQ(waits.flights[0].status, NavStatus::Flying);
  EXPECT_EQ(waits.decisions, 600U);
  EXPECT_GT(waits.flights[0].length_m, 4.0) << "it comes up";
  conditions.told.push_back({600, 2, What::Resume});
  conditions.most_decisions = 2000;
  const Outcome resumed = fly(layout, conditions);
  EXPECT_EQ(resumed.count(NavStatus::Arrived), 2) << static_cast<int>(resumed.flights[0].status);
  EXPECT_GE(resumed.closest_m, 3.8);
}

TEST(Errand, WhereOneWasHeldIsKeptOffUntilItLands) {
  const Layout layout = drawn({"......", ".####.", "a....A"}, 4.0);
  Navigator navigator(mission_of(layout, {}), 1);
  std::vector<CellChange> seen;
  for (CellIndex n = 0; n < layout.grid.size(); ++n)
    seen.push_back({n, layout.occupied[n] ? CellState::Occupied : CellState::Free});
  Neighbour held{2, centre(3, 0), 0.25, Intent{}};
  held.intent->decision = 1;
  held.intent->from_m = held.intent->to_m = held.position_m;
  held.intent->status = NavStatus::Held;
  (void)navigator.decide({1, centre(0, 0), seen, std::span(&held, 1)});
  EXPECT_NEAR(navigator.to_go_m(), 36.0, 1e-9) << "around";
  (void)navigator.decide({2, Vec3(2.1, 2, 2), {}, {}});
  EXPECT_NEAR(navigator.to_go_m(), 36.0, 1e-9) << "out of range it is remembered";
  navigator.forget_held(2);
  (void)navigator.decide({3, Vec3(2.2, 2, 2), {}, {}});
  EXPECT_NEAR(navigator.to_go_m(), 20.0, 1e-9);
}

TEST(Errand, TwoThatAreSentToOnePointDoNotShareIt) {
  const Layout layout = drawn({"a.........A", "...........", "b.........B"}, 4.0);
  Conditions conditions = with({{2, 1, What::Goto, centre(5, 1)}, {2, 2, What::Goto, centre(5, 1)}});
  conditions.radius_m = 1.9;
  const Outcome outcome = fly(layout, conditions);
  EXPECT_EQ(outcome.count(NavStatus::Held), 2);
  EXPECT_GE(outcome.closest_m, 3.8);
  EXPECT_LE((outcome.flights[0].places_m.back() - centre(5, 1)).norm(), 6.0);
  EXPECT_LE((outcome.flights[1].places_m.back() - centre(5, 1)).norm(), 6.0);
}

TEST(Errand, EndsWhereOthersDoNotLetItPass) {
  const Layout layout = drawn({"##########", "a...b....A", "#########B"}, 4.0);
  Conditions conditions = with({{1, 2, What::Hold}, {2, 1, What::Goto, centre(8, 1)}});
  conditions.radius_m = 1.9;
  const Outcome outcome = fly(layout, conditions);
  EXPECT_EQ(outcome.count(NavStatus::Held), 2);
  EXPECT_NEAR((outcome.flights[0].places_m.back() - centre(3, 1)).norm(), 0.0, 1e-6);
}

TEST(Errand, PlannersOfThePaperObeyToo) {
  for (const char* planner : {"peach", "peach3d-paper"}) {
    const Layout layout = drawn({"..........", "a...#....A", "....#....."}, 4.0);
    Conditions conditions = with({{2, 1, What::Goto, centre(8, 0)}, {40, 1, What::Resume}});
    conditions.planner = planner;
    const Outcome outcome = fly(layout, conditions);
    EXPECT_EQ(outcome.flights[0].status, NavStatus::Arrived) << planner;
    EXPECT_EQ(outcome.flights[0].places_m.at(38), centre(8, 0)) << planner;
    expect_clean(outcome);
  }
}

TEST(Errand, TheSameCommandsGiveTheSameHashAndOthersAnother) {
  const Layout layout = drawn(kHall, 4.0);
  const Outcome once = fly(layout, with({{3, 1, What::Hold}, {9, 1, What::Resume}}));
  EXPECT_EQ(fly(layout, with({{3, 1, What::Hold}, {9, 1, What::Resume}})).hash, once.hash);
  EXPECT_NE(fly(layout, with({{3, 1, What::Hold}, {10, 1, What::Resume}})).hash, once.hash);
  EXPECT_NE(fly(layout, {}).hash, once.hash);
}

}  // namespace
}  // namespace skein::gridnav
