// What a sample tells: the tiles that peers lack, from whom, in which order, within its budget.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/planner/core/obstacle_map/map_swarm.hpp"

namespace skein {
namespace {

using testing::MapSwarm;

// one row of ten tiles, 32 m each
const CellGrid kRow{Vec3::Zero(), 4.0, 4.0, 80, 8, 1};
constexpr auto kAll = [](std::size_t, std::size_t) { return true; };

CellChange obstacle_in(std::uint32_t tile) {
  return {kRow.index_of({static_cast<std::int32_t>(tile) * 8 + 3, 3, 0}), CellState::Occupied};
}

TEST(Compose, TellsATileOnceAndAgainOnlyIfItWasMissed) {
  MapSwarm swarm(kRow, 2);
  swarm.maps[0].observe(std::array{obstacle_in(4)});
  swarm.round = 1;
  EXPECT_EQ(swarm.compose(0, SIZE_MAX, kAll).tiles.size(), 1u) << "lost";
  swarm.round = 2;
  swarm.maps[0].merge(swarm.compose(1, SIZE_MAX, kAll));
  EXPECT_EQ(swarm.compose(0, SIZE_MAX, kAll).tiles.size(), 1u) << "what was said since knows nothing of it";
  swarm.round = 3;
  EXPECT_TRUE(swarm.compose(0, SIZE_MAX, kAll).tiles.empty()) << "no answer yet";
  swarm.maps[0].merge(swarm.compose(1, SIZE_MAX, kAll));
  swarm.round = 4;
  const ObstacleMapSample again = swarm.compose(0, SIZE_MAX, kAll);
  ASSERT_EQ(again.tiles.size(), 1u);
  swarm.maps[1].merge(again);
  swarm.round = 5;
  swarm.maps[0].merge(swarm.compose(1, SIZE_MAX, kAll));
  for (swarm.round = 6; swarm.round < 20; ++swarm.round) {
    EXPECT_TRUE(swarm.compose(0, SIZE_MAX, kAll).tiles.empty());
  }
}

TEST(Compose, TellsNoTilesWhenNobodyIsThere) {
  MapSwarm swarm(kRow, 2);
  swarm.maps[0].observe(std::array{obstacle_in(4)});
  swarm.round = 1;
  const ObstacleMapSample sample = swarm.compose(0, SIZE_MAX, [](std::size_t, std::size_t) { return false; });
  EXPECT_TRUE(sample.tiles.empty());
  ASSERT_EQ(sample.seen.size(), 1u);
  EXPECT_EQ(sample.seen[0].agent, 1u);
  EXPECT_EQ(sample.seen[0].version, 1u);
}

TEST(Compose, NearTheWaysOfThoseWhoLackThemComesFirst) {
  MapSwarm swarm(kRow, 2);
  for (const std::uint32_t tile : {0U, 9U, 5U, 7U}) swarm.maps[0].observe(std::array{obstacle_in(tile)});
  swarm.at_m[1] = kRow.centre_m({76, 4, 0});
  swarm.round = 1;
  const ObstacleMapSample sample = swarm.compose(0, payload_bytes(3, 2), kAll);
  ASSERT_EQ(sample.tiles.size(), 3u);
  EXPECT_EQ(sample.tiles[0].tile, 9u);
  EXPECT_EQ(sample.tiles[1].tile, 7u);
  EXPECT_EQ(sample.tiles[2].tile, 5u);
}

TEST(Compose, FarTilesAreNotStarvedByNearOnesThatChangeAllTheTime) {
  MapSwarm swarm(kRow, 2);
  swarm.at_m[1] = kRow.centre_m({76, 4, 0});
  swarm.maps[0].observe(std::array{obstacle_in(0)});
  bool told = false;
  for (swarm.round = 1; swarm.round < 60 && !told; ++swarm.round) {
    const auto n = static_cast<std::int32_t>(swarm.round);
    swarm.maps[0].observe(std::array<CellChange, 1>{{{kRow.index_of({72 + n % 8, n / 8, 0}), CellState::Free}}});
    for (const MapTile& tile : swarm.compose(0, payload_bytes(1, 1), kAll).tiles) told = told || tile.tile == 0;
    swarm.maps[0].merge(swarm.compose(1, SIZE_MAX, kAll));
  }
  EXPECT_TRUE(told);
  EXPECT_LE(swarm.round, 25u);
}

TEST(Compose, OfThoseWhoHoldATileOneSendsIt) {
  MapSwarm swarm(kRow, 5);
  // 1 tells 2, 3 and 4, and is gone; 5 comes
  swarm.maps[0].observe(std::array{obstacle_in(4)});
  const auto without_five = [](std::size_t a, std::size_t b) { return a < 4 && b < 4; };
  for (int i = 0; i < 3; ++i) swarm.exchange(SIZE_MAX, without_five);
  const std::size_t sent = swarm.sent_tiles;
  const auto without_one = [](std::size_t a, std::size_t b) { return a > 0 && b > 0; };
  swarm.exchange(SIZE_MAX, without_one);
  EXPECT_EQ(swarm.sent_tiles, sent) << "what the newcomer holds is not known yet";
  swarm.exchange(SIZE_MAX, without_one);
  EXPECT_EQ(swarm.sent_tiles, sent + 1);
  EXPECT_TRUE(swarm.all_equal());
}

TEST(Compose, WhoDoesNotReachAPeerLeavesItToTheNext) {
  MapSwarm swarm(kRow, 3);
  swarm.range_m = 100.0;
  swarm.at_m = {Vec3(0.0, 0.0, 0.0), Vec3(90.0, 0.0, 0.0), Vec3(180.0, 0.0, 0.0)};
  swarm.maps[0].observe(std::array{obstacle_in(4)});
  const auto neighbours = [](std::size_t a, std::size_t b) { return a + 1 == b || b + 1 == a; };
  for (int i = 0; i < 4; ++i) swarm.exchange(SIZE_MAX, neighbours);
  EXPECT_TRUE(swarm.all_equal());
}

TEST(Compose, HelpsAPeerThatTheOriginDoesNotReachThoughItShould) {
  MapSwarm swarm(kRow, 3);
  swarm.maps[0].observe(std::array{obstacle_in(4)});
  const auto deaf = [](std::size_t from, std::size_t to) { return !(from == 0 && to == 2); };
  int exchanges = 0;
  for (; exchanges < 20 && !swarm.all_equal(); ++exchanges) swarm.exchange(SIZE_MAX, deaf);
  EXPECT_TRUE(swarm.all_equal());
  EXPECT_LE(exchanges, 8);
}

TEST(Compose, WithoutRoomForTheControlPartThereIsNoSample) {
  MapSwarm swarm(kRow, 2);
  MapRequest request;
  request.round = 1;
  request.budget_bytes = payload_bytes(0, 0) - 1;
  EXPECT_FALSE(swarm.maps[0].compose(request).has_value());
  request.budget_bytes = payload_bytes(0, 0);
  const auto part = swarm.maps[0].compose(request);
  ASSERT_TRUE(part.has_value());
  EXPECT_TRUE(part->seen.empty());
}

TEST(Compose, AVectorThatDoesNotFitIsToldInTurn) {
  MapSwarm swarm(kRow, 10);
  for (ObstacleMap& map : swarm.maps) map.observe(std::array{obstacle_in(4), obstacle_in(1)});
  swarm.exchange_all();
  std::vector<AgentId> told;
  for (int i = 0; i < 12; ++i) {
    ++swarm.round;
    const ObstacleMapSample sample = swarm.compose(0, payload_bytes(0, 3), kAll);
    EXPECT_LE(payload_bytes(sample.tiles.size(), sample.seen.size()), payload_bytes(0, 3));
    for (const Seen& entry : sample.seen) told.push_back(entry.agent);
  }
  for (const AgentId id : swarm.ids) EXPECT_NE(std::ranges::find(told, id), told.end()) << id;
}

TEST(Compose, SixtyFourAgentsOverALargeMapKeepToTheirBudget) {
  const CellGrid grid{Vec3::Zero(), 2.0, 4.0, 125, 125, 5};
  MapSwarm swarm(grid, 64);
  for (int i = 0; i < 3; ++i) {
    for (std::size_t agent = 0; agent < 64; ++agent) {
      std::vector<CellChange> sights;
      for (std::uint32_t n = 0; n < 400; ++n) {
        const auto cell =
            static_cast<CellIndex>((agent * 1201 + n * 7 + static_cast<std::size_t>(i) * 3001) % grid.size());
        sights.push_back({cell, n % 4 == 0 ? CellState::Occupied : CellState::Free});
      }
      swarm.maps[agent].observe(sights);
    }
    swarm.exchange_all(900);
  }
  EXPECT_LE(swarm.largest_bytes, 900u);
  EXPECT_GT(swarm.sent_tiles, 64u);
}

}  // namespace
}  // namespace skein
