// What figures show is what the run itself says: lengths, separations, steps, costs.
#include "groundstation/figure/run_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "groundstation/record/tap.hpp"
#include "tests/groundstation/record/recorded.hpp"

namespace skein::figure {
namespace {

struct Collected {
  RunData data;
  nlohmann::ordered_json report;
  std::vector<double> least_m;  ///< of all pairs of the world's own positions, at the beginning of each step
};

Collected collect(const std::string& scenario_name, InProcessOptions options = {}) {
  const Scenario scenario = tests::small_scenario(scenario_name, 7);
  RunCollector collector;
  Collected run;
  std::uint32_t noted = 0;
  options.tap = [&](AgentId, const wire::Sample& sample) { collector.add(topic_of(sample), payload_of(sample)); };
  options.on_round = [&](const WorldSession& session) {
    if (session.run().phase() != Phase::Flying || session.run().steps_flown() + 1 == noted) return;
    noted = session.run().steps_flown() + 1;
    double least_m = 1e9;
    const auto& vehicles = session.run().world().vehicles();
    for (std::size_t i = 0; i < vehicles.size(); ++i) {
      for (std::size_t j = i + 1; j < vehicles.size(); ++j) {
        least_m = std::min(least_m, (vehicles[i].state.position_m - vehicles[j].state.position_m).norm());
      }
    }
    run.least_m.push_back(least_m);
  };
  run.report = run_in_process(scenario, options).report;
  run.data = collector.data();
  EXPECT_EQ(collector.unreadable(), 0U);
  return run;
}

TEST(RunData, PlannedPathsHaveTheReportsLengths) {
  const Collected run = collect("small");
  ASSERT_EQ(run.data.vehicles.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const VehicleTrace& vehicle = run.data.vehicles[i];
    EXPECT_DOUBLE_EQ(vehicle.planned_length_m, run.report["vehicles"][i]["planned_length_m"].get<double>());
    EXPECT_EQ(vehicle.planned.size(), 201U);
    EXPECT_EQ(vehicle.planned.front().position_m, vehicle.spec.start.position_m);
    EXPECT_LT((vehicle.planned.back().position_m - end_m(run.data.mission, i)).norm(), 1e-6);
  }
}

TEST(RunData, FlownPathsHaveAPointForEachStep) {
  const Collected run = collect("small");
  for (const VehicleTrace& vehicle : run.data.vehicles) {
    ASSERT_EQ(vehicle.flown.size(), run.report["steps"].get<std::size_t>());
    EXPECT_EQ(vehicle.flown.front().position_m, vehicle.spec.start.position_m);
    double length_m = 0.0;
    for (std::size_t k = 1; k < vehicle.flown.size(); ++k) {
      EXPECT_EQ(vehicle.flown[k].step, k + 1);
      length_m += (vehicle.flown[k].position_m - vehicle.flown[k - 1].position_m).norm();
    }
    const double reported_m = run.report["vehicles"][vehicle.spec.id - 1]["path_length_m"].get<double>();
    EXPECT_NEAR(length_m, reported_m, run.data.mission.step_s * vehicle.spec.speed_mps + 1.0);
  }
}

TEST(RunData, SeparationsAreTheWorldsOwnAtTheBeginningOfEachStep) {
  const Collected run = collect("small");
  const std::vector<SeparationPoint> points = separation(run.data);
  ASSERT_EQ(points.size(), run.report["steps"].get<std::size_t>());
  double least_m = 1e9;
  for (const SeparationPoint& point : points) least_m = std::min(least_m, point.least_m);
  ASSERT_GE(run.least_m.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_DOUBLE_EQ(points[k].least_m, run.least_m[k]) << k;
  const double reported_m = run.report["min_separation_m"].get<double>();  // continuous between steps
  EXPECT_GE(least_m, reported_m - 1e-9);
  EXPECT_LE(least_m, reported_m + 2 * run.data.mission.step_s * 50.0);
  EXPECT_EQ(points.front().safety_m, 200.0);
  EXPECT_EQ(points.front().contact_m, 4.0);
  EXPECT_EQ(points[1].time_s, run.data.mission.step_s);
}

TEST(RunData, CostsAreThoseOfEachGeneration) {
  const Collected run = collect("small");
  for (const VehicleTrace& vehicle : run.data.vehicles) {
    ASSERT_EQ(vehicle.costs.size(), static_cast<std::size_t>(run.data.mission.planner.generations) + 1);
    for (std::size_t g = 0; g < vehicle.costs.size(); ++g) EXPECT_EQ(vehicle.costs[g].generation, g);
    EXPECT_GT(vehicle.costs.back().cost, 0.0);
  }
}

TEST(RunData, WhereNobodyRecordedTheSensesBeaconsTellThePlaces) {
  RunCollector whole;
  RunCollector observed;
  InProcessOptions options;
  options.tap = [&](AgentId, const wire::Sample& sample) {
    whole.add(topic_of(sample), payload_of(sample));
    if (topic_of(sample) != bus::TopicId::Sense) observed.add(topic_of(sample), payload_of(sample));
  };
  (void)run_in_process(tests::small_scenario("small", 7), options);
  const RunData a = whole.data();
  const RunData b = observed.data();
  for (std::size_t i = 0; i < a.vehicles.size(); ++i) {
    ASSERT_EQ(a.vehicles[i].flown.size(), b.vehicles[i].flown.size());
    for (std::size_t k = 0; k < a.vehicles[i].flown.size(); ++k) {
      EXPECT_EQ(a.vehicles[i].flown[k].position_m, b.vehicles[i].flown[k].position_m);
    }
  }
}

TEST(RunData, OfALostVehicleThereIsNothingAfterItsLoss) {
  InProcessOptions options;
  options.faults.push_back(*parse_fault("kill:2@fly:40").fault);
  const Collected run = collect("small", options);
  EXPECT_EQ(run.data.vehicles[1].flown.back().step, 39U);
  EXPECT_EQ(run.data.vehicles[0].flown.size(), run.report["steps"].get<std::size_t>());
  EXPECT_LE(separation(run.data).size(), 39U);
}

TEST(RunData, ATransitHasGoalsAndNoPlans) {
  const Collected run = collect("small-transit");
  ASSERT_FALSE(run.data.vehicles.empty());
  for (std::size_t i = 0; i < run.data.vehicles.size(); ++i) {
    EXPECT_TRUE(run.data.vehicles[i].planned.empty());
    EXPECT_EQ(end_m(run.data.mission, i), run.data.mission.transit->goals_m[i]);
    EXPECT_FALSE(run.data.vehicles[i].flown.empty());
  }
}

TEST(RunData, WhatIsNoSampleIsCounted) {
  RunCollector collector;
  const std::vector<std::uint8_t> nothing{0, 1, 0, 0, 7};
  collector.add(bus::TopicId::Mission, nothing);
  EXPECT_EQ(collector.unreadable(), 1U);
  EXPECT_FALSE(collector.has_mission());
}

}  // namespace
}  // namespace skein::figure
