// A world that goes on with a recorded run: cut wherever the one before died, it comes to the same ticks and hash.
#include <gtest/gtest.h>

#include "tests/simworld/checkpoint/recorded_run.hpp"

namespace skein {
namespace {

using test::answer;
using test::Kept;
using test::play;
using test::Stage;
using State = WorldSession::State;

struct Recorded {
  Kept kept;
  std::vector<Tick> ticks;
  std::uint64_t hash = 0;
  std::vector<RosterChange> changes;
};

void record(Recorded& run) {
  SessionOptions options;
  options.recorder = &run.kept;
  Stage stage(2, options);
  run.ticks.push_back(stage.start());
  play(stage, run.ticks.front(), run.ticks);
  run.hash = stage.session.run().state_hash();
  run.changes = stage.session.run().changes();
}

/// A stage whose world goes on after the first `rounds` records, matched with all that are live.
void restore(Stage& stage, const Recorded& run, std::size_t rounds) {
  for (std::size_t i = 0; i < rounds; ++i) stage.session.replay(run.kept.inputs(i));
  stage.session.resume(1, stage.now_s);
  stage.port.sees = {test::nonce_of(1), test::nonce_of(2), test::kNewNonce};
}

TEST(Resume, CutAtEveryRecordTheRunComesToTheSameTicksAndTheSameHash) {
  Recorded run;
  record(run);
  ASSERT_EQ(run.kept.rounds.size(), run.ticks.size());
  ASSERT_EQ(run.changes.size(), 2U) << "agent 2 is lost and comes back";
  for (std::size_t cut = 1; cut <= run.ticks.size(); ++cut) {
    Stage stage(2);
    restore(stage, run, cut);
    stage.at(0.0);
    std::vector<Tick> ticks{stage.last_tick()};
    ASSERT_EQ(ticks[0], run.ticks[cut - 1]) << cut;
    play(stage, ticks[0], ticks);
    EXPECT_EQ(ticks, std::vector<Tick>(run.ticks.begin() + static_cast<std::ptrdiff_t>(cut) - 1, run.ticks.end()));
    EXPECT_EQ(stage.session.run().state_hash(), run.hash) << cut;
    EXPECT_EQ(stage.session.run().changes(), run.changes) << cut;
    EXPECT_EQ(stage.session.state(), State::Done) << cut;
    EXPECT_EQ(stage.session.world_restarts(), 1U);
  }
}

TEST(Resume, TheOpenTickIsRepeatedUntilAllLiveAgentsAreMatchedAndTheDeadlineBeginsThen) {
  Recorded run;
  record(run);
  Stage stage(2);
  restore(stage, run, 1);
  stage.port.sees = {test::nonce_of(1)};
  stage.until(20.0);  // twice the deadline
  const std::vector<Tick> repeated = stage.take_ticks();
  EXPECT_GE(repeated.size(), 20U);
  for (const Tick& tick : repeated) EXPECT_EQ(tick, run.ticks[0]);
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.port.sees.push_back(test::nonce_of(2));
  stage.until(20.5);
  stage.say(test::closing(1, 1));
  stage.until(30.0);
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.until(31.5);
  ASSERT_EQ(stage.session.run().changes().size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0].reason, LossReason::Deadline);
}

TEST(Resume, AnAgentThatIsNeverMatchedAgainIsLostInTheEnd) {
  Recorded run;
  record(run);
  SessionOptions options;
  options.startup_timeout_s = 5.0;
  Stage stage(2, options);
  restore(stage, run, 1);
  stage.port.sees = {test::nonce_of(1)};
  stage.say(test::closing(1, 1));
  stage.until(14.5);
  EXPECT_TRUE(stage.session.run().changes().empty());
  stage.until(16.0);
  ASSERT_EQ(stage.session.run().changes().size(), 1U);
}

TEST(Resume, AnAgentThatEndedMeanwhileIsNotWaitedFor) {
  Recorded run;
  record(run);
  Stage stage(2);
  restore(stage, run, 1);
  stage.port.sees = {test::nonce_of(1)};
  stage.session.process_ended(2, 0.0);
  stage.say(test::closing(1, 1));
  stage.at(0.0);
  stage.at(0.1);
  ASSERT_EQ(stage.session.run().changes().size(), 1U);
  EXPECT_EQ(stage.session.run().changes()[0], (RosterChange{0, 2, 2, 1, LossReason::ProcessEnded}));
}

TEST(Resume, AnswersToTheRepeatedTickCountAndSoDoesASignal) {
  Recorded run;
  record(run);
  Stage stage(2);
  restore(stage, run, 1);
  stage.port.sees.clear();
  stage.at(0.0);
  answer(stage, run.ticks[0]);
  stage.at(0.5);
  EXPECT_EQ(stage.last_tick(), run.ticks[0]) << "nobody is matched yet";
  stage.session.interrupt("ended by SIGTERM", 143, 0.6);
  stage.at(0.6);
  EXPECT_EQ(stage.last_tick().phase, Phase::Finished);
  stage.until(3.0);
  EXPECT_EQ(stage.session.state(), State::Done);
  EXPECT_EQ(stage.session.outcome().exit_code, 143);
}

TEST(Resume, ARunThatHadNotStartedWaitsForItsAgents) {
  Stage stage(2);
  stage.session.resume(3, 0.0);
  EXPECT_EQ(stage.session.state(), State::Waiting);
  EXPECT_EQ(stage.start().round, 1U);
  EXPECT_EQ(stage.session.world_restarts(), 3U);
}

TEST(Resume, FiguresGoOnWithoutTheTimeInWhichNoWorldRan) {
  Recorded run;
  record(run);
  RoundInputs last = run.kept.inputs(0);
  last.figures = {};
  last.figures.now_s = 50.0;
  last.figures.times = {40.0, 45.0, -1.0, -1.0};
  last.figures.topics.beacon = {30, 900};
  last.figures.late_steps = 4;
  Stage stage(2);
  stage.session.replay(last);
  stage.session.resume(1, 200.0);
  EXPECT_EQ(stage.session.times().created_s, 190.0);
  EXPECT_EQ(stage.session.times().started_s, 195.0);
  EXPECT_EQ(stage.session.times().flying_s, -1.0);
  EXPECT_EQ(stage.session.topics().beacon.samples, 30U);
  EXPECT_EQ(stage.session.late_steps(), 4U);
}

TEST(Resume, ARecordOfAnotherRoundOrAnotherRunIsRefused) {
  Recorded run;
  record(run);
  Stage stage(2);
  EXPECT_THROW(stage.session.replay(run.kept.inputs(1)), std::invalid_argument);
  stage.session.replay(run.kept.inputs(0));
  EXPECT_THROW(stage.session.replay(run.kept.inputs(0)), std::invalid_argument);
  RoundInputs strange = run.kept.inputs(1);
  ++strange.world_hash;
  EXPECT_THROW(stage.session.replay(strange), std::invalid_argument);
  RoundInputs poor = run.kept.inputs(1);
  poor.answers.pop_back();
  EXPECT_THROW(stage.session.replay(poor), std::logic_error);
}

TEST(Resume, TheWorldsDeathComesFirstAndTheRestIsLeftToItsSuccessor) {
  Kept kept;
  test::FakeControl control;
  SessionOptions options;
  options.recorder = &kept;
  const Fault kill{FaultKind::Kill, 2, Phase::Planning, 2};
  const Fault death{FaultKind::Kill, kWorldId, Phase::Planning, 2};
  options.faults = {kill, death};
  Stage stage(2, options, &control);
  const Tick tick = stage.start();
  answer(stage, tick);
  stage.at(0.0);
  EXPECT_EQ(control.killed, std::vector<AgentId>{kWorldId});
  EXPECT_EQ(kept.faults, std::vector<Fault>{death});
  EXPECT_EQ(kept.rounds.size(), 1U) << "the round is not decided";

  options.recorder = nullptr;
  Stage successor(2, options, &control);
  successor.session.replay(kept.inputs(0));
  successor.session.replay(death);
  successor.session.resume(1, 0.0);
  successor.port.sees = {test::nonce_of(1), test::nonce_of(2)};
  successor.at(0.0);
  answer(successor, tick);
  successor.at(0.0);
  EXPECT_EQ(control.killed, (std::vector<AgentId>{kWorldId, 2}));
  successor.session.process_ended(2, 0.0);
  successor.at(0.0);
  EXPECT_EQ(successor.last_tick().roster.size(), 1U);
  EXPECT_TRUE(successor.session.unused_faults().empty());
}

}  // namespace
}  // namespace skein
