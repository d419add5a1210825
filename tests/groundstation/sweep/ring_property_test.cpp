// Many UAVs across one another: they find a common length and arrive, and without cooperation they would collide.
// SKEIN_RING_SEEDS sets how many seeds of N = 12 and 25 are run (default 2); N = 40 takes a tenth, at least 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "groundstation/sweep/sweep.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

std::uint32_t seeds() {
  const char* set = std::getenv("SKEIN_RING_SEEDS");
  return set == nullptr ? 2U : static_cast<std::uint32_t>(std::max(1, std::atoi(set)));
}

Json ring_row(int agents, std::uint32_t runs, const std::string& planner) {
  SweepPlan plan;
  plan.scenario = SKEIN_SOURCE_DIR "/deploy/scenarios/rendezvous-ring.yaml";
  plan.keys = {{"vehicles.ring.agents", {std::to_string(agents)}}, {"planner.name", {planner}}};
  plan.runs = runs;
  plan.jobs = 2;
  return run_sweep(plan).rows.at(0);
}

class Ring : public testing::TestWithParam<int> {};

TEST_P(Ring, NearlyAllRunsArrive) {
  const std::uint32_t runs = GetParam() >= 40 ? std::max(1U, seeds() / 10) : seeds();
  const Json row = ring_row(GetParam(), runs, "dcpso");
  const double least = GetParam() >= 40 ? 1.0 / runs : 0.95;
  EXPECT_GE(row.at("success_rate").get<double>(), least) << row.at("failures").dump(2);
  for (const Json& run : row.at("per_run")) {
    if (run.at("exit_code") != 0) continue;
    EXPECT_GE(run.at("figures").at("min_separation_m").get<double>(), 100.0) << "both safety radii";
  }
}

INSTANTIATE_TEST_SUITE_P(Agents, Ring, testing::Values(2, 12, 25, 40));

TEST(RingAlone, WithoutCooperationHalfOfThemMeet) {
  for (const int agents : {25, 40}) {
    const Json row = ring_row(agents, 1, "dcpso-solo");
    int close = 0;
    for (const auto& [name, value] : row.at("per_run").at(0).at("figures").items()) {
      const bool of_a_plan = name.starts_with("separations.") && name.ends_with(".planned_m");
      close += of_a_plan && value.get<double>() < 100.0 ? 1 : 0;
    }
    EXPECT_GE(2 * close, agents);
  }
}

}  // namespace
}  // namespace skein
