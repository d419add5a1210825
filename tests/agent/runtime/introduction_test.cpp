// The agent's session until it takes part: introductions, admission, refusals.
#include <gtest/gtest.h>

#include "tests/agent/runtime/played_world.hpp"

namespace skein {
namespace {

using State = AgentSession::State;
using test::PlayedWorld;

TEST(Introduction, IsRepeatedEveryQuarterSecond) {
  PlayedWorld world;
  std::size_t count = 0;
  for (int hundredth = 0; hundredth <= 100; ++hundredth) {
    world.at(0.01 * hundredth);
    count += world.take_beacons().size();
  }
  EXPECT_GE(count, 4U);
  EXPECT_LE(count, 5U);
  EXPECT_EQ(world.session.state(), State::Introducing);
}

TEST(Introduction, SaysWhoItIsAndWhoItSees) {
  PlayedWorld world;
  world.port.sees = {7, 102};
  world.at(0.0);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].agent, 1U);
  EXPECT_EQ(beacons[0].incarnation, 0U);
  EXPECT_EQ(beacons[0].nonce, test::kNonce);
  EXPECT_EQ(beacons[0].run, 0U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Waiting);
  EXPECT_EQ(beacons[0].matched, (std::vector<std::uint64_t>{7, 102}));
  EXPECT_FALSE(beacons[0].closes_round);
}

TEST(Introduction, IsRepeatedAtOnceWhenMoreIsKnown) {
  PlayedWorld world;
  world.at(0.0);
  world.at(0.01);
  EXPECT_EQ(world.take_beacons().size(), 1U);
  world.port.sees = {7};
  world.at(0.02);
  EXPECT_EQ(world.take_beacons().size(), 1U);
  world.say_mission();
  world.at(0.03);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].run, test::kRun);
}

TEST(Introduction, EndsWhenTheRosterNamesTheNonce) {
  PlayedWorld world;
  world.say_mission();
  world.say(PlayedWorld::tick(0, Phase::Waiting));
  world.at(0.0);
  EXPECT_EQ(world.session.state(), State::Introducing);
  EXPECT_EQ(world.session.heard_world_s(), 0.0);
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.7);
  EXPECT_EQ(world.session.state(), State::Live);
  EXPECT_EQ(world.session.heard_world_s(), 0.7);
}

TEST(Introduction, ATickBeforeTheMissionIsAnsweredOnceTheMissionIsHere) {
  PlayedWorld world;
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.0);
  EXPECT_EQ(world.session.state(), State::Introducing);
  world.say_mission();
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::Live);
  EXPECT_EQ(world.session.round(), 1U);
}

TEST(Introduction, ATickOfAnotherRunBeforeTheMissionIsForgotten) {
  PlayedWorld world;
  Tick foreign = PlayedWorld::tick(90, Phase::Planning);
  foreign.run = 41;
  world.say(foreign);
  world.at(0.0);
  world.say_mission();
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::Live);
  EXPECT_EQ(world.session.round(), 1U);
}

TEST(Introduction, RefusedAgentsAreTurnedAway) {
  PlayedWorld world;
  world.say_mission();
  Tick tick = PlayedWorld::tick(0, Phase::Waiting);
  tick.refused = {{555, RefusalReason::IdInUse}};
  world.say(tick);
  world.at(0.0);
  EXPECT_EQ(world.session.state(), State::Introducing);  // somebody else was meant
  tick.refused = {{test::kNonce, RefusalReason::IdInUse}};
  world.say(tick);
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::TurnedAway);
  EXPECT_EQ(world.session.reason(), "the world refused agent 1: id_in_use");
}

TEST(Introduction, AVehicleThatTheMissionLacksIsTurnedAway) {
  PlayedWorld world(9);
  world.say_mission();
  world.at(0.0);
  EXPECT_EQ(world.session.state(), State::TurnedAway);
  EXPECT_EQ(world.session.reason(), "the mission has no vehicle 9");
}

TEST(Introduction, AWorldThatEndsBeforeTheStartTurnsItAway) {
  PlayedWorld world;
  world.say_mission();
  Tick last = PlayedWorld::tick(1, Phase::Finished);
  last.roster.clear();
  world.say(last);
  world.at(0.0);
  EXPECT_EQ(world.session.state(), State::TurnedAway);
  EXPECT_EQ(world.session.reason(), "the world ended before agent 1 took part");
}

}  // namespace
}  // namespace skein
