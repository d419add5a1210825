// The report of a transit: who arrived, how far, beside the shortest way; the radio; the maps.
#include <gtest/gtest.h>

#include "simworld/report/report.hpp"
#include "tests/simworld/lockstep/stage.hpp"
#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;
using test::map_sample;
using test::Stage;

/// Agent 1 has 20 m to fly, agent 2 has no way: a wall from x 40 to 44 is between it and its goal.
Scenario walled() {
  Scenario scenario;
  scenario.mission = test::transit_of({test::crosser(1, Vec3(6, 18, 6)), test::crosser(2, Vec3(6, 30, 6))},
                                      {Vec3(26, 18, 6), Vec3(74, 30, 6)});
  scenario.mission.transit->radio.bit_rate_bps = 8000.0;
  scenario.world.hidden = {{Box{Vec3(40, 0, 0), Vec3(44, 40, 9)}, "wall"}};
  return scenario;
}

/// Two steps: agent 1 tells its map in the first and arrives in the second; agent 2 hovers, then gives up. Maps are
/// equal in the second step, if asked.
Json report_of(bool equal) {
  const Scenario scenario = walled();
  Stage stage(scenario);
  Tick tick = stage.round(stage.start(), AgentMode::Ready);
  for (std::uint32_t step = 1; step <= 2; ++step) {
    for (const AgentId id : {1U, 2U}) {
      Beacon beacon = test::closing(id, tick.round, AgentMode::Flying);
      beacon.obstacle_map = step == 1 && id == 1;
      if (id == 2) beacon.commanded_velocity_mps = Vec3::Zero();
      if (id == 2 && step == 2) beacon.mode = AgentMode::Unreachable;
      beacon.map_hash = step == 2 && equal ? 9 : id;
      if (beacon.obstacle_map) stage.say(map_sample(id, tick.round));
      stage.say(beacon);
    }
    stage.at(0.1 * step);
    tick = stage.last_tick();
  }
  EXPECT_EQ(tick.phase, Phase::Finished);
  stage.session.give_up();
  return make_report(stage.session, scenario, {.carrier = "in-process"});
}

TEST(TransitReport, SaysWhoArrivedAndHowFarAllFlew) {
  const Json report = report_of(true);
  EXPECT_EQ(report.at("exit_code"), 1);
  EXPECT_EQ(report.at("success"), false);
  EXPECT_EQ(report.at("reason"), "vehicle 2: unreachable");
  EXPECT_EQ(report.at("planner"), "peach3d");
  EXPECT_EQ(report.at("arrived"), 1);
  EXPECT_EQ(report.at("steps"), 2);
  EXPECT_EQ(report.at("collisions"), 0);
  EXPECT_NEAR(report.at("total_path_m").get<double>(), 20.0, 1e-12);
  for (const char* key : {"plan_feasible", "plan_success", "plan_spread_m"}) EXPECT_TRUE(report.at(key).is_null());
}

TEST(TransitReport, SetsTheShortestWayBesideEachFlight) {
  const Json vehicles = report_of(true).at("vehicles");
  EXPECT_EQ(vehicles.at(0).at("status"), "arrived");
  EXPECT_EQ(vehicles.at(0).at("arrival_step"), 2);
  EXPECT_NEAR(vehicles.at(0).at("path_length_m").get<double>(), 20.0, 1e-12);
  EXPECT_NEAR(vehicles.at(0).at("shortest_path_m").get<double>(), 20.0, 4.0 + 1e-9);
  EXPECT_EQ(vehicles.at(1).at("status"), "unreachable");
  EXPECT_EQ(vehicles.at(1).at("reason"), "found no way to its goal");
  EXPECT_TRUE(vehicles.at(1).at("shortest_path_m").is_null());
}

TEST(TransitReport, SaysWhatTheRadioCarried) {
  const Json report = report_of(true);
  const Json& radio = report.at("radio");
  const std::size_t bytes = payload_bytes(1, 0);
  EXPECT_EQ(radio.at("sent_samples"), 1);
  EXPECT_EQ(radio.at("sent_bytes"), bytes);
  EXPECT_EQ(radio.at("slot_bits"), 4000.0);
  EXPECT_EQ(radio.at("peak_slot_bits"), 192.0 + 8.0 * static_cast<double>(bytes));
  EXPECT_EQ(radio.at("over_budget"), 0);
  ASSERT_EQ(radio.at("links").size(), 1U);
  const Json& link = radio.at("links").at(0);
  EXPECT_EQ(link.at("from"), 1);
  EXPECT_EQ(link.at("to"), 2);
  EXPECT_EQ(link.at("samples"), 1);
  EXPECT_EQ(link.at("bytes"), bytes);
  EXPECT_EQ(link.at("lost"), 0);
  EXPECT_EQ(link.at("age_p50"), 1);
  EXPECT_EQ(link.at("age_p95"), 2);
  EXPECT_EQ(report.at("partitions"), (Json::array({Json{{"step", 1}, {"groups", 1}}})));
  EXPECT_EQ(report.at("topics").at("obstacle_map").at("samples"), 1);
}

TEST(TransitReport, SaysWhetherTheMapsAreEqual) {
  const Json equal = report_of(true);
  EXPECT_EQ(equal.at("map_equal"), true);
  EXPECT_EQ(equal.at("map_equal_since_step"), 2);
  const Json different = report_of(false);
  EXPECT_EQ(different.at("map_equal"), false);
  EXPECT_TRUE(different.at("map_equal_since_step").is_null());
  EXPECT_GT(different.at("map_settling_steps"), 2) << "which the run did not last";
  EXPECT_EQ(different.at("maps_due"), 0);
  EXPECT_EQ(different.at("maps_differ"), 0);
  EXPECT_EQ(different.at("unaccepted_plans"), 0);
  EXPECT_TRUE(different.at("first_unaccepted_plan").is_null());
}

TEST(TransitReport, OtherMissionsHaveNoRadio) {
  Scenario scenario;
  scenario.mission = test::abreast(1);
  Stage stage(scenario);
  stage.session.process_ended(1, 0.0);
  const Json report = make_report(stage.session, scenario, {.carrier = "in-process"});
  for (const char* key : {"radio", "partitions", "map_equal", "maps_due", "arrived", "total_path_m"}) {
    EXPECT_FALSE(report.contains(key)) << key;
  }
}

}  // namespace
}  // namespace skein
