// The agent's session in its rounds: what it waits for, names, answers, repeats and leaves unused.
#include "agent/runtime/agent_session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/agent/runtime/played_world.hpp"

namespace skein {
namespace {

using State = AgentSession::State;
using test::PlayedWorld;

TEST(AgentSession, AnswersWithASampleAndTheBeaconThatCountsIt) {
  PlayedWorld world;
  world.say_mission();
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.0);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(world.samples.size(), 1U);
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(world.samples[0].agent, 1U);
  EXPECT_EQ(world.samples[0].incarnation, 1U);
  EXPECT_EQ(world.samples[0].round, 1U);
  EXPECT_TRUE(beacons[0].closes_round);
  EXPECT_TRUE(beacons[0].representative);
  EXPECT_EQ(beacons[0].round, 1U);
  EXPECT_EQ(beacons[0].incarnation, 1U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Planning);
  EXPECT_EQ(beacons[0].planned_length_m, world.samples[0].path_length_m);
  EXPECT_NE(beacons[0].state_hash, 0U);
}

TEST(AgentSession, WaitsForEverySampleThatTheTickCounts) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(0.1);
  EXPECT_TRUE(world.port.sent.empty());
  world.say(PlayedWorld::peer(1));
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 2U);
  EXPECT_EQ(world.take_beacons().size(), 1U);
}

TEST(AgentSession, ASampleMayComeBeforeItsTick) {
  PlayedWorld world;
  world.say_mission();
  world.say(PlayedWorld::peer(1));  // the first tick is still to come
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.say(PlayedWorld::peer(2));  // the peer is ahead by a round
  world.at(0.05);
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(0.1);
  EXPECT_EQ(world.session.round(), 2U);
  world.say(PlayedWorld::tick(3, Phase::Planning, true));
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 3U);
}

TEST(AgentSession, NamesWhatItLacksAfterASecondAndEverySecond) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(5.0);
  world.at(5.9);
  EXPECT_TRUE(world.port.sent.empty());
  world.at(6.0);
  auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_FALSE(beacons[0].closes_round);
  EXPECT_EQ(beacons[0].needs, (std::vector<Need>{{2, 1}}));
  world.at(6.9);
  EXPECT_TRUE(world.port.sent.empty());
  world.at(7.0);
  EXPECT_EQ(world.take_beacons().size(), 1U);
}

TEST(AgentSession, NamesItsOwnSenseInFlight) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Flying));
  world.at(0.0);
  world.at(1.0);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].needs, (std::vector<Need>{{1, 2}}));
}

TEST(AgentSession, ARepeatedTickIsAnsweredFromTheStore) {
  PlayedWorld world;
  world.say_mission();
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.0);
  const auto first = world.take_beacons();
  const auto samples = world.samples;
  world.at(0.5);
  EXPECT_TRUE(world.port.sent.empty());
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(1.0);
  EXPECT_EQ(world.take_beacons(), first);
  EXPECT_EQ(world.samples, samples);
  world.at(1.1);
  EXPECT_TRUE(world.port.sent.empty());
}

TEST(AgentSession, AnOldTickIsNotAnswered) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Planning));
  world.at(0.1);
  (void)world.take_beacons();
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.2);
  EXPECT_TRUE(world.port.sent.empty());
  EXPECT_EQ(world.session.round(), 2U);
}

TEST(AgentSession, IsDroppedByALastTickThatDoesNotNameIt) {
  PlayedWorld world;
  world.start();
  Tick tick = PlayedWorld::tick(2, Phase::Finished);
  tick.roster.erase(tick.roster.begin());
  world.say(tick);
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::Dropped);
  EXPECT_EQ(world.session.reason(), "the world went on without agent 1, and ended");
  EXPECT_TRUE(world.port.sent.empty());
}

TEST(AgentSession, FinishesWithALastAnswer) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Finished));
  world.at(0.1);
  EXPECT_EQ(world.session.state(), State::Finished);
  EXPECT_EQ(world.take_beacons().size(), 1U);
}

TEST(AgentSession, SaysGoodbye) {
  PlayedWorld world;
  world.start();
  world.session.leave(0.1);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Leaving);
  EXPECT_EQ(beacons[0].incarnation, 1U);
}

