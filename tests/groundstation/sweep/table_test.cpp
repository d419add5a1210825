#include "groundstation/sweep/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

Json run_of(bool feasible, bool success, int exit_code, double length_m) {
  return {{"plan_feasible", feasible},
          {"plan_success", success},
          {"exit_code", exit_code},
          {"figures", {{"vehicles.1.planned_length_m", length_m}, {"steps", 7}, {"separations.1-2.flown_m", 5.0}}}};
}

Json row_of(const std::string& planner, const std::vector<Json>& runs) {
  return {{"set", {{"planner.name", planner}}}, {"per_run", runs}};
}

TEST(Table, WilsonsIntervalOfThePapersRates) {
  // 27 of 30: (0.9 + 3.8416 / 60 -+ 1.96 sqrt(0.09 / 30 + 3.8416 / 3600)) / (1 + 3.8416 / 30)
  const Interval95 dcpso = interval_of(27, 30);
  EXPECT_NEAR(dcpso.low, 0.74379, 1e-5);
  EXPECT_NEAR(dcpso.high, 0.96540, 1e-5);
  const Interval95 all = interval_of(1000, 1000);
  EXPECT_NEAR(all.low, 1000.0 / 1003.8416, 1e-12);
  EXPECT_LE(all.high, 1.0);
  EXPECT_NEAR(all.high, 1.0, 1e-12);
  EXPECT_GE(interval_of(0, 10).low, 0.0);
}

TEST(Table, FiguresAreOverTheSuccessfulPlans) {
  const Json table =
      table_of(Json::array({row_of("a", {run_of(true, true, 0, 10.0), run_of(true, true, 1, 14.0),
                                         run_of(true, false, 1, 99.0), run_of(false, false, 1, 99.0)})}));
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table[0].at("runs"), 4);
  EXPECT_EQ(table[0].at("plan_success").at("count"), 2);
  EXPECT_EQ(table[0].at("plan_success").at("rate"), 0.5);
  EXPECT_EQ(table[0].at("plan_feasible").at("rate"), 0.75);
  EXPECT_EQ(table[0].at("success").at("rate"), 0.25);
  EXPECT_EQ(table[0].at("over"), "successful plans");
  const Json& length = table[0].at("figures").at("vehicles.1.planned_length_m");
  EXPECT_EQ(length.at("count"), 2);
  EXPECT_EQ(length.at("mean"), 12.0);
  EXPECT_NEAR(length.at("sd").get<double>(), std::sqrt(8.0), 1e-12);
  EXPECT_NEAR(length.at("high").get<double>(), 12.0 + 1.96 * 2.0, 1e-12);
  EXPECT_NEAR(length.at("low").get<double>(), 12.0 - 1.96 * 2.0, 1e-12);
  EXPECT_FALSE(table[0].at("figures").contains("steps"));
}

TEST(Table, WithoutASuccessTheyAreOverTheFeasiblePlans) {
  const Json table = table_of(Json::array({row_of("a", {run_of(true, false, 1, 10.0), run_of(false, false, 1, 99.0)}),
                                           row_of("b", {run_of(false, false, 1, 99.0)}), row_of("c", {})}));
  EXPECT_EQ(table[0].at("over"), "feasible plans");
  EXPECT_EQ(table[0].at("figures").at("vehicles.1.planned_length_m").at("mean"), 10.0);
  EXPECT_EQ(table[1].at("over"), "none");
  EXPECT_TRUE(table[1].at("figures").empty());
  EXPECT_TRUE(table[2].at("success").at("rate").is_null());
}

TEST(Table, RowsStandSideBySide) {
  Json other = row_of("dcpso-solo", {run_of(false, false, 1, 99.0)});
  other["set"]["planner.particles"] = "10";
  const std::string text =
      text_of_table(table_of(Json::array({row_of("dcpso", {run_of(true, true, 0, 10.0)}), other})));
  const std::string first = text.substr(0, text.find('\n'));
  EXPECT_LT(first.find("dcpso"), first.find("dcpso-solo, planner.particles=10"));
  EXPECT_NE(text.find("10.00 +-0.00 (0.00)"), std::string::npos) << text;
  EXPECT_NE(text.find("1.0000 [0.2065, 1.0000]"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("-\n")) << text;
}

TEST(Table, ARowIsCalledByWhatWasSwept) {
  EXPECT_EQ(title_of({{"set", Json::object()}}), "as in the scenario");
  EXPECT_EQ(title_of(row_of("ccga", {})), "ccga");
}

}  // namespace
}  // namespace skein
