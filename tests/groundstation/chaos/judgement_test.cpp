// What a report is judged to be, and what a campaign sums up: made by hand, with one thing wrong each.
#include "groundstation/chaos/judgement.hpp"

#include <gtest/gtest.h>

#include "groundstation/chaos/campaign.hpp"
#include "groundstation/inprocess/in_process.hpp"

namespace skein::chaos {
namespace {

const Scenario& small() {
  static const Scenario scenario =
      std::get<Scenario>(load_scenario(SKEIN_SOURCE_DIR "/tests/data/small.yaml", {}, std::nullopt));
  return scenario;
}

/// The report of a run of two that `faults` befell, as the launcher completes it.
nlohmann::json report_with(const std::vector<Fault>& faults = {}) {
  InProcessOptions options;
  options.faults = faults;
  nlohmann::json report = nlohmann::json::parse(run_in_process(small(), options).report.dump());
  for (const int agent : {1, 2}) report["processes"].push_back({{"agent", agent}, {"ended_by", "exit status 0"}});
  return report;
}

/// Of a run whose fault befell agent 2, unless it was the world's.
RunOutcome judged(const nlohmann::json& report, Kind kind = Kind::Kill) {
  RunOutcome outcome;
  outcome.kind = kind;
  outcome.injected = true;
  if (kind != Kind::World) outcome.befallen = {2};
  outcome.exit_code = report.is_object() ? report.value("exit_code", -1) : 2;
  judge(report, small(), outcome);
  return outcome;
}

TEST(Judgement, ARunThatSucceededIsCompleted) {
  const RunOutcome outcome = judged(report_with());
  EXPECT_EQ(outcome.result, Result::Completed);
  EXPECT_EQ(outcome.reason, "all vehicles arrived in formation");
  EXPECT_TRUE(is_sound(outcome));
  EXPECT_EQ(outcome.recovery_steps, std::nullopt);
}

TEST(Judgement, ALossIsDegradedWithItsReasonAndARestartIsARecovery) {
  nlohmann::json report =
      report_with({{FaultKind::Kill, 2, Phase::Flying, 40}, {FaultKind::Restart, 2, Phase::Flying, 52}});
  report["processes"][1]["ended_by"] = "signal 9 (Killed)";
  const RunOutcome outcome = judged(report);
  EXPECT_EQ(outcome.result, Result::Degraded);
  EXPECT_NE(outcome.reason.find("agent 2 was lost"), std::string::npos);
  EXPECT_TRUE(is_sound(outcome));
  EXPECT_EQ(outcome.recovery_steps, 12U);
  EXPECT_EQ(outcome.recovery_s, 6.0);
  EXPECT_TRUE(is_sound(judged(report, Kind::Slow))) << "who stands still at the end is killed";
  EXPECT_FALSE(is_sound(judged(report, Kind::World))) << "no agent dies of the world's death";
  report["processes"][0]["ended_by"] = "signal 9 (Killed)";
  EXPECT_EQ(judged(report).unexplained, std::vector<std::string>{"agent 1: signal 9 (Killed)"})
      << "another one's fault";
}

TEST(Judgement, WhatBreaksAnInvariantIsNotSound) {
  nlohmann::json report = report_with();
  report["collisions"] = 1;
  EXPECT_EQ(judged(report).result, Result::Unsafe);
  EXPECT_FALSE(is_sound(judged(report)));
  report = report_with();
  report["state_hash"] = "0000000000000000";
  EXPECT_TRUE(judged(report).replay_differs);
  report = report_with();
  report["processes"][0]["ended_by"] = "signal 11 (Segmentation fault)";
  EXPECT_EQ(judged(report).unexplained, std::vector<std::string>{"agent 1: signal 11 (Segmentation fault)"});
  report = report_with();
  report["unaccepted_plans"] = 7;
  report["first_unaccepted_plan"] = {{"agent", 2}, {"step", 5}};
  EXPECT_EQ(judged(report).unaccepted, std::vector<std::string>{"7 agent-rounds, first agent 2 at step 5"});
  EXPECT_FALSE(is_sound(judged(report)));
  report = report_with();
  report["maps_due"] = 4;
  EXPECT_TRUE(is_sound(judged(report)));
  report["maps_differ"] = 2;
  EXPECT_EQ(judged(report).maps_differ, 2U);
  EXPECT_FALSE(is_sound(judged(report)));
  EXPECT_FALSE(is_sound(judged(nullptr)));
  EXPECT_EQ(judged(nullptr).unexplained, std::vector<std::string>{"no report, exit code 2"});
}

TEST(Judgement, WhoIsCutOffUntilTheRunIsOverIsAskedToEnd) {
  nlohmann::json report = report_with();
  report["processes"][1]["ended_by"] = "exit status 143";
  EXPECT_TRUE(is_sound(judged(report, Kind::Partition)));
  EXPECT_FALSE(is_sound(judged(report, Kind::Slow)));
}

TEST(Judgement, ARunThatNeverBeganIsDegradedAndNotRepeated) {
  nlohmann::json report = report_with();
  report["exit_code"] = 3;
  report["reason"] = "start-up timed out after 30 s: 0 of 2 agents matched";
  report["state_hash"] = "0000000000000000";
  report["processes"][0]["ended_by"] = "exit status 3";
  report["processes"][1]["ended_by"] = "exit status 143";
  const RunOutcome outcome = judged(report);
  EXPECT_EQ(outcome.result, Result::Degraded);
  EXPECT_TRUE(is_sound(outcome));
  report["processes"][0]["ended_by"] = "signal 11 (Segmentation fault)";
  EXPECT_FALSE(is_sound(judged(report)));
}

TEST(Judgement, TheWorldsRecoveryIsInSeconds) {
  nlohmann::json report = report_with();
  report["world_recovery_s"] = {0.25, 0.75};
  const RunOutcome outcome = judged(report, Kind::World);
  EXPECT_EQ(outcome.recovery_steps, 0U);
  EXPECT_EQ(outcome.recovery_s, 0.75);
}

TEST(Summary, CountsByKindAndNamesEachReason) {
  RunOutcome good = judged(report_with());
  good.kind = Kind::Pause;
  good.seed = 3;
  RunOutcome slow = good;
  slow.seed = 4;
  slow.recovery_steps = 4;
  RunOutcome hung;
  hung.kind = Kind::Stop;
  hung.seed = 9;
  hung.fault = "stop:1@fly:3";
  hung.result = Result::Hung;
  hung.reason = "it did not end within 120 s";
  hung.orphans = {"process 12"};
  slow.maps_due = 3;
  good.maps_due = 3;
  good.maps_differ = 2;
  hung.unaccepted = {"3 agent-rounds, first agent 1 at step 2"};
  const auto summary = summary_of({good, slow, hung});
  EXPECT_EQ(summary.at("maps_judged"), 2);
  EXPECT_EQ(summary.at("maps_differ"), 1);
  EXPECT_EQ(summary.at("unaccepted_plans"), 1);
  EXPECT_EQ(summary.at("runs"), 3);
  EXPECT_EQ(summary.at("completed"), 2);
  EXPECT_EQ(summary.at("hangs"), 1);
  EXPECT_EQ(summary.at("orphans"), 1);
  EXPECT_EQ(summary.at("replay_mismatches"), 0);
  EXPECT_EQ(summary.at("faults").at("pause").at("completed"), 2);
  EXPECT_EQ(summary.at("faults").at("pause").at("recovery_steps").at("mean"), 4.0);
  EXPECT_TRUE(summary.at("faults").at("pause").at("recovery_s").is_null());
  EXPECT_EQ(summary.at("faults").at("stop").at("reasons").at(0).at("reason"), "it did not end within 120 s");
  const std::string text = text_of(summary);
  EXPECT_NE(text.find("seed 9, stop:1@fly:3: hung: it did not end within 120 s\n  orphans: process 12\n"
                      "  unaccepted_plans: 3 agent-rounds, first agent 1 at step 2\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  maps differ that had the time to become equal\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("seed 4"), std::string::npos) << "what went well is not told one by one";
}

}  // namespace
}  // namespace skein::chaos
