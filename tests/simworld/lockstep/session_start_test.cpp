// The world's session before the first round: waiting, start, refusals, time-out.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

using test::Stage;
using State = WorldSession::State;

TEST(SessionStart, PublishesTheMissionOnceAndWaitingTicksEveryHalfSecond) {
  Stage stage(2);
  ASSERT_EQ(stage.port.sent.size(), 1U);
  const auto mission = stage.take_sent<wire::Mission>();
  ASSERT_EQ(mission.size(), 1U);
  EXPECT_EQ(mission[0].head().run(), test::kRun);
  EXPECT_EQ(from_wire(mission[0], {}).value(), test::abreast(2));
  std::size_t ticks = 0;
  for (int tenth = 0; tenth <= 20; ++tenth) {
    stage.at(0.1 * tenth);
    for (const Tick& tick : stage.take_ticks()) {
      EXPECT_EQ(tick.phase, Phase::Waiting);
      EXPECT_EQ(tick.round, 0U);
      EXPECT_TRUE(tick.roster.empty());
      ++ticks;
    }
  }
  EXPECT_EQ(ticks, 5U);  // at 0, 0.5, 1, 1.5, 2 s
  EXPECT_EQ(stage.session.state(), State::Waiting);
  EXPECT_NEAR(stage.session.idle_s(2.2), 0.3, 1e-9);
}

TEST(SessionStart, OpensTheFirstRoundWhenAllAreMatched) {
  Stage stage(2);
  stage.introduce(1);
  stage.introduce(2);
  stage.at(0.0);
  EXPECT_EQ(stage.session.introduced(), 2U);
  EXPECT_EQ(stage.session.matched(), 0U);
  const Tick tick = stage.start();
  EXPECT_EQ(stage.session.matched(), 2U);
  EXPECT_EQ(tick.phase, Phase::Planning);
  EXPECT_EQ(tick.round, 1U);
  EXPECT_EQ(tick.roster, test::roster_of(2));
  EXPECT_EQ(stage.session.state(), State::Running);
  EXPECT_EQ(stage.session.times().started_s, 0.0);
}

TEST(SessionStart, TellsTurnedAwayNewcomersInTheNextTick) {
  Stage stage(2);
  stage.say(test::introduction(9, {}));
  stage.at(0.0);
  const Tick tick = stage.last_tick();
  EXPECT_EQ(tick.refused, (std::vector<Refusal>{{test::nonce_of(9), RefusalReason::UnknownId}}));
}

TEST(SessionStart, TimesOutNamingWhoIsMissing) {
  SessionOptions options;
  options.startup_timeout_s = 5.0;
  Stage stage(3, options);
  stage.port.sees = {test::nonce_of(2)};
  stage.say(test::introduction(2, {test::kWorldNonce}));
  stage.at(5.0);
  EXPECT_EQ(stage.session.state(), State::Waiting);
  stage.at(5.1);
  EXPECT_EQ(
      stage.session.start_failure(),
      "start-up timed out after 5 s: 1 of 3 agents matched; missing: 1, 3 (agent 1 was not heard, agent 3 was not "
      "heard)");
  EXPECT_EQ(stage.last_tick().phase, Phase::Finished);
  stage.at(5.2);
  EXPECT_EQ(stage.session.state(), State::Done);
}

TEST(SessionStart, PublishesTheMissionAgainEveryTwoSecondsWhileSomebodyLacksIt) {
  Stage stage(2);
  (void)stage.take_sent<wire::Mission>();
  stage.introduce(1);
  Beacon without = test::introduction(2, {test::kWorldNonce});
  without.run = 0;
  std::size_t missions = 0;
  for (int tenth = 0; tenth <= 50; ++tenth) {
    stage.say(without);
    stage.at(0.1 * tenth);
    missions += stage.take_sent<wire::Mission>().size();
  }
  EXPECT_EQ(missions, 2U);  // at 2 and 4 s
  stage.introduce(2);
  for (int tenth = 51; tenth <= 100; ++tenth) {
    stage.at(0.1 * tenth);
    EXPECT_TRUE(stage.take_sent<wire::Mission>().empty());
  }
}

TEST(SessionStart, RefusedStartEndsTheSession) {
  Stage stage(1);
  stage.session.refuse_start("another world has the swarm", 0.1);
  EXPECT_EQ(stage.session.start_failure(), "another world has the swarm");
  EXPECT_EQ(stage.session.outcome().exit_code, 3);
  EXPECT_EQ(stage.last_tick().phase, Phase::Finished);
  stage.at(0.2);
  EXPECT_EQ(stage.session.state(), State::Done);
}

TEST(SessionStart, RefusalHasNoEffectOnARun) {
  Stage stage(1);
  (void)stage.start();
  stage.session.refuse_start("too late", 0.1);
  EXPECT_EQ(stage.session.state(), State::Running);
  EXPECT_TRUE(stage.session.start_failure().empty());
}

TEST(SessionStart, AProcessThatEndsBeforeTheStartEndsIt) {
  Stage stage(2);
  stage.session.process_ended(2, 0.3);
  EXPECT_EQ(stage.session.outcome().exit_code, 4);
  EXPECT_EQ(stage.session.start_failure(), "agent 2 ended before the run started");
}

TEST(SessionStart, AGoodbyeWhileWaitingFreesTheId) {
  Stage stage(2);
  stage.introduce(1);
  stage.at(0.0);
  Beacon goodbye = test::introduction(1, {});
  goodbye.mode = AgentMode::Leaving;
  stage.say(goodbye);
  stage.at(0.1);
  EXPECT_EQ(stage.session.introduced(), 0U);
  EXPECT_EQ(stage.session.state(), State::Waiting);
}

TEST(SessionStart, FaultsNeedALauncher) {
  SessionOptions options;
  options.faults = {{FaultKind::Kill, 1, Phase::Planning, 2}};
  EXPECT_THROW(Stage(1, options), std::invalid_argument);
}

}  // namespace
}  // namespace skein