TEST(AgentSession, ForeignSamplesAreCountedAndUnused) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  Representative foreign = PlayedWorld::peer(1);
  foreign.run = 41;
  world.say(foreign);
  Representative unknown = PlayedWorld::peer(1);
  unknown.agent = 3;
  world.say(unknown);
  Representative nan = PlayedWorld::peer(1);
  nan.cost = std::numeric_limits<double>::quiet_NaN();
  world.say(nan);
  Tick other_run = PlayedWorld::tick(9, Phase::Finished);
  other_run.run = 41;
  world.say(other_run);
  world.at(0.1);
  EXPECT_TRUE(world.port.sent.empty());
  EXPECT_EQ(world.session.state(), State::Live);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::WrongRun), 2U);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::UnknownAgent), 1U);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::NonFinite), 1U);
  world.say(PlayedWorld::peer(1));
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 2U);
}

TEST(AgentSession, ASampleOfAnotherIncarnationDoesNotStandInTheWay) {
  PlayedWorld world;
  world.start();
  Representative old = PlayedWorld::peer(1);
  old.incarnation = 9;
  world.say(old);
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(0.1);
  EXPECT_EQ(world.session.round(), 1U);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::WrongIncarnation), 1U);
  world.say(PlayedWorld::peer(1));
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 2U);
}

TEST(AgentSession, AnUnusableSampleDoesNotStandInTheWayOfAUsableOne) {
  Representative unusable = PlayedWorld::peer(1);
  unusable.particle = {1e9, 1e9};  // far over the search range
  PlayedWorld undisturbed;
  undisturbed.start();
  undisturbed.say(PlayedWorld::peer(1));
  undisturbed.say(PlayedWorld::tick(2, Phase::Planning, true));
  undisturbed.at(0.1);
  const auto expected = undisturbed.take_beacons();
  for (const bool first : {true, false}) {
    PlayedWorld world;
    world.start();
    if (first) world.say(unusable);
    world.say(PlayedWorld::peer(1));
    if (!first) world.say(unusable);
    world.say(PlayedWorld::tick(2, Phase::Planning, true));
    world.at(0.1);
    EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::OutOfRange), 1U);
    EXPECT_EQ(world.take_beacons(), expected) << first;
  }
}

TEST(AgentSession, AnUnusableSampleAloneIsLeftOut) {
  PlayedWorld world;
  world.start();
  Representative unusable = PlayedWorld::peer(1);
  unusable.particle = {1.0};
  world.say(unusable);
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(0.1);
  EXPECT_EQ(world.session.round(), 2U);
}

TEST(AgentSession, ASampleOfAFarRoundIsRefused) {
  PlayedWorld world;
  world.start();
  world.say(PlayedWorld::peer(3));
  world.at(0.1);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::OutOfRange), 1U);
}

/// What the world would tell agent 1 in flight.
Sense sense_of(std::uint32_t round) {
  Sense sense;
  sense.run = test::kRun;
  sense.agent = 1;
  sense.incarnation = 1;
  sense.round = round;
  sense.velocity_mps = Vec3(50.0, 0.0, 0.0);
  return sense;
}

TEST(AgentSession, ASenseOfAnotherIncarnationOrAgentIsRefused) {
  PlayedWorld world;
  world.start();
  Sense old = sense_of(2);
  old.incarnation = 2;
  world.say(old);
  Sense others = sense_of(2);
  others.agent = 2;
  world.say(others);
  world.at(0.1);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::WrongIncarnation), 1U);
  EXPECT_EQ(world.session.refused_samples().of(WireFaultReason::UnknownAgent), 1U);
}

TEST(AgentSession, HasNothingToDoUntilTheNextTick) {
  PlayedWorld world;
  world.start();
  EXPECT_GT(world.session.idle_s(3.0), 0.5);  // long answered: no reason to wake
  world.say(PlayedWorld::tick(2, Phase::Planning, true));
  world.at(5.0);
  EXPECT_NEAR(world.session.idle_s(5.4), 0.6, 1e-9);  // then it names what it lacks
}

}  // namespace
}  // namespace skein
