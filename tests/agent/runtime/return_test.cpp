// The agent's session after a loss: it starts over, is admitted under a new incarnation, and says that it is back.
#include <gtest/gtest.h>

#include "tests/agent/runtime/played_world.hpp"

namespace skein {
namespace {

using State = AgentSession::State;
using test::PlayedWorld;

/// A tick that names agent 2 alone.
Tick without_it(std::uint32_t round, Phase phase = Phase::Planning) {
  Tick tick = PlayedWorld::tick(round, phase);
  tick.roster.erase(tick.roster.begin());
  return tick;
}

/// A tick that names agent 1 under its second incarnation.
Tick again(std::uint32_t round, Phase phase = Phase::Planning) {
  Tick tick = PlayedWorld::tick(round, phase);
  tick.roster[0].incarnation = 2;
  return tick;
}

TEST(Return, ADroppedAgentIntroducesItselfAgainWithTheTickThatItHeard) {
  PlayedWorld world;
  world.start();
  world.port.sees = {7, 102};
  world.say(without_it(4));
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::Introducing);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].incarnation, 0U);
  EXPECT_EQ(beacons[0].nonce, test::kNonce);
  EXPECT_EQ(beacons[0].run, test::kRun);
  EXPECT_EQ(beacons[0].round, 4U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Waiting);
  EXPECT_EQ(beacons[0].matched, (std::vector<std::uint64_t>{7, 102}));
  EXPECT_EQ(beacons[0].state_hash, 0U);
}

TEST(Return, ItReportsRejoinedAndPublishesNoPlan) {
  PlayedWorld world;
  world.start();
  world.say(without_it(4));
  world.at(0.1);
  (void)world.take_beacons();
  world.say(again(9));
  world.at(0.2);
  EXPECT_EQ(world.session.state(), State::Live);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_TRUE(beacons[0].closes_round);
  EXPECT_EQ(beacons[0].incarnation, 2U);
  EXPECT_EQ(beacons[0].round, 9U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Rejoined);
  EXPECT_FALSE(beacons[0].representative);
  EXPECT_TRUE(world.samples.empty());
}

TEST(Return, ANewProcessUnderASecondIncarnationDoesTheSame) {
  PlayedWorld dropped;
  dropped.start();
  dropped.say(without_it(4));
  dropped.at(0.1);
  (void)dropped.take_beacons();
  PlayedWorld fresh;
  fresh.say_mission();
  for (PlayedWorld* world : {&dropped, &fresh}) {
    world->say(again(9));
    world->at(0.2);
  }
  EXPECT_EQ(fresh.take_beacons(), dropped.take_beacons());
}

TEST(Return, InFlightItHoldsItsCourse) {
  PlayedWorld world;
  world.say_mission();
  Sense sense;
  sense.run = test::kRun;
  sense.agent = 1;
  sense.incarnation = 2;
  sense.round = 90;
  sense.velocity_mps = Vec3(30.0, 40.0, 0.0);
  world.say(sense);  // may come before its first tick
  world.say(again(90, Phase::Flying));
  world.at(0.2);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Rejoined);
  EXPECT_EQ(beacons[0].commanded_velocity_mps, sense.velocity_mps);
}

TEST(Return, ARefusalIsHeardEvenIfLaterTicksHaveCome) {
  PlayedWorld world;
  world.say_mission();
  Tick refusing = without_it(4);
  refusing.refused = {{test::kNonce, RefusalReason::IdInUse}};
  world.say(refusing);
  world.say(without_it(5));
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::TurnedAway);
}

TEST(Return, AWorldThatEndsWithoutADroppedAgentHasLostIt) {
  PlayedWorld world;
  world.start();
  world.say(without_it(4));
  world.at(0.1);
  world.say(without_it(5, Phase::Finished));
  world.at(0.2);
  EXPECT_EQ(world.session.state(), State::Dropped);
}

TEST(Return, TimeInWhichItWasStoppedIsNoSilenceOfTheWorld) {
  PlayedWorld world;
  world.start();
  world.at(0.9);
  world.at(60.0);
  EXPECT_NEAR(world.session.heard_world_s(), 59.1, 1e-9);
  world.at(61.0);
  EXPECT_NEAR(world.session.heard_world_s(), 59.1, 1e-9);
}

}  // namespace
}  // namespace skein
