// What the world keeps of a round, to send it again to whoever lacks it or comes back.
#include "simworld/lockstep/repeats.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

using test::map_sample;
using test::representative;

/// Of round 4 of three agents: representatives of 1 and 2, maps of 2 and 3.
Repeats kept() {
  const Tick tick = test::tick_of(4, 3);
  Barrier barrier;
  barrier.open(tick, 0.0);
  barrier.accept(representative(1, 4));
  barrier.accept(representative(2, 4));
  barrier.accept(map_sample(2, 4));
  barrier.accept(map_sample(3, 4));
  Repeats repeats;
  repeats.keep(barrier, tick);
  return repeats;
}

Repeated asked(const Repeats& repeats, std::vector<Need> needs) {
  Beacon beacon = test::closing(1, 5);
  beacon.closes_round = false;
  beacon.needs = std::move(needs);
  return repeats.asked_by(beacon);
}

TEST(Repeats, EachTopicIsAskedForByItself) {
  const Repeated maps = asked(kept(), {{2, 4, NeedTopic::ObstacleMap}});
  EXPECT_TRUE(maps.representatives.empty());
  EXPECT_EQ(maps.maps, (std::vector<ObstacleMapSample>{map_sample(2, 4)}));
  const Repeated both = asked(kept(), {{2, 4}, {2, 4, NeedTopic::ObstacleMap}, {3, 4, NeedTopic::ObstacleMap}});
  EXPECT_EQ(both.representatives, (std::vector<Representative>{representative(2, 4)}));
  EXPECT_EQ(both.maps.size(), 2U);
}

TEST(Repeats, WhatWasNotThereIsNotSent) {
  const Repeated none = asked(kept(), {{3, 4}, {1, 4, NeedTopic::ObstacleMap}, {2, 3, NeedTopic::ObstacleMap}, {9, 4}});
  EXPECT_TRUE(none.representatives.empty());
  EXPECT_TRUE(none.maps.empty());
}

TEST(Repeats, WhoComesBackGetsWhatTheTickCounts) {
  Tick tick = test::tick_of(5, 3);
  tick.roster[0].representative = true;
  tick.roster[2].obstacle_map = true;
  const Repeated counted = kept().counted_by(tick);
  EXPECT_EQ(counted.representatives, (std::vector<Representative>{representative(1, 4)}));
  EXPECT_EQ(counted.maps, (std::vector<ObstacleMapSample>{map_sample(3, 4)}));
}

TEST(Repeats, OnlyTheLastRoundIsKept) {
  Repeats repeats = kept();
  const Tick tick = test::tick_of(5, 3);
  Barrier barrier;
  barrier.open(tick, 0.0);
  barrier.accept(map_sample(1, 5));
  repeats.keep(barrier, tick);
  EXPECT_TRUE(asked(repeats, {{2, 4, NeedTopic::ObstacleMap}}).maps.empty());
  EXPECT_EQ(asked(repeats, {{1, 5, NeedTopic::ObstacleMap}}).maps.size(), 1U);
}

}  // namespace
}  // namespace skein
