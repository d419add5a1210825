// The world's session with a recorder that must have every round before the next one opens.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::closing;
using test::Stage;
using State = WorldSession::State;

SessionOptions recorded() {
  SessionOptions options;
  options.recorded = true;
  return options;
}

/// All answer the tick, which alone opens no round here.
void answer(Stage& stage, const Tick& tick, AgentMode mode) {
  for (const RosterEntry& entry : tick.roster) stage.say(closing(entry.agent, tick.round, mode));
  stage.at(stage.now_s);
}

TEST(SessionRecorded, OpensNoRoundThatTheRecorderHasNot) {
  Stage stage(2, recorded());
  const Tick first = stage.start();
  answer(stage, first, AgentMode::Ready);
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.session.recorded(first.round, {2});
  stage.at(0.1);
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.session.recorded(first.round, {});
  stage.at(0.2);
  EXPECT_EQ(stage.last_tick().round, first.round + 1);
  stage.at(0.3);  // what it has of the round before opens nothing more
  EXPECT_TRUE(stage.take_ticks().empty());
}

TEST(SessionRecorded, SendsAnUnrecordedTickAgainWithWhatTheRecorderLacks) {
  Stage stage(2, recorded());
  const Tick first = stage.start();
  answer(stage, first, AgentMode::Ready);
  stage.session.recorded(first.round, {});
  stage.at(0.0);
  const Tick tick = stage.last_tick();
  EXPECT_EQ(tick.phase, Phase::Flying);
  answer(stage, tick, AgentMode::Flying);
  stage.session.recorded(tick.round, {2});
  stage.at(0.9);
  EXPECT_TRUE(stage.port.sent.empty());
  stage.at(1.0);
  ASSERT_EQ(stage.port.sent.size(), 2U);  // the tick, and agent 2's sense
  ASSERT_TRUE(std::holds_alternative<wire::Sense>(stage.port.sent[1]));
  EXPECT_EQ(std::get<wire::Sense>(stage.port.sent[1]).agent(), 2U);
  EXPECT_EQ(stage.last_tick(), tick);
}

TEST(SessionRecorded, DoesNotWaitForThePartOfWhoIsLost) {
  Stage stage(2, recorded());
  const Tick first = stage.start();
  stage.say(closing(1, first.round, AgentMode::Ready));
  stage.session.recorded(first.round, {2});
  stage.session.process_ended(2, 0.0);
  stage.at(0.1);
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.round, first.round + 1);
  EXPECT_EQ(next.roster.size(), 1U);
}

TEST(SessionRecorded, GoesOnWithoutARecorderThatSaysNothingForTheDeadline) {
  Stage stage(2, recorded());
  const Tick first = stage.start();
  answer(stage, first, AgentMode::Ready);
  stage.until(9.9);
  EXPECT_EQ(stage.last_tick().round, first.round);
  EXPECT_FALSE(stage.session.recorder_given_up());
  stage.until(10.1);
  EXPECT_TRUE(stage.session.recorder_given_up());
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.round, first.round + 1);
  EXPECT_EQ(next.roster.size(), 2U);  // nobody was dropped
  answer(stage, next, AgentMode::Flying);
  EXPECT_EQ(stage.last_tick().round, next.round + 1);
}

TEST(SessionRecorded, WaitsForTheLastAnswersToBeRecorded) {
  Stage stage(1, recorded());
  const Tick first = stage.start();
  stage.session.interrupt("ended by signal 2", 130, 0.0);
  const Tick last = stage.last_tick();
  stage.say(closing(1, last.round, AgentMode::Ready));
  stage.at(0.1);
  EXPECT_EQ(stage.session.state(), State::Closing);
  stage.session.recorded(last.round, {});
  stage.at(0.2);
  EXPECT_EQ(stage.session.state(), State::Done);
  EXPECT_EQ(last.round, first.round + 1);
}

}  // namespace
}  // namespace skein
