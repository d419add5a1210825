#include "planner/core/obstacle_map/obstacle_map.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/planner/core/obstacle_map/map_swarm.hpp"

namespace skein {
namespace {

using enum CellState;

// 10 x 9 cells of one level: 2 x 2 tiles, of which three stick out.
const CellGrid kGrid{Vec3(5.0, -3.0, 0.0), 2.0, 4.0, 10, 9, 1};
constexpr std::array<AgentId, 3> kIds{2, 5, 9};

CellIndex cell(std::int32_t i, std::int32_t j) {
  return kGrid.index_of({i, j, 0});
}

ObstacleMap map_of(AgentId self) {
  return {kGrid, self, kIds};
}

/// All that `from` has, told to all.
ObstacleMapSample all_of(ObstacleMap& from, AgentId self, std::uint32_t round) {
  std::vector<MapPeer> peers;
  for (const AgentId id : kIds) {
    if (id != self) peers.push_back({id, Vec3::Zero(), Vec3::Zero()});
  }
  MapRequest request;
  request.round = round;
  request.peers = peers;
  const MapPart part = from.compose(request).value();
  ObstacleMapSample sample;
  sample.agent = self;
  sample.incarnation = 1;
  sample.round = round;
  sample.seen = part.seen;
  sample.tiles = part.tiles;
  return sample;
}

TEST(Tile, CellsHaveTheirPlaceAndTilesMayStickOut) {
  const TileGrid tiles(kGrid);
  EXPECT_EQ(tiles.size(), 4u);
  const TilePlace place = tiles.place_of({9, 8, 0});
  EXPECT_EQ(place.tile, 3u);
  EXPECT_EQ(place.n, 1u);
  EXPECT_EQ(tiles.cell_at(place), (Cell{9, 8, 0}));
  EXPECT_EQ(tiles.cell_at({1, 63}), (Cell{15, 7, 0}));
  EXPECT_EQ(tiles.centre_m(1), Vec3(5.0 + 12 * 2.0, -3.0 + 4 * 2.0, 2.0));
  const CellGrid levels{Vec3::Zero(), 1.0, 1.0, 9, 3, 4};
  EXPECT_EQ(TileGrid(levels).size(), 8u);
  EXPECT_EQ(TileGrid(levels).cell_at(TileGrid(levels).place_of({8, 2, 3})), (Cell{8, 2, 3}));
}

TEST(Tile, WhatTheNewerOneDoesNotKnowIsMissingInIt) {
  TileCells newer{};
  TileCells older{};
  set_cell(newer, 40, Free);
  set_cell(older, 40, Occupied);
  set_cell(older, 3, Revisited);
  const TileCells missing = missing_in(newer, older);
  EXPECT_EQ(cell_in(missing, 40), Unknown);
  EXPECT_EQ(cell_in(missing, 3), Revisited);
  EXPECT_EQ(known_cells(missing), 1);
  EXPECT_EQ(known_cells(older), 2);
}

TEST(ObstacleMap, ShowsWhatItSawAndTellsEachChangeOnce) {
  ObstacleMap map = map_of(5);
  EXPECT_EQ(map.at(cell(3, 4)), Unknown);
  map.observe(std::array<CellChange, 3>{{{cell(3, 4), Free}, {cell(9, 8), Occupied}, {cell(3, 4), Free}}});
  EXPECT_EQ(map.at(cell(3, 4)), Free);
  EXPECT_EQ(map.at(cell(9, 8)), Occupied);
  EXPECT_EQ(map.take_changes(), (std::vector<CellChange>{{cell(3, 4), Free}, {cell(9, 8), Occupied}}));
  EXPECT_TRUE(map.take_changes().empty());
  map.observe(std::array<CellChange, 1>{{{cell(3, 4), Revisited}}});
  map.unmark(std::array{cell(3, 4)});
  EXPECT_TRUE(map.take_changes().empty()) << "it is what it was";
}

TEST(ObstacleMap, SeeingAnObstacleFreeOpensAnEpochThatKeepsTheRest) {
  ObstacleMap map = map_of(5);
  map.observe(std::array<CellChange, 3>{{{cell(0, 0), Occupied}, {cell(1, 0), Occupied}, {cell(2, 0), Revisited}}});
  EXPECT_EQ(map.tile_at(0).epoch, 0u);
  map.observe(std::array<CellChange, 3>{{{cell(0, 0), Free}, {cell(2, 0), Free}, {cell(4, 4), Occupied}}});
  EXPECT_EQ(map.tile_at(0).epoch, 1u);
  EXPECT_EQ(map.at(cell(0, 0)), Free);
  EXPECT_EQ(map.at(cell(1, 0)), Occupied);
  EXPECT_EQ(map.at(cell(2, 0)), Revisited) << "a sensor does not lift the planner's mark";
  EXPECT_EQ(map.at(cell(4, 4)), Occupied);
  map.unmark(std::array{cell(2, 0), cell(1, 0)});
  EXPECT_EQ(map.tile_at(0).epoch, 2u);
  EXPECT_EQ(map.at(cell(2, 0)), Free);
  EXPECT_EQ(map.at(cell(1, 0)), Occupied) << "it bears no mark";
}

TEST(ObstacleMap, WhoKnowsMoreThanANewEpochAddsIt) {
  ObstacleMap a = map_of(2);
  ObstacleMap b = map_of(5);
  a.observe(std::array<CellChange, 1>{{{cell(0, 0), Occupied}}});
  b.observe(std::array<CellChange, 1>{{{cell(1, 1), Occupied}}});
  a.observe(std::array<CellChange, 1>{{{cell(0, 0), Free}}});
  b.merge(all_of(a, 2, 1));
  EXPECT_EQ(b.at(cell(0, 0)), Free);
  EXPECT_EQ(b.at(cell(1, 1)), Occupied);
  a.merge(all_of(b, 5, 2));
  EXPECT_EQ(a.at(cell(1, 1)), Occupied);
  EXPECT_TRUE(a.same_map(b));
  EXPECT_EQ(a.map_hash(), b.map_hash());
}

TEST(ObstacleMap, AnEntryOfTheVectorRisesOnlyWhenAllIsThere) {
  ObstacleMap a = map_of(2);
  ObstacleMap b = map_of(5);
  a.observe(std::array<CellChange, 1>{{{cell(0, 0), Occupied}}});
  a.observe(std::array<CellChange, 1>{{{cell(9, 8), Occupied}}});
  const ObstacleMapSample whole = all_of(a, 2, 1);
  ASSERT_EQ(whole.tiles.size(), 2u);
  ObstacleMapSample part = whole;
  part.tiles.erase(part.tiles.begin());
  b.merge(part);
  EXPECT_EQ(b.seen_of(2), 0u);
  b.merge(part);
  EXPECT_EQ(b.seen_of(2), 0u);
  part = whole;
  part.tiles.pop_back();
  b.merge(part);
  EXPECT_EQ(b.seen_of(2), 2u);
  EXPECT_TRUE(a.same_map(b));
}

TEST(ObstacleMap, OneThatCameBackLearnsWhatItKnewAndGoesOn) {
  ObstacleMap before = map_of(2);
  ObstacleMap b = map_of(5);
  before.observe(std::array<CellChange, 2>{{{cell(0, 0), Occupied}, {cell(9, 8), Free}}});
  b.merge(all_of(before, 2, 1));
  ObstacleMap after(kGrid, 2, kIds, 1U << 20);
  after.observe(std::array<CellChange, 1>{{{cell(0, 1), Occupied}}});
  b.begin_life(2, 1U << 20);
  for (std::uint32_t round = 2; round < 6; ++round) {
    ObstacleMapSample told = all_of(after, 2, round);
    told.incarnation = 2;
    const ObstacleMapSample heard = all_of(b, 5, round);
    b.merge(told);
    after.merge(heard);
  }
  EXPECT_EQ(b.at(cell(0, 1)), Occupied);
  for (const ObstacleMap* map : {&b, &after}) {  // of its former log
    EXPECT_EQ(map->at(cell(0, 0)), Occupied);
    EXPECT_EQ(map->at(cell(9, 8)), Free);
  }
  EXPECT_TRUE(after.same_map(b));
  EXPECT_EQ(b.seen_of(2), after.seen_of(2)) << "one log, not two";
}

TEST(ObstacleMap, LeavesOutWhatIsNotOfThisMission) {
  ObstacleMap map = map_of(5);
  const std::uint64_t empty = map.map_hash();
  ObstacleMapSample sample;
  sample.agent = 2;
  sample.round = 1;
  sample.tiles = {{3, 0, 0, 1, {1, 0}}, {2, 4, 0, 1, {1, 0}}};
  sample.seen = {{3, 7, 0}};
  map.merge(sample);
  sample.agent = 3;
  sample.tiles = {{2, 0, 0, 1, {1, 0}}};
  map.merge(sample);
  sample.agent = 5;  // itself
  map.merge(sample);
  EXPECT_EQ(map.map_hash(), empty);
  EXPECT_EQ(map.seen_of(3), 0u);
}

TEST(ObstacleMap, TheHashCoversStatesAndEpochs) {
  ObstacleMap a = map_of(2);
  ObstacleMap b = map_of(5);
  a.observe(std::array<CellChange, 1>{{{cell(0, 0), Free}}});
  b.observe(std::array<CellChange, 1>{{{cell(0, 0), Occupied}}});
  EXPECT_NE(a.map_hash(), b.map_hash());
  b.observe(std::array<CellChange, 1>{{{cell(0, 0), Free}}});
  EXPECT_NE(a.map_hash(), b.map_hash()) << "of another epoch";
  EXPECT_FALSE(a.same_map(b));
  StateHash first;
  StateHash second;
  a.add_to(first);
  b.add_to(second);
  EXPECT_NE(first.value(), second.value());
}

TEST(ObstacleMap, RefusesWhatIsNoMapOrNoCell) {
  EXPECT_THROW(ObstacleMap(kGrid, 3, kIds), std::invalid_argument);
  constexpr std::array<AgentId, 2> kTwice{2, 2};
  EXPECT_THROW(ObstacleMap(kGrid, 2, kTwice), std::invalid_argument);
  CellGrid none = kGrid;
  none.nx = 0;
  EXPECT_THROW(ObstacleMap(none, 2, kIds), std::invalid_argument);
  ObstacleMap map = map_of(5);
  EXPECT_THROW(map.observe(std::array<CellChange, 1>{{{90, Free}}}), std::invalid_argument);
  EXPECT_THROW(map.unmark(std::array<CellIndex, 1>{90}), std::invalid_argument);
}

}  // namespace
}  // namespace skein
