// The world's session when agents come back: who is admitted, what a fault on purpose waits for, what is replayed.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::closing;
using test::Stage;
using State = WorldSession::State;

constexpr std::uint64_t kNewNonce = 555;

/// Agent 2's introduction by a new process that is matched with the world and agent 1.
Beacon newcomer(std::uint64_t nonce = kNewNonce) {
  return test::introduction(2, {test::kWorldNonce, test::nonce_of(1)}, nonce);
}

/// A closing beacon of agent 2's second incarnation.
Beacon second_closing(std::uint32_t round) {
  Beacon beacon = closing(2, round, AgentMode::Rejoined);
  beacon.incarnation = 2;
  beacon.nonce = kNewNonce;
  return beacon;
}

/// Two agents, of which the second one has ended in round 1. @return the tick of round 2
Tick without_second(Stage& stage) {
  const Tick tick = stage.start();
  stage.session.process_ended(2, 0.0);
  stage.say(closing(1, tick.round));
  stage.at(0.0);
  return stage.last_tick();
}

Tick answered_by_first(Stage& stage, const Tick& tick) {
  stage.say(closing(1, tick.round));
  stage.at(stage.now_s);
  return stage.last_tick();
}

TEST(SessionReturn, AMatchedNewcomerComesBackWithTheNextTick) {
  Stage stage(2);
  Tick tick = without_second(stage);
  EXPECT_EQ(tick.roster.size(), 1U);
  stage.say(newcomer());
  tick = answered_by_first(stage, tick);
  EXPECT_EQ(tick.roster.size(), 1U) << "the world is not matched with it yet";
  stage.port.sees.push_back(kNewNonce);
  tick = answered_by_first(stage, tick);
  ASSERT_EQ(tick.roster.size(), 2U);
  EXPECT_EQ(tick.roster[1], (RosterEntry{2, 2, kNewNonce, false, false}));
  ASSERT_EQ(stage.session.run().changes().size(), 2U);
  EXPECT_EQ(stage.session.run().changes()[1], (RosterChange{0, tick.round, 2, 2, LossReason::Rejoined}));
  stage.say(closing(1, tick.round));
  stage.say(second_closing(tick.round));
  stage.at(0.0);
  EXPECT_EQ(stage.last_tick().round, tick.round + 1);
}

TEST(SessionReturn, SamplesOfTheOldIncarnationAreRefusedAndCounted) {
  Stage stage(2);
  Tick tick = without_second(stage);
  stage.port.sees.push_back(kNewNonce);
  stage.say(newcomer());
  tick = answered_by_first(stage, tick);
  ASSERT_EQ(tick.roster.size(), 2U);
  stage.say(closing(1, tick.round));
  stage.say(closing(2, tick.round));
  stage.say(test::representative(2, tick.round));
  stage.at(0.0);
  EXPECT_EQ(stage.session.refused_samples().of(WireFaultReason::WrongIncarnation), 2U);
  EXPECT_TRUE(stage.port.sent.empty()) << "the round still waits for the new incarnation";
}

TEST(SessionReturn, ANewcomerWithALiveIdIsRefusedWhenTheHolderAnswersALaterTick) {
  Stage stage(2);
  Tick tick = stage.start();
  Beacon intruder = newcomer();
  intruder.round = tick.round;
  stage.say(intruder);
  stage.at(0.0);
  tick = stage.round(tick, AgentMode::Planning);
  EXPECT_TRUE(tick.refused.empty());
  tick = stage.round(tick, AgentMode::Planning);
  EXPECT_EQ(tick.refused, (std::vector<Refusal>{{kNewNonce, RefusalReason::IdInUse}}));
  EXPECT_EQ(tick.roster, test::roster_of(2));
}

TEST(SessionReturn, ANewcomerWithALiveIdThatHasHeardNoTickGetsABreakToHearOne) {
  Stage stage(2);
  const Tick tick = stage.start();
  stage.say(newcomer());
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(0.0);
  EXPECT_TRUE(stage.take_ticks().empty());
  EXPECT_NEAR(stage.session.idle_s(0.04), 0.06, 1e-9);
  stage.at(0.11);
  EXPECT_EQ(stage.last_tick().round, tick.round + 1);
}

TEST(SessionReturn, ANewcomerWithASilentHoldersIdTakesItOver) {
  Stage stage(2);
  Tick tick = stage.start();
  stage.port.sees.push_back(kNewNonce);
  stage.say(closing(1, tick.round));
  for (double time_s = 0.5; time_s <= 9.5; time_s += 0.5) {
    stage.say(newcomer());
    stage.at(time_s);
  }
  EXPECT_EQ(stage.session.run().changes().size(), 0U);
  stage.at(10.0);  // the deadline
  tick = stage.last_tick();
  EXPECT_EQ(tick.roster.size(), 1U);
  stage.say(newcomer());
  tick = answered_by_first(stage, tick);
  EXPECT_EQ(tick.roster.size(), 2U);
}

TEST(SessionReturn, WhoComesBackIsSentTheSamplesThatItsFirstTickCounts) {
  Stage stage(2);
  const Tick tick = without_second(stage);
  stage.port.sees.push_back(kNewNonce);
  stage.say(newcomer());
  Beacon beacon = closing(1, tick.round);
  beacon.representative = true;
  stage.say(test::representative(1, tick.round));
  stage.say(beacon);
  stage.at(0.0);
  ASSERT_EQ(stage.port.sent.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<wire::Tick>(stage.port.sent[0]));
  const auto* repeated = std::get_if<wire::Representative>(&stage.port.sent[1]);
  ASSERT_NE(repeated, nullptr);
  EXPECT_EQ(from_wire(*repeated, {}).value(), test::representative(1, tick.round));
}

