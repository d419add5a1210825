// Maps under any order, loss and repetition of samples, and under budgets that do not suffice.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "planner/core/random/random_stream.hpp"
#include "tests/planner/core/obstacle_map/map_swarm.hpp"

namespace skein {
namespace {

using testing::MapSwarm;

const CellGrid kGrid{Vec3::Zero(), 4.0, 4.0, 45, 38, 2};
constexpr std::uint64_t kSeeds = 60;

RandomStream stream_of(std::uint64_t seed) {
  return {seed, 1, Purpose::Test, 0};
}

TileState random_tile(RandomStream& random) {
  TileState tile{static_cast<std::uint32_t>(random.below(3)), {}};
  for (std::uint32_t n = 0; n < 64; ++n) set_cell(tile.cells, n, static_cast<CellState>(random.below(4)));
  return tile;
}

TEST(TileProperty, TheJoinIsASemilattice) {
  RandomStream random = stream_of(1);
  for (int i = 0; i < 20000; ++i) {
    const TileState a = random_tile(random);
    const TileState b = random_tile(random);
    const TileState c = random_tile(random);
    ASSERT_EQ(join(a, b), join(b, a));
    ASSERT_EQ(join(join(a, b), c), join(a, join(b, c)));
    ASSERT_EQ(join(a, a), a);
    ASSERT_EQ(join(a, join(a, b)), join(a, b));
    if (a.epoch != b.epoch) continue;
    for (std::uint32_t n = 0; n < 64; ++n) {
      ASSERT_EQ(cell_in(join(a, b).cells, n), std::max(cell_in(a.cells, n), cell_in(b.cells, n)));
    }
  }
}

CellChange random_sight(RandomStream& random, bool heals) {
  const auto cell = static_cast<CellIndex>(random.below(kGrid.size()));
  // without healing every cell is what it is: no agent contradicts another
  if (!heals) return {cell, cell % 3 == 0 ? CellState::Occupied : CellState::Free};
  return {cell, static_cast<CellState>(1 + random.below(3))};
}

/// Samples get lost, come late, in any order and twice, for a while; then all is heard.
void disturb(MapSwarm& swarm, RandomStream& random, bool heals, std::map<CellIndex, CellState>& truth) {
  std::vector<ObstacleMapSample> in_the_air;
  const std::size_t n = swarm.ids.size();
  for (int i = 0; i < 120; ++i) {
    ++swarm.round;
    const auto who = static_cast<std::size_t>(random.below(n));
    std::vector<CellChange> sights(1 + random.below(12));
    for (CellChange& sight : sights) {
      sight = random_sight(random, heals);
      truth[sight.cell] = std::max(truth[sight.cell], sight.state);
    }
    swarm.maps[who].observe(sights);
    const std::size_t budget = random.below(2) == 0 ? SIZE_MAX : 100 + random.below(500);
    const auto from = static_cast<std::size_t>(random.below(n));
    in_the_air.push_back(swarm.compose(from, budget, [&](std::size_t, std::size_t) { return random.below(3) > 0; }));
    for (std::size_t heard = random.below(4); heard > 0; --heard) {
      swarm.maps[random.below(n)].merge(in_the_air[random.below(in_the_air.size())]);
    }
  }
}

int exchanges_until_equal(MapSwarm& swarm, std::size_t budget, int limit) {
  int exchanges = 0;
  while (!swarm.all_equal() && exchanges < limit) {
    swarm.exchange_all(budget);
    ++exchanges;
  }
  return exchanges;
}

TEST(ObstacleMapProperty, AnyOrderLossAndRepetitionEndsInTheJoinOfAllObservations) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RandomStream random = stream_of(seed);
    MapSwarm swarm(kGrid, 2 + random.below(6));
    std::map<CellIndex, CellState> truth;
    disturb(swarm, random, false, truth);
    ASSERT_LE(exchanges_until_equal(swarm, SIZE_MAX, 20), 12) << seed;
    for (CellIndex cell = 0; cell < kGrid.size(); ++cell) {
      const auto seen = truth.find(cell);
      ASSERT_EQ(swarm.maps[0].at(cell), seen == truth.end() ? CellState::Unknown : seen->second) << seed;
    }
  }
}

TEST(ObstacleMapProperty, AgentsThatContradictEachOtherEndEqualToo) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RandomStream random = stream_of(1000 + seed);
    MapSwarm swarm(kGrid, 2 + random.below(6));
    std::map<CellIndex, CellState> truth;
    disturb(swarm, random, true, truth);
    ASSERT_LE(exchanges_until_equal(swarm, SIZE_MAX, 20), 14) << seed;
    for (const auto& [cell, state] : truth) {  // what somebody knew, nobody forgets
      ASSERT_NE(swarm.maps[0].at(cell), CellState::Unknown) << seed << " " << cell;
    }
    // and it stays so: nobody has anything left to say
    for (int i = 0; i < 12; ++i) swarm.exchange_all();
    const std::size_t sent = swarm.sent_tiles;
    for (int i = 0; i < 20; ++i) swarm.exchange_all();
    EXPECT_EQ(swarm.sent_tiles, sent) << seed;
    for (const ObstacleMap& map : swarm.maps) {
      for (const AgentId id : swarm.ids) EXPECT_EQ(map.seen_of(id), swarm.maps[id - 1].seen_of(id)) << seed;
    }
  }
}

