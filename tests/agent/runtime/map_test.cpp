// Obstacle maps in the agent's session: awaited, named, repeated, refused, and in the state hash. Agent 1 of the
// transit tests/data/small-transit.yaml, whose peer is 12 m away.
#include <gtest/gtest.h>

#include <limits>

#include "tests/agent/runtime/played_world.hpp"

namespace skein {
namespace {

using test::PlayedWorld;

/// The tick of flight step `round` - 1. @param counts the obstacle map of agent 2 of the round before
Tick flight(std::uint32_t round, bool counts = false) {
  Tick tick = PlayedWorld::tick(round, Phase::Flying);
  tick.step = round - 1;
  tick.roster[1].obstacle_map = counts;
  return tick;
}

Sense sense_of(std::uint32_t round) {
  Sense sense;
  sense.run = test::kRun;
  sense.agent = 1;
  sense.incarnation = 1;
  sense.round = round;
  sense.pose.position_m = Vec3(5, 5, 6);
  sense.heard = {{2, Vec3(5, 17, 6), Vec3::Zero(), false}};
  return sense;
}

/// What agent 2 might tell in a round: that a cell of a tile is occupied.
ObstacleMapSample told(std::uint32_t round, std::uint32_t tile = 0) {
  ObstacleMapSample sample;
  sample.run = test::kRun;
  sample.agent = 2;
  sample.incarnation = 1;
  sample.round = round;
  sample.intent.decision = 2;
  sample.intent.to_m = Vec3(5, 17, 6);
  sample.intent.on_behalf_of = 2;
  sample.tiles = {{2, tile, 0, 1, {3, 0}}};
  return sample;
}

/// Admitted, Ready, and in its first flight step, which is round 2.
struct Aloft : PlayedWorld {
  Aloft() : PlayedWorld(1, test::small_mission("small-transit")) {
    start();
    say(sense_of(2));
    say(flight(2));
    at(0.1);
  }
  /// Opens round 3, whose tick counts the peer's map of round 2, if asked.
  void open_next(bool counts = true) {
    (void)take_beacons();
    say(sense_of(3));
    say(flight(3, counts));
  }
};

TEST(AgentMaps, ItsOwnGoesOutBeforeTheBeaconThatCountsIt) {
  Aloft world;
  ASSERT_EQ(world.port.sent.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<wire::ObstacleMap>(world.port.sent[0]));
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_TRUE(beacons[0].closes_round);
  EXPECT_TRUE(beacons[0].obstacle_map);
  EXPECT_FALSE(beacons[0].representative);
  EXPECT_EQ(beacons[0].mode, AgentMode::Flying);
  ASSERT_EQ(world.maps.size(), 1U);
  EXPECT_EQ(world.maps[0].run, test::kRun);
  EXPECT_EQ(world.maps[0].agent, 1U);
  EXPECT_EQ(world.maps[0].incarnation, 1U);
  EXPECT_EQ(world.maps[0].round, 2U);
  EXPECT_EQ(world.maps[0].intent.decision, 2U);
}

TEST(AgentMaps, ThePlanningRoundHasNone) {
  PlayedWorld world(1, test::small_mission("small-transit"));
  world.say_mission();
  world.say(PlayedWorld::tick(1, Phase::Planning));
  world.at(0.0);
  const auto beacons = world.take_beacons();
  ASSERT_EQ(beacons.size(), 1U);
  EXPECT_EQ(beacons[0].mode, AgentMode::Ready);
  EXPECT_FALSE(beacons[0].obstacle_map);
  EXPECT_TRUE(world.maps.empty());
}

TEST(AgentMaps, AreAwaitedIfTheTickCountsThem) {
  Aloft world;
  world.open_next();
  world.at(0.2);
  EXPECT_TRUE(world.port.sent.empty());
  world.say(told(2));
  world.at(0.3);
  EXPECT_EQ(world.session.round(), 3U);
  EXPECT_EQ(world.take_beacons().size(), 1U);
}

TEST(AgentMaps, AreNotAwaitedIfItDoesNot) {
  Aloft world;
  world.open_next(false);
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 3U);
}

TEST(AgentMaps, MayComeBeforeTheirTick) {
  Aloft world;
  world.say(told(2));
  world.at(0.2);
  world.open_next();
  world.at(0.3);
  EXPECT_EQ(world.session.round(), 3U);
}

TEST(AgentMaps, AreNamedEverySecondWhileTheyAreLacking) {
  Aloft world;
  world.open_next();
  world.at(5.0);
  EXPECT_TRUE(world.port.sent.empty());
  for (const double now_s : {6.0, 7.0}) {
    world.at(now_s - 0.1);
    EXPECT_TRUE(world.port.sent.empty());
    world.at(now_s);
    const auto beacons = world.take_beacons();
    ASSERT_EQ(beacons.size(), 1U);
    EXPECT_FALSE(beacons[0].closes_round);
    EXPECT_EQ(beacons[0].needs, (std::vector<Need>{{2, 2, NeedTopic::ObstacleMap}}));
    EXPECT_TRUE(world.maps.empty());
  }
}

TEST(AgentMaps, ARepeatedTickIsAnsweredWithTheSameOne) {
  Aloft world;
  const auto beacons = world.take_beacons();
  const auto maps = world.maps;
  ASSERT_EQ(maps.size(), 1U);
  world.say(flight(2));
  world.at(0.2);
  EXPECT_EQ(world.take_beacons(), beacons);
  EXPECT_EQ(world.maps, maps);
}

TEST(AgentMaps, WrongOnesAreRefusedAndStandInNobodysWay) {
  Aloft world;
  world.open_next();
  const auto say_changed = [&](const auto& change) {
    ObstacleMapSample sample = told(2);
    change(sample);
    world.say(sample);
  };
  say_changed([](ObstacleMapSample& m) { m.run = 41; });
  say_changed([](ObstacleMapSample& m) { m.agent = 3; });
  say_changed([](ObstacleMapSample& m) { m.incarnation = 2; });
  say_changed([](ObstacleMapSample& m) { m.round = 5; });
  say_changed([](ObstacleMapSample& m) { m.tiles[0].tile = 6; });  // of the 3 x 2 tiles of the area
  say_changed([](ObstacleMapSample& m) { m.intent.next_cells[0] = 200; });
  say_changed([](ObstacleMapSample& m) { m.intent.to_m.x() = std::numeric_limits<double>::infinity(); });
  world.at(0.2);
  EXPECT_EQ(world.session.round(), 2U);
  const FaultCounts& refused = world.session.refused_samples();
  EXPECT_EQ(refused.of(WireFaultReason::WrongRun), 1U);
  EXPECT_EQ(refused.of(WireFaultReason::UnknownAgent), 1U);
  EXPECT_EQ(refused.of(WireFaultReason::WrongIncarnation), 1U);
  EXPECT_EQ(refused.of(WireFaultReason::OutOfRange), 3U);
  EXPECT_EQ(refused.of(WireFaultReason::NonFinite), 1U);
  world.say(told(2));
  world.at(0.3);
  EXPECT_EQ(world.session.round(), 3U);
}

TEST(AgentMaps, CopiesChangeNothing) {
  std::vector<std::vector<Beacon>> answers;
  for (const bool copied : {false, true}) {
    Aloft world;
    world.open_next();
    world.say(told(2));
    if (copied) world.say(told(2, 1));
    world.at(0.3);
    answers.push_back(world.take_beacons());
    EXPECT_EQ(answers.back().size(), 1U);
  }
  EXPECT_EQ(answers[0], answers[1]);
}

TEST(AgentMaps, WhatWasHeardIsInTheStateHash) {
  std::vector<std::uint64_t> hashes;
  for (const std::uint32_t tile : {0U, 0U, 1U}) {
    Aloft world;
    world.open_next();
    world.say(told(2, tile));
    world.at(0.3);
    world.say(sense_of(4));
    world.say(flight(4));
    world.at(0.4);
    hashes.push_back(world.take_beacons().back().state_hash);
    EXPECT_EQ(world.session.round(), 4U);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0], hashes[2]);
}

}  // namespace
}  // namespace skein
