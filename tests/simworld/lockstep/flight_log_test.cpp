// The log of a flight: changes alone are events, attempts to plan anew have callers, reasons and ends.
#include "simworld/lockstep/flight_log.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

using Edit = std::function<void(Beacon&)>;

/// Two agents answer a round of the flight; a revision of agent 2 goes with it, if given.
void add(FlightLog& log, std::uint32_t step, std::uint32_t round, const Edit& edit = {},
         const std::optional<Revision>& revision = {}) {
  Barrier barrier;
  const Tick tick = test::tick_of(round, 2, Phase::Flying);
  barrier.open(tick, 0.0);
  for (const AgentId id : {1U, 2U}) {
    Beacon beacon = test::closing(id, round, AgentMode::Flying);
    beacon.representative = id == 2 && revision;
    if (edit) edit(beacon);
    barrier.accept(beacon);
  }
  if (revision) {
    Representative sample = test::representative(2, round);
    sample.revision = revision;
    barrier.accept(sample);
  }
  log.add(step, round, barrier, tick.roster);
}

Edit all_replan() {
  return [](Beacon& beacon) { beacon.mode = AgentMode::Replanning; };
}

Revision called(std::uint32_t attempt, std::uint32_t switch_step) {
  Revision revision;
  revision.attempt = attempt;
  revision.switch_step = switch_step;
  revision.reason = SafetyReason::Blocked;
  return revision;
}

TEST(FlightLog, KeepsChangesAlone) {
  FlightLog log;
  add(log, 1, 5);
  EXPECT_TRUE(log.events().empty()) << "autonomous from the start";
  const Edit controlled = [](Beacon& beacon) {
    if (beacon.agent != 2) return;
    beacon.safety_mode = SafetyMode::Controlled;
    beacon.safety_reason = SafetyReason::Obstacle;
    beacon.deviation_m = 3.5;
    beacon.predicted_separation_m = 12.0;
  };
  add(log, 2, 6, controlled);
  add(log, 3, 7, controlled);
  add(log, 4, 8);
  ASSERT_EQ(log.events().size(), 2U);
  const FlightEvent& first = log.events()[0];
  EXPECT_EQ(first.step, 2U);
  EXPECT_EQ(first.round, 6U);
  EXPECT_EQ(first.agent, 2U);
  EXPECT_EQ(first.mode, SafetyMode::Controlled);
  EXPECT_EQ(first.reason, SafetyReason::Obstacle);
  EXPECT_EQ(first.deviation_m, 3.5);
  EXPECT_EQ(first.predicted_separation_m, 12.0);
  EXPECT_EQ(log.events()[1].mode, SafetyMode::Autonomous);
  EXPECT_TRUE(log.replans().empty());
}

TEST(FlightLog, CountsWhatItLeavesOut) {
  FlightLog log;
  for (std::uint32_t step = 1; step <= 3000; ++step) {
    add(log, step, step,
        [&](Beacon& beacon) { beacon.mode = step % 2 == 1 ? AgentMode::Replanning : AgentMode::Flying; });
  }
  EXPECT_EQ(log.events().size(), 4096U);
  EXPECT_EQ(log.events_left_out(), 6000U - 4096U);
  EXPECT_EQ(log.replans().size(), 1024U);
}

TEST(FlightLog, AnAttemptHasItsCallerAndItsEnd) {
  FlightLog log;
  add(log, 10, 20, all_replan(), called(20, 18));
  add(log, 11, 21, all_replan());
  add(log, 18, 90);
  ASSERT_EQ(log.replans().size(), 1U);
  const Replan& replan = log.replans()[0];
  EXPECT_EQ(replan.step, 10U);
  EXPECT_EQ(replan.agent, 2U);
  EXPECT_EQ(replan.reason, SafetyReason::Blocked);
  EXPECT_EQ(replan.switch_step, 18U);
  EXPECT_EQ(replan.ended_step, 18U);
  EXPECT_EQ(replan.outcome, ReplanOutcome::Switched);
  EXPECT_EQ(name_of(replan.outcome), "switched");
}

TEST(FlightLog, WhoHasNoPlanInTheEndSaysSo) {
  FlightLog log;
  add(log, 10, 20, all_replan());
  add(log, 18, 90, [](Beacon& beacon) {
    if (beacon.agent == 1) beacon.safety_reason = SafetyReason::NoPlan;
  });
  ASSERT_EQ(log.replans().size(), 1U);
  EXPECT_EQ(log.replans()[0].agent, 1U) << "nobody said who called: the first by id";
  EXPECT_EQ(log.replans()[0].outcome, ReplanOutcome::NoPlan);
}

TEST(FlightLog, ALaterCallTakesThePlaceOfTheOpenOne) {
  FlightLog log;
  add(log, 10, 20, all_replan(), called(20, 18));
  add(log, 14, 50, all_replan(), called(50, 22));
  ASSERT_EQ(log.replans().size(), 2U);
  EXPECT_EQ(log.replans()[0].outcome, ReplanOutcome::Replaced);
  EXPECT_EQ(log.replans()[1].outcome, ReplanOutcome::Open);
  EXPECT_EQ(log.replans()[1].step, 14U);
  EXPECT_EQ(log.replans()[1].switch_step, 22U);
}

}  // namespace
}  // namespace skein
