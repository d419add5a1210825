// The world's session while it runs: rounds, repeats, losses, faults on purpose, the end.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::closing;
using test::Stage;
using State = WorldSession::State;

/// Both answered, so that the swarm flies: the tick of step 1.
Tick take_off(Stage& stage) {
  return stage.round(stage.start(), AgentMode::Ready);
}

TEST(SessionRun, FliesToTheEndAndWaitsForTheLastAnswers) {
  Stage stage(2);
  Tick tick = take_off(stage);
  EXPECT_EQ(tick.phase, Phase::Flying);
  for (int step = 0; step < 3; ++step) tick = stage.round(tick, AgentMode::Flying);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(stage.session.state(), State::Closing);
  stage.say(closing(1, tick.round, AgentMode::Arrived));
  stage.at(1.9);
  EXPECT_EQ(stage.session.state(), State::Closing);
  stage.say(closing(2, tick.round, AgentMode::Arrived));
  stage.at(1.9);
  EXPECT_EQ(stage.session.state(), State::Done);
  EXPECT_EQ(stage.session.run().verdict().code, ExitCode::Success);
  EXPECT_EQ(stage.session.topics().beacon.samples, 10U);
  EXPECT_EQ(stage.session.topics().sense.samples, 6U);
}

TEST(SessionRun, DoesNotWaitForeverForTheLastAnswers) {
  Stage stage(1);
  (void)stage.start();
  stage.session.interrupt("ended by signal 2", 130, 0.0);
  stage.at(2.0);
  EXPECT_EQ(stage.session.state(), State::Closing);
  stage.at(2.1);
  EXPECT_EQ(stage.session.state(), State::Done);
}

TEST(SessionRun, SensesGoOutBeforeTheTick) {
  Stage stage(2);
  const Tick first = stage.start();
  for (AgentId id : {1U, 2U}) stage.say(closing(id, first.round, AgentMode::Ready));
  stage.at(0.0);
  ASSERT_EQ(stage.port.sent.size(), 3U);
  const auto* sense = std::get_if<wire::Sense>(&stage.port.sent[0]);
  ASSERT_NE(sense, nullptr);
  const Sense value = from_wire(*sense, {}).value();
  EXPECT_EQ(value.agent, 1U);
  EXPECT_EQ(value.round, 2U);
  EXPECT_EQ(value.pose.position_m, Vec3(-25.0, 100.0, 0.0));
  EXPECT_EQ(value.velocity_mps, Vec3(10.0, 0.0, 0.0));
  EXPECT_TRUE(std::holds_alternative<wire::Tick>(stage.port.sent[2]));
}

TEST(SessionRun, RepeatsAnUnansweredTickEverySecondToWhoeverOwesTheAnswer) {
  Stage stage(2);
  const Tick tick = take_off(stage);
  stage.say(closing(1, tick.round, AgentMode::Flying));
  stage.at(0.9);
  EXPECT_TRUE(stage.port.sent.empty());
  stage.at(1.0);
  ASSERT_EQ(stage.port.sent.size(), 2U);  // the tick, and agent 2's sense
  const auto* sense = std::get_if<wire::Sense>(&stage.port.sent[1]);
  ASSERT_NE(sense, nullptr);
  EXPECT_EQ(sense->agent(), 2U);
  EXPECT_EQ(stage.last_tick(), tick);
  stage.at(1.9);
  EXPECT_TRUE(stage.port.sent.empty());
  stage.at(2.0);
  EXPECT_EQ(stage.last_tick(), tick);
}

TEST(SessionRun, DropsWhoeverLeavesATickUnansweredForTheDeadline) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.say(closing(1, tick.round));
  stage.until(9.9);
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.until(10.0);
  const Tick next = stage.last_tick();
  ASSERT_EQ(next.roster.size(), 1U);
  EXPECT_EQ(next.round, tick.round + 1);
  ASSERT_EQ(stage.session.run().changes().size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0], (RosterChange{0, 2, 2, 1, LossReason::Deadline}));
}

