// The report: figures of runs made by hand, null where there is none, exit codes, and the roster read back.
#include "simworld/report/report.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;
using test::Stage;

Scenario scenario_of(AgentId count) {
  Scenario scenario;
  scenario.mission = test::abreast(count);
  scenario.scenario_hash = 0xabc;
  return scenario;
}

/// A run of two that plans two rounds and flies three steps, each phase a second long; agent 2 is lost at step 2 if
/// asked.
void run_to_the_end(Stage& stage, bool lose) {
  Tick tick = stage.start();
  tick = stage.round(tick, AgentMode::Planning);
  stage.at(1.0);
  tick = stage.round(tick, AgentMode::Ready);
  tick = stage.round(tick, AgentMode::Flying);
  if (lose) stage.session.process_ended(2, 1.0);
  tick = stage.round(tick, AgentMode::Flying);
  stage.at(2.0);
  (void)stage.take_ticks();
  (void)stage.round(tick, AgentMode::Flying);
  stage.session.give_up();
}

TEST(Report, SaysWhatARunCameTo) {
  Stage stage(2);
  run_to_the_end(stage, false);
  const Json report = make_report(stage.session, scenario_of(2), {"dds"});
  EXPECT_EQ(report.at("success"), true);
  EXPECT_EQ(report.at("exit_code"), 0);
  EXPECT_EQ(report.at("reason"), "all vehicles arrived in formation");
  EXPECT_EQ(report.at("completed_without"), Json::array());
  EXPECT_EQ(report.at("seed"), 5);
  EXPECT_EQ(report.at("scenario"), "small");
  EXPECT_EQ(report.at("scenario_hash"), "0000000000000abc");
  EXPECT_EQ(report.at("state_hash").get<std::string>().size(), 16U);
  EXPECT_EQ(report.at("carrier"), "dds");
  EXPECT_EQ(report.at("version"), version());
  EXPECT_EQ(report.at("steps"), 3);
  EXPECT_EQ(report.at("rounds"), 2);
  EXPECT_EQ(report.at("collisions"), 0);
  EXPECT_EQ(report.at("min_separation_m"), 100.0);
  EXPECT_TRUE(report.at("min_clearance_m").is_null());
  EXPECT_EQ(report.at("discovery_s"), 0.0);
  EXPECT_EQ(report.at("plan_s"), 1.0);
  EXPECT_EQ(report.at("rounds_per_s"), 2.0);
  EXPECT_EQ(report.at("steps_per_s"), 3.0);
  EXPECT_EQ(report.at("realtime_factor"), 3.0);
  EXPECT_EQ(report.at("roster_changes"), Json::array());
  EXPECT_EQ(report.at("topics").at("mission").at("samples"), 1);
  EXPECT_EQ(report.at("topics").at("beacon").at("samples"), 10);
  EXPECT_GT(report.at("topics").at("beacon").at("bytes"), 1000);
}

TEST(Report, SaysHowEachVehicleDid) {
  Stage stage(2);
  run_to_the_end(stage, true);
  const Json report = make_report(stage.session, scenario_of(2), {"dds"});
  const Json& first = report.at("vehicles").at(0);
  EXPECT_EQ(first.at("id"), 1);
  EXPECT_EQ(first.at("status"), "arrived");
  EXPECT_EQ(first.at("arrival_step"), 3);
  EXPECT_NEAR(first.at("arrival_time_s").get<double>(), 2.5, 1e-12);
  EXPECT_NEAR(first.at("path_length_m").get<double>(), 30.0, 1e-12);
  EXPECT_EQ(first.at("planned_length_m"), 1001.0);
  EXPECT_EQ(first.at("reason"), "");
  const Json& second = report.at("vehicles").at(1);
  EXPECT_EQ(second.at("status"), "removed");
  EXPECT_TRUE(second.at("arrival_step").is_null());
  EXPECT_TRUE(second.at("arrival_time_s").is_null());
  EXPECT_EQ(second.at("reason"), "agent lost: process_ended");
  EXPECT_EQ(report.at("exit_code"), 4);
  EXPECT_EQ(report.at("success"), false);
  EXPECT_EQ(report.at("completed_without"), Json::array({2}));
}

