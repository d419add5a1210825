// Flights out of a sweep's rows, and what is reckoned from them, by hand.
#include "groundstation/reproduce/flights.hpp"

#include <gtest/gtest.h>

#include <array>

namespace skein::reproduce {
namespace {

TEST(Median, OfAnOddAndAnEvenNumberAndOfNone) {
  EXPECT_EQ(median_of({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(median_of({4.0, 1.0, 3.0, 10.0}), 3.5);
  EXPECT_EQ(median_of({}), std::nullopt);
}

TEST(Flights, ThoseThatArriveInAll) {
  const Flights a{{{0, 2, 1}, {true, 10.0, 5.0}}, {{0, 2, 2}, {true, 20.0, 5.0}}, {{1, 2, 1}, {false, 30.0, 5.0}}};
  const Flights b{{{0, 2, 1}, {true, 11.0, 5.0}}, {{0, 2, 2}, {false, 21.0, 5.0}}, {{1, 2, 1}, {true, 31.0, 5.0}}};
  const std::array both{a, b};
  const auto together = arrived_in_all(a, both);
  ASSERT_EQ(together.size(), 1U);
  EXPECT_EQ(together[0].flown_m, 10.0);
  EXPECT_EQ(arrived_in_all(b, both).at(0).flown_m, 11.0);
}

TEST(Flights, OneThatAnotherPlannerDidNotFlyIsNotCompared) {
  const Flights a{{{0, 2, 1}, {true, 10.0, 5.0}}};
  const std::array both{a, Flights{}};
  EXPECT_TRUE(arrived_in_all(a, both).empty());
}

TEST(Flights, RunsAreOfASeedAndASwarm) {
  const Flights flights{{{0, 2, 1}, {true, 1.0, {}}},
                        {{0, 2, 2}, {false, 1.0, {}}},
                        {{0, 1, 1}, {true, 1.0, {}}},
                        {{1, 2, 1}, {true, 1.0, {}}},
                        {{1, 2, 2}, {true, 1.0, {}}}};
  const RunCount count = runs_in(flights);
  EXPECT_EQ(count.runs, 3U);
  EXPECT_EQ(count.incomplete, 1U);
  EXPECT_EQ(arrivals(flights), 4U);
}

TEST(Flights, AreReadFromTheRowsOfTheirValues) {
  CampaignResult result;
  result.campaign.name = "c";
  const nlohmann::ordered_json figures{{"vehicles.1.path_length_m", 12.5},
                                       {"vehicles.1.arrival_step", 9},
                                       {"vehicles.1.shortest_path_m", 10.0},
                                       {"vehicles.2.path_length_m", 99.0},
                                       {"vehicles.2.max_curvature_per_m", 0.0}};
  result.rows = nlohmann::ordered_json::array();
  for (const char* cell : {"2", "4"}) {
    result.rows.push_back({{"set", {{"planner.cell_m", cell}}}, {"per_run", {{{"seed", 7}, {"figures", figures}}}}});
  }
  Results results;
  results.campaigns.push_back(result);
  const Flights flights = flights_of(results, "c", std::array{Override{"planner.cell_m", "4"}});
  ASSERT_EQ(flights.size(), 2U);
  const Flight& first = flights.at({7, 2, 1});
  EXPECT_TRUE(first.arrived);
  EXPECT_EQ(first.flown_m, 12.5);
  EXPECT_EQ(first.shortest_m, 10.0);
  const Flight& second = flights.at({7, 2, 2});
  EXPECT_FALSE(second.arrived);
  EXPECT_EQ(second.shortest_m, std::nullopt);
  EXPECT_TRUE(flights_of(results, "c", std::array{Override{"planner.cell_m", "6"}}).empty());
  EXPECT_TRUE(flights_of(results, "other", {}).empty());
}

}  // namespace
}  // namespace skein::reproduce
