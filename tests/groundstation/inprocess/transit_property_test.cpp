// The promises of a transit on whole swarms: who has a path arrives, who has none says so, nobody touches anything,
// nobody exceeds its share of the radio, and maps that can become equal do.
#include <gtest/gtest.h>

#include "groundstation/inprocess/in_process.hpp"
#include "tests/groundstation/crossings.hpp"

namespace skein {
namespace {

using test::count_status;
using test::transit_scenario;
using Json = nlohmann::ordered_json;

TEST(Transit, InAForestWhoHasAPathArrivesAndWhoHasNoneSaysSo) {
  std::size_t without = 0;
  std::size_t of = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scenario scenario =
        transit_scenario("transit-forest", seed, {{"draw.from", "free"}, {"forest.density_per_m2", "0.012"}});
    const Json report = run_in_process(scenario, {}).report;
    ASSERT_EQ(report.at("collisions"), 0) << seed;
    ASSERT_EQ(report.at("radio").at("over_budget"), 0) << seed;
    for (const auto& vehicle : report.at("vehicles")) {
      const bool has_path = !vehicle.at("shortest_path_m").is_null();
      ASSERT_EQ(vehicle.at("status"), has_path ? "arrived" : "unreachable")
          << "seed " << seed << ", vehicle " << vehicle.at("id");
      without += has_path ? 0 : 1;
      ++of;
    }
  }
  EXPECT_GT(without, of / 5);
  EXPECT_LT(without, of / 2);
}

TEST(Transit, TheFlightsOfTheFifthFigureAllArrive) {
  const std::string half = "y_min_m: 0, z_min_m: 0, y_max_m: 500, z_max_m: 100}";
  std::size_t arrived = 0;
  for (const char* cell : {"2", "4", "6"}) {
    for (const char* agents : {"3", "5", "7", "9"}) {
      const Json report = run_in_process(transit_scenario("transit-power-station", 0,
                                                          {{"planner.cell_m", cell},
                                                           {"vehicles.agents", agents},
                                                           {"radio.loss", "0.1"},
                                                           {"draw.from", "connected"},
                                                           {"draw.own_goals", "0"},
                                                           {"draw.starts", "{x_min_m: 0, x_max_m: 240, " + half},
                                                           {"draw.goals", "{x_min_m: 270, x_max_m: 500, " + half}}),
                                         {})
                              .report;
      EXPECT_EQ(report.at("exit_code"), 0) << cell << " " << agents << ": " << report.at("reason");
      EXPECT_EQ(report.at("collisions"), 0) << cell << " " << agents;
      EXPECT_EQ(report.at("radio").at("over_budget"), 0) << cell << " " << agents;
      arrived += report.at("arrived").get<std::size_t>();
    }
  }
  EXPECT_EQ(arrived, 72U);
}

TEST(Transit, HowFarThePapersLineIsKnownFreeIsAChoice) {
  std::vector<double> flown_m;
  for (const char* known : {"0", "1"}) {
    const auto scenario = transit_scenario("transit-power-station", 1,
                                           {{"planner.name", "peach3d-paper"}, {"planner.known_line", known}});
    const Json report = run_in_process(scenario, {}).report;
    EXPECT_EQ(report.at("collisions"), 0) << known;
    flown_m.push_back(report.at("total_path_m").get<double>());
  }
  EXPECT_NE(flown_m[0], flown_m[1]);
}

/// The first flight step at whose end every group hears every other, after a time in which not; 0 if there is none.
std::uint32_t meeting_step(const Json& report) {
  bool apart = false;
  for (const auto& change : report.at("partitions")) {
    const bool one = change.at("groups") == 1;
    if (one && apart) return change.at("step").get<std::uint32_t>();
    apart = apart || !one;
  }
  return 0;
}

TEST(Transit, MapsAreEqualTwoExchangesAfterTheGroupsMet) {
  const Json report = run_in_process(transit_scenario("transit-partition", 1), {}).report;
  ASSERT_EQ(report.at("exit_code"), 0) << report.at("reason");
  EXPECT_EQ(report.at("collisions"), 0);
  ASSERT_EQ(report.at("map_equal"), true);
  const std::uint32_t met = meeting_step(report);
  ASSERT_GT(met, 1U) << report.at("partitions");
  EXPECT_LE(report.at("map_equal_since_step").get<std::uint32_t>(), met + 2) << "each sends a map in every step";
}

TEST(Transit, MapsBecomeEqualWhateverTheRadioLoses) {
  for (const char* loss : {"0.1", "0.3"}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const std::vector<Override> lossy{{"radio.loss", loss}, {"world.extra_steps", "20"}};
      const Json report = run_in_process(transit_scenario("transit-partition", seed, lossy), {}).report;
      EXPECT_EQ(report.at("exit_code"), 0) << loss << " " << seed << ": " << report.at("reason");
      EXPECT_EQ(report.at("collisions"), 0) << loss << " " << seed;
      EXPECT_EQ(report.at("map_equal"), true) << loss << " " << seed;
      EXPECT_GT(meeting_step(report), 1U) << loss << " " << seed;
    }
  }
}

TEST(Transit, SharedMapsAreWhatMakesThemEqual) {
  const Json report =
      run_in_process(transit_scenario("transit-partition", 1, {{"planner.share_maps", "0"}}), {}).report;
  EXPECT_EQ(report.at("exit_code"), 0) << report.at("reason");
  EXPECT_EQ(report.at("map_equal"), false);
}

TEST(Transit, TheSameSeedGivesTheSameHashAndAnotherAnother) {
  const std::vector<Override> lossy{{"radio.loss", "0.2"}};
  const auto hash = [&](std::uint64_t seed) {
    return run_in_process(transit_scenario("transit-power-station", seed, lossy), {}).report.at("state_hash");
  };
  EXPECT_EQ(hash(1), hash(1));
  EXPECT_NE(hash(1), hash(2));
}

TEST(Transit, EveryScenarioIsCrossed) {
  for (const char* name : {"transit-power-station", "transit-power-station-3d", "transit-corridor", "transit-forest",
                           "transit-maze", "transit-partition"}) {
    const Json report = run_in_process(transit_scenario(name, 1), {}).report;
    EXPECT_EQ(report.at("exit_code"), 0) << name << ": " << report.at("reason");
    EXPECT_EQ(report.at("collisions"), 0) << name;
    EXPECT_EQ(count_status(report, "arrived"), report.at("vehicles").size()) << name;
    EXPECT_GT(report.at("min_clearance_m").get<double>(), 0.0) << name;
  }
}

}  // namespace
}  // namespace skein