TEST(Report, FiguresThatDoNotExistAreNull) {
  Stage stage(1);
  stage.session.refuse_start("another world has the swarm", 0.1);
  stage.at(0.2);
  const Json report = make_report(stage.session, scenario_of(1), {"dds"});
  EXPECT_EQ(report.at("exit_code"), 3);
  EXPECT_EQ(report.at("reason"), "another world has the swarm");
  for (const char* name : {"discovery_s", "plan_s", "rounds_per_s", "steps_per_s", "realtime_factor",
                           "min_separation_m", "min_clearance_m", "pss_mb_per_agent"}) {
    EXPECT_TRUE(report.at(name).is_null()) << name;
  }
  EXPECT_EQ(report.at("steps"), 0);
}

TEST(Report, ExitCodesInTheirOrder) {
  Stage lost(1);
  lost.session.process_ended(1, 0.1);
  EXPECT_EQ(lost.session.outcome().exit_code, 4);
  Stage interrupted(1);
  (void)interrupted.start();
  interrupted.session.interrupt("ended by signal 2", 130, 0.1);
  const Json report = make_report(interrupted.session, scenario_of(1), {"dds"});
  EXPECT_EQ(report.at("exit_code"), 130);
  EXPECT_EQ(report.at("reason"), "ended by signal 2");
}

TEST(Report, WallTimesReplaceTheSessionsClock) {
  Stage stage(2);
  run_to_the_end(stage, false);
  const PhaseTimes wall{10.0, 10.5, 12.5, 14.0};
  const Json report = make_report(stage.session, scenario_of(2), {.carrier = "in-process", .wall = wall});
  EXPECT_EQ(report.at("discovery_s"), 0.5);
  EXPECT_EQ(report.at("plan_s"), 2.0);
  EXPECT_EQ(report.at("rounds_per_s"), 1.0);
  EXPECT_EQ(report.at("steps_per_s"), 2.0);
}

TEST(RosterChanges, ComeBackAsTheyWereWritten) {
  Stage stage(2);
  run_to_the_end(stage, true);
  const Json report = make_report(stage.session, scenario_of(2), {"dds"});
  const auto changes = roster_changes_of(nlohmann::json::parse(report.dump()));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes, stage.session.run().changes());
  EXPECT_TRUE(roster_changes_of({{"roster_changes", nlohmann::json::array()}}).empty());
}

/// The line that a report with this text is refused with, or nothing.
std::string refusal_of(const std::string& text) {
  try {
    (void)roster_changes_of(nlohmann::json::parse(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(RosterChanges, MistakesAreNamed) {
  EXPECT_EQ(refusal_of("{}"), "the report has no list roster_changes");
  EXPECT_EQ(refusal_of(R"({"roster_changes": 3})"), "the report has no list roster_changes");
  const std::string good = R"({"step":1,"round":2,"agent":3,"incarnation":1,"reason":"left"})";
  EXPECT_EQ(refusal_of(R"({"roster_changes": [)" + good + "]}"), "");
  EXPECT_EQ(refusal_of(R"({"roster_changes": [)" + good +
                       R"(,{"step":1,"round":2,"agent":3,"incarnation":1,"reason":"bored"}]})"),
            "roster_changes[1]: unknown reason");
  for (const char* bad : {R"({"round":2,"agent":3,"incarnation":1,"reason":"left"})",
                          R"({"step":"x","round":2,"agent":3,"incarnation":1,"reason":"left"})", "7",
                          R"({"step":1,"round":2.5,"agent":3,"incarnation":1,"reason":"left"})",
                          R"({"step":1,"round":-2,"agent":3,"incarnation":1,"reason":"left"})",
                          R"({"step":1,"round":99999999999,"agent":3,"incarnation":1,"reason":"left"})",
                          R"({"step":1,"round":2,"agent":0,"incarnation":1,"reason":"left"})"}) {
    const std::string line = refusal_of(std::string(R"({"roster_changes": [)") + bad + "]}");
    EXPECT_EQ(line.rfind("roster_changes[0]: ", 0), 0U) << bad << " gives: " << line;
  }
}

}  // namespace
}  // namespace skein
