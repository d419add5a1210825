// The world's session of a transit: senses with peers and sight, obstacle maps counted, awaited, repeated and refused.
#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"
#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

using test::closing;
using test::map_sample;
using test::Stage;

Scenario two() {
  Scenario scenario;
  scenario.mission = test::transit_of({test::crosser(1, Vec3(6, 18, 6)), test::crosser(2, Vec3(6, 30, 6))},
                                      {Vec3(74, 18, 6), Vec3(74, 30, 6)});
  return scenario;
}

/// The tick of flight step 1.
Tick take_off(Stage& stage) {
  return stage.round(stage.start(), AgentMode::Ready);
}

Beacon with_map(AgentId id, std::uint32_t round) {
  Beacon beacon = closing(id, round, AgentMode::Flying);
  beacon.obstacle_map = true;
  return beacon;
}

std::vector<ObstacleMapSample> take_maps(Stage& stage) {
  std::vector<ObstacleMapSample> maps;
  for (const wire::ObstacleMap& sample : stage.take_sent<wire::ObstacleMap>()) {
    maps.push_back(from_wire(sample, {}).value());
  }
  return maps;
}

TEST(SessionMaps, SensesTellOfPeersAndOfCells) {
  Stage stage(two());
  const Tick planning = stage.start();
  for (const AgentId id : {1U, 2U}) stage.say(closing(id, planning.round, AgentMode::Ready));
  stage.at(0.0);
  const auto senses = stage.take_sent<wire::Sense>();
  ASSERT_EQ(senses.size(), 2U);
  const Sense first = from_wire(senses[0], {}).value();
  ASSERT_EQ(first.heard.size(), 1U);
  EXPECT_EQ(first.heard[0].agent, 2U);
  EXPECT_EQ(first.heard[0].position_m, Vec3(6, 30, 6));
  EXPECT_EQ(first.sight.at({1, 4, 0}), CellState::Free);
}

TEST(SessionMaps, AreAwaitedAndCountedInTheNextTick) {
  Stage stage(two());
  const Tick tick = take_off(stage);
  stage.say(with_map(1, tick.round));
  stage.say(closing(2, tick.round, AgentMode::Flying));
  stage.at(0.1);
  EXPECT_TRUE(stage.port.sent.empty());
  EXPECT_EQ(stage.session.topics().obstacle_map.samples, 0U);
  stage.say(map_sample(1, tick.round));
  stage.say(map_sample(1, tick.round));
  stage.at(0.2);
  const Tick next = stage.last_tick();
  EXPECT_EQ(next.round, tick.round + 1);
  EXPECT_TRUE(next.roster[0].obstacle_map);
  EXPECT_FALSE(next.roster[1].obstacle_map);
  EXPECT_EQ(stage.session.topics().obstacle_map.samples, 1U);
  const wire::ObstacleMap wire = to_wire(map_sample(1, tick.round), {});
  EXPECT_EQ(stage.session.topics().obstacle_map.bytes, wire::ObstacleMap::getCdrSerializedSize(wire));
}

TEST(SessionMaps, AreSentAgainToWhoeverLacksThem) {
  Stage stage(two());
  const Tick tick = take_off(stage);
  stage.say(with_map(1, tick.round));
  stage.say(map_sample(1, tick.round, 2));
  stage.say(closing(2, tick.round, AgentMode::Flying));
  stage.at(0.1);
  const Tick next = stage.last_tick();
  const auto ask = [&](const Need& need) {
    Beacon open = closing(2, tick.round, AgentMode::Flying);
    open.closes_round = false;
    open.needs = {need};
    stage.say(open);
    stage.at(0.2);
    return take_maps(stage);
  };
  EXPECT_EQ(ask({1, tick.round, NeedTopic::ObstacleMap}),
            (std::vector<ObstacleMapSample>{map_sample(1, tick.round, 2)}));
  EXPECT_EQ(ask({1, tick.round, NeedTopic::ObstacleMap}).size(), 1U) << "as often as it is asked for";
  EXPECT_TRUE(ask({1, next.round, NeedTopic::ObstacleMap}).empty());
  EXPECT_TRUE(ask({2, tick.round, NeedTopic::ObstacleMap}).empty());
  EXPECT_TRUE(ask({1, tick.round}).empty());
  EXPECT_EQ(stage.session.topics().obstacle_map.samples, 1U) << "a repeat is none of the sender's";
}

TEST(SessionMaps, OfNoUseAreRefusedAndAwaitedStill) {
  Stage stage(two());
  const Tick tick = take_off(stage);
  ObstacleMapSample outside = map_sample(1, tick.round);
  outside.tiles[0].tile = 6;  // of the 3 x 2 tiles of the area
  ObstacleMapSample foreign = map_sample(1, tick.round);
  foreign.run = 41;
  ObstacleMapSample stranger = map_sample(3, tick.round);
  ObstacleMapSample reborn = map_sample(1, tick.round);
  reborn.incarnation = 2;
  for (const ObstacleMapSample& sample : {outside, foreign, stranger, reborn}) stage.say(sample);
  stage.say(with_map(1, tick.round));
  stage.say(closing(2, tick.round, AgentMode::Flying));
  stage.at(0.1);
  EXPECT_TRUE(stage.port.sent.empty());
  EXPECT_EQ(stage.session.refused_samples().total(), 4U);
  EXPECT_EQ(stage.session.refused_samples().of(WireFaultReason::OutOfRange), 1U);
  EXPECT_EQ(stage.session.refused_samples().of(WireFaultReason::WrongRun), 1U);
  stage.say(map_sample(1, tick.round));
  stage.at(0.2);
  EXPECT_TRUE(stage.last_tick().roster[0].obstacle_map);
}

TEST(SessionMaps, OfALostAgentDoNotCount) {
  Stage stage(two());
  const Tick tick = take_off(stage);
  stage.say(with_map(1, tick.round));
  stage.say(map_sample(1, tick.round));
  stage.at(0.1);
  stage.session.process_ended(1, 0.1);
  stage.say(closing(2, tick.round, AgentMode::Flying));
  stage.at(0.2);
  const Tick next = stage.last_tick();
  ASSERT_EQ(next.roster.size(), 1U);
  EXPECT_EQ(next.roster[0].agent, 2U);
  EXPECT_EQ(stage.session.run().radio()->sent_samples(), 0U);
}

}  // namespace
}  // namespace skein