TEST(ObstacleMapProperty, AShortBudgetIsNeverExceededAndStarvesNothing) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RandomStream random = stream_of(2000 + seed);
    MapSwarm swarm(kGrid, 2 + random.below(6));
    std::map<CellIndex, CellState> truth;
    disturb(swarm, random, true, truth);
    swarm.largest_bytes = 0;
    const std::size_t budget = payload_bytes(2, 3);
    ASSERT_LT(exchanges_until_equal(swarm, budget, 1500), 1500) << seed;
    EXPECT_LE(swarm.largest_bytes, budget) << seed;
  }
}

/// Two groups that see and tell apart, one agent that leaves the air, then all the others hear each other.
/// @return exchanges after they met until their maps are equal
int exchanges_after_meeting(std::uint64_t seed, bool heals) {
  RandomStream random = stream_of(3000 + seed);
  const std::size_t n = 3 + random.below(7);
  MapSwarm swarm(kGrid, n);
  const std::size_t border = 1 + random.below(n - 1);
  const std::size_t gone = random.below(n);  // what it knew others must tell
  const auto near = [&](std::size_t a, std::size_t b) { return (a < border) == (b < border); };
  for (int i = 0; i < 40; ++i) {
    for (ObstacleMap& map : swarm.maps) {
      std::vector<CellChange> sights(random.below(6));
      for (CellChange& sight : sights) sight = random_sight(random, heals);
      map.observe(sights);
    }
    swarm.exchange(SIZE_MAX, [&](std::size_t a, std::size_t b) {
      return near(a, b) && (i < 30 || (a != gone && b != gone)) && random.below(10) > 0;
    });
  }
  const auto there = [&](std::size_t a, std::size_t b) { return a != gone && b != gone; };
  for (int i = 0; i < 8; ++i) {
    swarm.exchange(SIZE_MAX, [&](std::size_t a, std::size_t b) { return near(a, b) && there(a, b); });
  }
  const auto equal = [&] {
    const std::size_t first = gone == 0 ? 1 : 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != gone && !swarm.maps[i].same_map(swarm.maps[first])) return false;
    }
    return true;
  };
  int exchanges = 0;
  for (; exchanges < 10 && !equal(); ++exchanges) swarm.exchange(SIZE_MAX, there);
  return exchanges;
}

TEST(ObstacleMapProperty, TwoExchangesAfterTwoGroupsMetTheirMapsAreEqual) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) ASSERT_LE(exchanges_after_meeting(seed, false), 2) << seed;
}

TEST(ObstacleMapProperty, EpochsThatRacedTakeTwoExchangesMore) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) ASSERT_LE(exchanges_after_meeting(seed, true), 4) << seed;
}

TEST(ObstacleMapProperty, FalseAlarmsHealEverywhere) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    RandomStream random = stream_of(4000 + seed);
    const std::size_t n = 2 + random.below(5);
    MapSwarm swarm(kGrid, n);
    const auto truth = [](CellIndex cell) { return cell % 5 == 0 ? CellState::Occupied : CellState::Free; };
    for (int i = 0; i < 60; ++i) {
      for (ObstacleMap& map : swarm.maps) {
        const auto first = static_cast<CellIndex>(random.below(kGrid.size() - 20));
        std::vector<CellChange> sights;
        for (CellIndex cell = first; cell < first + 20; ++cell) {
          const bool alarm = i < 50 && random.below(20) == 0;
          sights.push_back({cell, alarm ? CellState::Occupied : truth(cell)});
        }
        map.observe(sights);
      }
      swarm.exchange(SIZE_MAX, [&](std::size_t, std::size_t) { return random.below(5) > 0; });
    }
    // one of them looks at everything once more
    std::vector<CellChange> sights;
    for (CellIndex cell = 0; cell < kGrid.size(); ++cell) sights.push_back({cell, truth(cell)});
    ASSERT_LE(exchanges_until_equal(swarm, SIZE_MAX, 20), 14) << seed;
    swarm.maps[seed % n].observe(sights);
    ASSERT_LE(exchanges_until_equal(swarm, SIZE_MAX, 20), 2) << seed;
    for (CellIndex cell = 0; cell < kGrid.size(); ++cell) ASSERT_EQ(swarm.maps[0].at(cell), truth(cell)) << seed;
  }
}

}  // namespace
}  // namespace skein