TEST(SessionRun, TimeInWhichTheWorldWasStoppedCountsAgainstNobody) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.say(closing(1, tick.round));
  stage.until(2.0);
  stage.at(60.0);  // stopped and continued
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.until(67.0);
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.until(70.0);
  EXPECT_EQ(stage.session.run().changes().size(), 1U);
}

TEST(SessionRun, AGoodbyeDropsAtOnce) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.say(closing(1, tick.round));
  Beacon goodbye = closing(2, 0, AgentMode::Leaving);
  goodbye.closes_round = false;
  stage.say(goodbye);
  stage.at(0.1);
  EXPECT_EQ(stage.last_tick().roster.size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0].reason, LossReason::Left);
}

TEST(SessionRun, AGoodbyeOfAnUnadmittedProcessDropsNobody) {
  Stage stage(2);
  const Tick tick = stage.start();
  Beacon goodbye = test::introduction(2, {}, 555);  // a second process with id 2, ended while it waited
  goodbye.mode = AgentMode::Leaving;
  stage.say(goodbye);
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(0.1);
  EXPECT_EQ(stage.last_tick().roster.size(), 2U);
  EXPECT_TRUE(stage.session.run().changes().empty());
}

TEST(SessionRun, AGoodbyeOfAnAgentThatHasNotHeardOfItsAdmissionDropsIt) {
  Stage stage(2);
  const Tick tick = stage.start();
  Beacon goodbye = test::introduction(2, {});
  goodbye.mode = AgentMode::Leaving;
  stage.say(goodbye);
  stage.say(closing(1, tick.round));
  stage.at(0.1);
  EXPECT_EQ(stage.last_tick().roster.size(), 1U);
}

TEST(SessionRun, AnEndedProcessIsDroppedAtOnce) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.session.process_ended(2, 0.1);
  stage.session.process_ended(2, 0.1);
  stage.say(closing(1, tick.round));
  stage.at(0.1);
  EXPECT_EQ(stage.last_tick().roster.size(), 1U);
  EXPECT_EQ(stage.session.run().changes().size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0].reason, LossReason::ProcessEnded);
}

TEST(SessionRun, ServesNeedsWithTheUnchangedSample) {
  Stage stage(2);
  const Tick tick = stage.start();
  for (AgentId id : {1U, 2U}) {
    Beacon beacon = closing(id, tick.round);
    beacon.representative = true;
    stage.say(test::representative(id, tick.round));
    stage.say(beacon);
  }
  stage.at(0.0);
  EXPECT_TRUE(stage.last_tick().roster[1].representative);
  Beacon open = closing(1, tick.round);
  open.closes_round = false;
  open.needs = {{2, tick.round}, {1, tick.round + 1}, {2, 99}};
  stage.say(open);
  stage.at(0.5);
  const auto repeated = stage.take_sent<wire::Representative>();
  ASSERT_EQ(repeated.size(), 1U);
  EXPECT_EQ(from_wire(repeated[0], {}).value(), test::representative(2, tick.round));
  EXPECT_EQ(stage.session.topics().representative.samples, 2U);
}

TEST(SessionRun, CountsRefusedSamplesAndGoesOn) {
  Stage stage(1);
  const Tick tick = stage.start();
  Beacon foreign = closing(1, tick.round);
  foreign.run = 43;
  stage.say(foreign);
  Beacon impostor = closing(1, tick.round);
  impostor.nonce = 555;
  stage.say(impostor);
  Representative old = test::representative(1, tick.round);
  old.incarnation = 7;
  stage.say(old);
  stage.at(0.0);
  const FaultCounts& counts = stage.session.refused_samples();
  EXPECT_EQ(counts.of(WireFaultReason::WrongRun), 1U);
  EXPECT_EQ(counts.of(WireFaultReason::WrongIncarnation), 2U);
  EXPECT_TRUE(stage.port.sent.empty());
  EXPECT_EQ(stage.round(tick, AgentMode::Planning).round, 2U);
}