TEST(SessionReturn, AGoodbyeOfANewcomerIsNoReturn) {
  Stage stage(2);
  const Tick tick = without_second(stage);
  stage.port.sees.push_back(kNewNonce);
  stage.say(newcomer());
  Beacon goodbye = newcomer();
  goodbye.mode = AgentMode::Leaving;
  stage.say(goodbye);
  EXPECT_EQ(answered_by_first(stage, tick).roster.size(), 1U);
}

TEST(SessionReturn, AStoppedAgentIsDroppedByTheDeadlineAndContinuedComesBack) {
  SessionOptions options;
  options.faults = {{FaultKind::Stop, 2, Phase::Planning, 2}, {FaultKind::Cont, 2, Phase::Planning, 4}};
  test::FakeControl control;
  Stage stage(2, options, &control);
  Tick tick = stage.start();
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(0.0);
  EXPECT_EQ(control.stopped, (std::vector<AgentId>{2}));
  EXPECT_TRUE(stage.take_ticks().empty()) << "not yet stopped";
  stage.session.process_stopped(2);
  stage.at(0.0);
  tick = stage.last_tick();
  EXPECT_EQ(tick.roster.size(), 2U);
  stage.say(closing(1, tick.round));
  stage.until(10.0);
  tick = stage.last_tick();
  EXPECT_EQ(tick.roster.size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0], (RosterChange{0, 3, 2, 1, LossReason::Deadline}));

  stage.say(closing(1, tick.round));
  stage.at(10.0);
  EXPECT_EQ(control.continued, (std::vector<AgentId>{2}));
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.at(11.0);
  EXPECT_EQ(stage.last_tick().round, 3U) << "repeated, for the continued agent to hear";
  Beacon back = newcomer(test::nonce_of(2));
  back.round = 3;
  stage.say(back);
  stage.at(11.1);
  tick = stage.last_tick();
  ASSERT_EQ(tick.roster.size(), 2U);
  EXPECT_EQ(tick.round, 4U);
  EXPECT_EQ(tick.roster[1].incarnation, 2U);
}

TEST(SessionReturn, ARestartChangesTheIncarnationBetweenTwoTicks) {
  SessionOptions options;
  options.faults = {{FaultKind::Restart, 2, Phase::Planning, 2}};
  test::FakeControl control;
  Stage stage(2, options, &control);
  const Tick tick = stage.start();
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(0.0);
  EXPECT_EQ(control.restarted, (std::vector<AgentId>{2}));
  stage.session.process_ended(2, 0.1);
  stage.at(0.1);
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.port.sees.push_back(kNewNonce);
  stage.say(newcomer());
  stage.at(0.2);
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.round, 2U);
  EXPECT_EQ(next.roster[1], (RosterEntry{2, 2, kNewNonce, false, false}));
  ASSERT_EQ(stage.session.run().changes().size(), 2U);
  EXPECT_EQ(stage.session.run().changes()[0].reason, LossReason::ProcessEnded);
  EXPECT_EQ(stage.session.run().changes()[1].reason, LossReason::Rejoined);
}

TEST(SessionReturn, ARestartAtTheFirstRoundHoldsTheStart) {
  SessionOptions options;
  options.faults = {{FaultKind::Restart, 2, Phase::Planning, 1}};
  test::FakeControl control;
  Stage stage(2, options, &control);
  stage.port.sees = {test::nonce_of(1), test::nonce_of(2), kNewNonce};
  for (AgentId id : {1U, 2U}) stage.introduce(id);
  stage.at(0.0);
  EXPECT_EQ(control.restarted, (std::vector<AgentId>{2}));
  stage.session.process_ended(2, 0.1);
  stage.say(newcomer());
  stage.at(0.2);
  const Tick tick = stage.last_tick();
  EXPECT_EQ(tick.round, 1U);
  EXPECT_EQ(tick.roster[1].incarnation, 2U);
}

TEST(SessionReturn, ARestartWithoutEffectEndsTheRun) {
  SessionOptions options;
  options.faults = {{FaultKind::Restart, 2, Phase::Planning, 2}};
  options.startup_timeout_s = 20.0;
  test::FakeControl control;
  Stage stage(2, options, &control);
  const Tick tick = stage.start();
  for (AgentId id : {1U, 2U}) stage.say(closing(id, tick.round));
  stage.at(0.0);
  stage.session.process_ended(2, 0.1);
  stage.until(20.0);
  EXPECT_EQ(stage.session.state(), State::Running);
  stage.at(20.1);
  EXPECT_EQ(stage.session.outcome().reason, "the fault on agent 2 took no effect within 20 s");
}

TEST(SessionReturn, AReplayWaitsForTheReturnAndLetsNobodyElseIn) {
  SessionOptions options;
  options.replay = {{0, 2, 2, 1, LossReason::Deadline}, {0, 4, 2, 2, LossReason::Rejoined}};
  test::FakeControl control;
  Stage stage(2, options, &control);
  Tick tick = stage.round(stage.start(), AgentMode::Planning);
  EXPECT_EQ(tick.roster.size(), 1U);
  EXPECT_EQ(control.killed, (std::vector<AgentId>{2}));
  stage.port.sees.push_back(kNewNonce);
  stage.say(newcomer());
  tick = answered_by_first(stage, tick);
  EXPECT_EQ(tick.round, 3U);
  EXPECT_EQ(tick.roster.size(), 1U) << "too early";
  tick = answered_by_first(stage, tick);
  EXPECT_EQ(tick.round, 4U);
  EXPECT_EQ(tick.roster.size(), 2U);
  EXPECT_EQ(control.restarted, (std::vector<AgentId>{2}));
  EXPECT_TRUE(stage.session.unused_changes().empty());
}

}  // namespace
}  // namespace skein
