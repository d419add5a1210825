// What the report says of surprises: contacts by kind, movers, events, attempts to plan anew.
#include "simworld/report/flight_report.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/rounds.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

/// One multirotor that stands at (-25, 100, 0), in the way of what comes from the east; `second` never appears.
Run standing() {
  Mission mission = test::abreast(1);
  mission.vehicles[0].type = VehicleType::Multirotor;
  mission.vehicles[0].max_acceleration_mps2 = 4.0;
  mission.planner.replan = 1;
  mission.planner.rounds_per_step = 3;
  WorldOptions options;
  Mover first;
  first.name = "moving_obstacles.1";
  first.position_m = Vec3(-15, 100, 0);
  first.radius_m = 2.0;
  first.motion = LineMotion{Vec3(-4, 0, 0)};
  Mover second = first;
  second.name = "sudden_obstacles.1";
  second.at_s = 1000.0;
  second.sudden = true;
  second.column = true;
  options.surprises.movers = {first, second};
  return {test::kRun, mission, options, false};
}

Json report_of(const Run& run) {
  Json report;
  add_surprises(report, run);
  return report;
}

TEST(FlightReport, SaysNothingWhereNothingHappened) {
  const skein::Run run(test::kRun, test::abreast(1), {}, false);
  const Json report = report_of(run);
  for (const char* key : {"rammed_at_rest", "mover_contacts", "zone_entries", "replan_rounds", "events_left_out"}) {
    EXPECT_EQ(report.at(key), 0) << key;
  }
  for (const char* key : {"movers", "replans", "events"}) EXPECT_EQ(report.at(key), Json::array()) << key;
}

TEST(FlightReport, TellsMoversAndContacts) {
  skein::Run run = standing();
  Tick tick = test::decide(run, run.begin(test::roster_of(1)), AgentMode::Ready);
  for (int i = 0; i < 3; ++i) {
    tick = test::decide(run, tick, AgentMode::Flying, {},
                        [](Beacon& beacon) { beacon.commanded_velocity_mps = Vec3::Zero(); });
  }
  const Json report = report_of(run);
  EXPECT_EQ(report.at("rammed_at_rest"), 1);
  EXPECT_EQ(report.at("mover_contacts"), 0);
  ASSERT_EQ(report.at("movers").size(), 2U);
  EXPECT_EQ(report.at("movers")[0].at("id"), 1);
  EXPECT_EQ(report.at("movers")[0].at("name"), "moving_obstacles.1");
  EXPECT_EQ(report.at("movers")[0].at("speed_mps"), 4.0);
  EXPECT_EQ(report.at("movers")[0].at("appeared_step"), 1);
  EXPECT_TRUE(report.at("movers")[0].at("gone_step").is_null());
  EXPECT_EQ(report.at("movers")[1].at("column"), true);
  EXPECT_TRUE(report.at("movers")[1].at("appeared_step").is_null());
}

TEST(FlightReport, TellsEventsAndAttempts) {
  skein::Run run = standing();
  Tick tick = test::decide(run, run.begin(test::roster_of(1)), AgentMode::Ready);
  const auto blocked = [](Beacon& beacon) {
    beacon.safety_mode = SafetyMode::Hold;
    beacon.safety_reason = SafetyReason::Blocked;
    beacon.deviation_m = 2.5;
  };
  tick = test::decide(run, tick, AgentMode::Replanning, {}, blocked);
  tick = test::decide(run, tick, AgentMode::Replanning, {}, blocked);
  tick = test::decide(run, tick, AgentMode::Replanning, {}, blocked);
  tick = test::decide(run, tick, AgentMode::Flying);
  const Json report = report_of(run);
  EXPECT_EQ(report.at("replan_rounds"), 2);
  ASSERT_EQ(report.at("events").size(), 2U);
  const Json& event = report.at("events")[0];
  EXPECT_EQ(event.at("step"), 1);
  EXPECT_EQ(event.at("round"), 2);
  EXPECT_EQ(event.at("agent"), 1);
  EXPECT_EQ(event.at("mode"), "hold");
  EXPECT_EQ(event.at("reason"), "blocked");
  EXPECT_EQ(event.at("replanning"), true);
  EXPECT_EQ(event.at("deviation_m"), 2.5);
  EXPECT_EQ(report.at("events")[1].at("mode"), "autonomous");
  ASSERT_EQ(report.at("replans").size(), 1U);
  const Json& replan = report.at("replans")[0];
  EXPECT_EQ(replan.at("step"), 1);
  EXPECT_EQ(replan.at("agent"), 1);
  EXPECT_EQ(replan.at("reason"), "blocked");
  EXPECT_TRUE(replan.at("switch_step").is_null());
  EXPECT_EQ(replan.at("ended_step"), 2);
  EXPECT_EQ(replan.at("outcome"), "switched");
}

}  // namespace
}  // namespace skein