TEST(SessionRun, AFaultHoldsTheTickUntilTheProcessHasEnded) {
  SessionOptions options;
  options.faults = {{FaultKind::Kill, 2, Phase::Planning, 3}};
  test::FakeControl control;
  Stage stage(2, options, &control);
  const Tick tick = stage.round(stage.start(), AgentMode::Planning);
  EXPECT_TRUE(control.killed.empty());
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(1.0);
  stage.at(2.0);
  EXPECT_EQ(control.killed, (std::vector<AgentId>{2}));
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.session.process_ended(2, 2.5);
  stage.at(2.5);
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.round, 3U);
  EXPECT_EQ(next.roster.size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0], (RosterChange{0, 3, 2, 1, LossReason::ProcessEnded}));
}

TEST(SessionRun, AFaultWithoutEffectEndsTheRun) {
  SessionOptions options;
  options.faults = {{FaultKind::Kill, 1, Phase::Flying, 1}};
  test::FakeControl control;
  Stage stage(1, options, &control);
  const Tick tick = stage.start();
  stage.say(closing(1, tick.round, AgentMode::Ready));
  stage.at(1.0);
  stage.until(11.1);
  EXPECT_EQ(stage.session.outcome().reason, "the fault on agent 1 took no effect within 10 s");
}

TEST(SessionRun, ReplaysTheLossesOfAnotherRun) {
  SessionOptions options;
  options.replay = {{0, 3, 1, 1, LossReason::Deadline}};
  Stage stage(2, options);
  Tick tick = stage.round(stage.start(), AgentMode::Planning);
  EXPECT_EQ(tick.roster.size(), 2U);
  tick = stage.round(tick, AgentMode::Planning);
  ASSERT_EQ(tick.roster.size(), 1U);
  EXPECT_EQ(tick.roster[0].agent, 2U);
  EXPECT_EQ(stage.session.run().changes()[0], options.replay[0]);
}

TEST(SessionRun, InterruptSendsAFinishedTick) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.session.interrupt("ended by signal 15", 143, 0.2);
  const Tick last = stage.last_tick();
  EXPECT_EQ(last.phase, Phase::Finished);
  EXPECT_EQ(last.round, tick.round + 1);
  EXPECT_EQ(last.roster.size(), 2U);
  EXPECT_EQ(last.outcome, (Outcome{143, "ended by signal 15"}));
  EXPECT_EQ(stage.session.outcome(), (Outcome{143, "ended by signal 15"}));
  stage.session.interrupt("again", 1, 0.3);
  EXPECT_EQ(stage.session.outcome(), (Outcome{143, "ended by signal 15"}));
  EXPECT_TRUE(stage.port.sent.empty());
}

TEST(SessionRun, HasNothingToDoWhileItWaits) {
  SessionOptions options;
  options.faults = {{FaultKind::Kill, 1, Phase::Planning, 2}};
  test::FakeControl control;
  Stage stage(1, options, &control);
  const Tick tick = stage.start();
  EXPECT_NEAR(stage.session.idle_s(0.7), 0.3, 1e-9);
  stage.say(closing(1, tick.round));
  stage.at(0.7);
  stage.at(3.0);
  EXPECT_GT(stage.session.idle_s(3.0), 0.1);  // the tick is held: nothing is sent again
  stage.session.process_ended(1, 3.0);
  stage.at(3.0);
  stage.session.give_up();
  EXPECT_EQ(stage.session.state(), State::Done);
}

TEST(SessionRun, HasNothingToDoWhileItCloses) {
  Stage stage(1);
  (void)stage.start();
  stage.session.interrupt("ended by signal 2", 130, 0.0);
  stage.at(1.5);
  EXPECT_GT(stage.session.idle_s(1.5), 0.1);
}

}  // namespace
}  // namespace skein
