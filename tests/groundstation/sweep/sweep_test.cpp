// Sweeps: combinations, summaries by hand, and runs that are those of the harness.
#include "groundstation/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>

#include "groundstation/inprocess/in_process.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

const std::string kSmall = SKEIN_SOURCE_DIR "/tests/data/small.yaml";

SweepPlan small_plan(std::uint32_t runs) {
  SweepPlan plan;
  plan.scenario = kSmall;
  plan.first_seed = 11;
  plan.runs = runs;
  return plan;
}

/// Without the figures that depend on the machine's speed.
Json timeless(Json rows) {
  static const std::set<std::string> kTimed{"discovery_s", "plan_s", "rounds_per_s", "steps_per_s", "realtime_factor"};
  for (Json& row : rows) {
    for (const std::string& name : kTimed) row["figures"].erase(name);
    for (Json& run : row["per_run"]) {
      for (const std::string& name : kTimed) run["figures"].erase(name);
    }
  }
  return rows;
}

TEST(Combinations, WithoutKeysThereIsOne) {
  const auto combinations = combinations_of({});
  ASSERT_EQ(combinations.size(), 1U);
  EXPECT_TRUE(combinations[0].empty());
}

TEST(Combinations, AreAllPairsTheLastKeyChangingFastest) {
  const auto combinations = combinations_of({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
  ASSERT_EQ(combinations.size(), 6U);
  std::string text;
  for (const auto& set : combinations) {
    ASSERT_EQ(set.size(), 2U);
    text += set[0].key + set[0].value + set[1].key + set[1].value + " ";
  }
  EXPECT_EQ(text, "a1bx a1by a1bz a2bx a2by a2bz ");
}

TEST(Summary, OfFourByHand) {
  const Json summary = summary_of({4.0, 1.0, 3.0, 8.0});
  EXPECT_DOUBLE_EQ(summary.at("mean").get<double>(), 4.0);
  EXPECT_DOUBLE_EQ(summary.at("sd").get<double>(), std::sqrt((0.0 + 9.0 + 1.0 + 16.0) / 3.0));
  EXPECT_EQ(summary.at("min"), 1.0);
  EXPECT_EQ(summary.at("p50"), 3.0);
  EXPECT_EQ(summary.at("p95"), 8.0);
  EXPECT_EQ(summary.at("max"), 8.0);
}

TEST(Summary, OfOneAndOfAHundred) {
  const Json one = summary_of({7.0});
  EXPECT_EQ(one.at("mean"), 7.0);
  EXPECT_EQ(one.at("sd"), 0.0);
  EXPECT_EQ(one.at("p50"), 7.0);
  std::vector<double> hundred;
  for (int i = 100; i >= 1; --i) hundred.push_back(i);
  const Json many = summary_of(hundred);
  EXPECT_DOUBLE_EQ(many.at("mean").get<double>(), 50.5);
  EXPECT_EQ(many.at("p50"), 50.0);
  EXPECT_EQ(many.at("p95"), 95.0);
}

TEST(Figures, AreTheNumbersOfReportAndVehicles) {
  const Json report{{"seed", 4},
                    {"exit_code", 0},
                    {"success", true},
                    {"reason", "fine"},
                    {"steps", 12},
                    {"min_clearance_m", nullptr},
                    {"separations", {{{"a", 1}, {"b", 4}, {"flown_m", 7.5}}}},
                    {"vehicles",
                     {{{"id", 1}, {"pid", 77}, {"planned_length_m", 5.0}, {"arrival_step", 3}, {"status", "arrived"}},
                      {{"id", 4}, {"pid", nullptr}, {"planned_length_m", 9.0}, {"arrival_step", nullptr}}}}};
  const Json expected{{"steps", 12},
                      {"vehicles.1.planned_length_m", 5.0},
                      {"vehicles.1.arrival_step", 3},
                      {"vehicles.4.planned_length_m", 9.0},
                      {"separations.1-4.flown_m", 7.5},
                      {"longest_path_m", 9.0}};
  EXPECT_EQ(nlohmann::json(figures_of(report)), nlohmann::json(expected));
}

TEST(Sweep, RunIIsTheRunOfSeedSPlusI) {
  const SweepResult result = run_sweep(small_plan(4));
  ASSERT_EQ(result.rows.size(), 1U);
  const Json& row = result.rows[0];
  EXPECT_EQ(row.at("runs"), 4);
  ASSERT_EQ(row.at("per_run").size(), 4U);
  for (std::uint64_t i = 0; i < 4; ++i) {
    const Json& run = row.at("per_run")[i];
    ScenarioResult scenario = load_scenario(kSmall, {}, 11 + i);
    const InProcessResult alone = run_in_process(std::get<Scenario>(scenario), {});
    EXPECT_EQ(run.at("seed"), 11 + i);
    EXPECT_EQ(run.at("state_hash"), alone.report.at("state_hash"));
    EXPECT_EQ(run.at("exit_code"), alone.exit_code);
    EXPECT_EQ(run.at("figures").at("steps"), alone.report.at("steps"));
  }
  EXPECT_EQ(row.at("figures").at("steps").at("max"),
            summary_of({row.at("per_run")[0].at("figures").at("steps"), row.at("per_run")[1].at("figures").at("steps"),
                        row.at("per_run")[2].at("figures").at("steps"), row.at("per_run")[3].at("figures").at("steps")})
                .at("max"));
}

TEST(Sweep, ResultsDoNotDependOnTheNumberOfJobs) {
  SweepPlan plan = small_plan(5);
  plan.keys = {{"planner.particles", {"6", "12"}}};
  const Json one = timeless(run_sweep(plan).rows);
  plan.jobs = 4;
  std::size_t calls = 0;
  plan.on_progress = [&](std::size_t done, std::size_t of) {
    EXPECT_EQ(done, ++calls);
    EXPECT_EQ(of, 10U);
  };
  EXPECT_EQ(timeless(run_sweep(plan).rows), one);
  EXPECT_EQ(calls, 10U);
  ASSERT_EQ(one.size(), 2U);
  EXPECT_EQ(one[1].at("set").at("planner.particles"), "12");
  EXPECT_NE(one[0].at("per_run")[0].at("state_hash"), one[1].at("per_run")[0].at("state_hash"));
}

TEST(Sweep, FailuresAreListedWithTheirReason) {
  SweepPlan plan = small_plan(2);
  plan.keys = {{"world.max_steps", {"3"}}};
  const Json row = run_sweep(plan).rows[0];
  EXPECT_EQ(row.at("success_rate"), 0.0);
  ASSERT_EQ(row.at("failures").size(), 2U);
  EXPECT_EQ(row.at("failures")[0].at("seed"), 11);
  EXPECT_EQ(row.at("failures")[0].at("reason"), "the flight did not end within world.max_steps = 3 steps");
}

TEST(Sweep, StopsBetweenRunsAndKeepsWhatIsThere) {
  SweepPlan plan = small_plan(50);
  plan.stop = [calls = 0]() mutable { return ++calls == 2; };
  const SweepResult result = run_sweep(plan);
  EXPECT_TRUE(result.stopped);
  EXPECT_EQ(result.rows[0].at("runs"), 2);
}

TEST(Sweep, AnInvalidCombinationIsOneLine) {
  SweepPlan plan = small_plan(1);
  plan.keys = {{"planner.particles", {"10", "-1"}}};
  try {
    (void)run_sweep(plan);
    ADD_FAILURE() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("planner.particles"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace skein
