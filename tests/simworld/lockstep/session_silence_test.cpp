// What the world's session does while a tick is unanswered: it names who is silent, and repeats the last tick as well.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::closing;
using test::Stage;
using State = WorldSession::State;

// Whose participant was made anew just then has not heard it.
TEST(SessionSilence, RepeatsTheLastTickUntilItIsAnswered) {
  Stage stage(1);
  (void)stage.start();
  stage.session.interrupt("ended by signal 2", 130, 0.0);
  const Tick last = stage.last_tick();
  stage.at(0.4);
  EXPECT_TRUE(stage.take_ticks().empty());
  stage.at(0.5);
  EXPECT_EQ(stage.last_tick(), last);
  stage.say(closing(1, last.round, AgentMode::Waiting));
  stage.at(0.6);
  EXPECT_EQ(stage.session.state(), State::Done);
}

TEST(SessionSilence, NamesWhoLeavesATickUnanswered) {
  Stage stage(2);
  const Tick first = stage.start();
  stage.say(closing(2, first.round, AgentMode::Ready));
  for (const double now_s : {0.5, 1.0, 1.5, 2.0, 2.5}) stage.at(now_s);
  EXPECT_TRUE(stage.session.silent_for(2.5, 2.5).empty());
  EXPECT_EQ(stage.session.silent_for(2.5, 2.6), std::vector<AgentId>{1});
  stage.say(closing(1, first.round, AgentMode::Ready));
  stage.at(2.6);
  EXPECT_TRUE(stage.session.silent_for(2.5, 2.6).empty());
}

TEST(SessionSilence, BlamesNobodyForTheTimeInWhichTheWorldItselfWasStopped) {
  Stage stage(1);
  (void)stage.start();
  stage.at(3.0);
  EXPECT_TRUE(stage.session.silent_for(2.5, 3.0).empty());
}

}  // namespace
}  // namespace skein
