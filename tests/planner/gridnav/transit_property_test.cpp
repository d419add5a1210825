// What peach3d promises: a single UAV arrives exactly if a way exists; swarms never touch, and nobody hovers for ever.
#include <gtest/gtest.h>

#include "planner/core/random/random_stream.hpp"
#include "tests/planner/gridnav/maps.hpp"

namespace skein::gridnav {
namespace {

bool has_way(const Layout& layout, std::size_t uav) {
  return shortest_m(layout, layout.starts[uav], layout.grid.cell_of(layout.goals_m[uav])) >= 0;
}

TEST(OneUav, ArrivesExactlyIfAWayExists) {
  int with = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 77);
    const double cell_m = stream.uniform(1.0, 6.0);
    Conditions conditions;
    conditions.speed_mps = stream.uniform(2.0, 12.0);
    conditions.sensor_m = std::max(1.5 * cell_m, stream.uniform(0.7, 3.0) * conditions.speed_mps);
    conditions.goal_radius_m = 0.3;
    const Layout layout = forest(seed, 20, 16, stream.uniform(0.1, 0.5), cell_m, 1);
    const Outcome outcome = fly(layout, conditions);
    const bool way = has_way(layout, 0);
    with += way ? 1 : 0;
    EXPECT_EQ(outcome.flights[0].status, way ? NavStatus::Arrived : NavStatus::Unreachable)
        << "seed " << seed << " after " << outcome.decisions;
    EXPECT_EQ(outcome.hits, 0u) << "seed " << seed;
    EXPECT_LT(outcome.decisions, 1000u) << "seed " << seed;
  }
  EXPECT_GT(with, 100);
  EXPECT_LT(with, 300);
}

TEST(OneUav, ArrivesExactlyIfAWayExistsInSpace) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 78);
    const CellGrid grid{Vec3(5, -3, 4), stream.uniform(2.0, 5.0), stream.uniform(2.0, 5.0), 9, 8, 4};
    Conditions conditions;
    conditions.sensor_m = 15.0;
    conditions.goal_radius_m = 0.3;
    const Layout layout = forest_in_space(seed, grid, stream.uniform(0.2, 0.6), 1);
    const Outcome outcome = fly(layout, conditions);
    EXPECT_EQ(outcome.flights[0].status, has_way(layout, 0) ? NavStatus::Arrived : NavStatus::Unreachable)
        << "seed " << seed << " after " << outcome.decisions;
    EXPECT_EQ(outcome.hits, 0u) << "seed " << seed;
  }
}

struct Tally {
  int arrived = 0;
  int stuck = 0;
  int with_way = 0;
  int without_way = 0;
};

/// Flies forests, and holds what must hold on all of them.
Tally fly_forests(std::uint64_t seeds, double density, const Conditions& conditions) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Layout layout = forest(1000 + seed, 24, 24, density, 4.0, 5);
    Conditions own = conditions;
    own.seed = seed;
    const Outcome outcome = fly(layout, own);
    EXPECT_GE(outcome.closest_m, 0.5) << "seed " << seed;
    EXPECT_EQ(outcome.hits, 0u) << "seed " << seed;
    EXPECT_EQ(outcome.count(NavStatus::Flying), 0) << "seed " << seed;
    for (std::size_t n = 0; n < outcome.flights.size(); ++n) {
      const NavStatus status = outcome.flights[n].status;
      const bool way = has_way(layout, n);
      ++(way ? tally.with_way : tally.without_way);
      if (status == NavStatus::Arrived) ++tally.arrived;
      if (way && status != NavStatus::Arrived) {
        ++tally.stuck;
        ADD_FAILURE() << "seed " << seed << " UAV " << n + 1 << " status " << static_cast<int>(status) << " after "
                      << outcome.decisions;
      }
      EXPECT_EQ(status == NavStatus::Unreachable, !way) << "seed " << seed << " UAV " << n + 1;
    }
  }
  return tally;
}

TEST(Forests, WhoHasAWayArrivesAndWhoHasNoneSaysSo) {
  const Tally tally = fly_forests(150, 0.35, {});
  EXPECT_EQ(tally.arrived, tally.with_way);
  EXPECT_GT(tally.without_way, 150);
}

TEST(Forests, WithoutSharedMapsToo) {
  Conditions conditions;
  conditions.share = false;
  fly_forests(60, 0.35, conditions);
}

TEST(Forests, LostIntentsCostTimeOnly) {
  Conditions conditions;
  conditions.loss = 0.3;
  const Tally tally = fly_forests(60, 0.35, conditions);
  EXPECT_EQ(tally.arrived, tally.with_way);
}

TEST(Forests, SameSeedSameHashes) {
  const Layout layout = forest(7, 24, 24, 0.3, 4.0, 5);
  EXPECT_EQ(fly(layout, {}).hash, fly(layout, {}).hash);
}

TEST(Forests, SwarmsInSpaceArriveAndNeverTouch) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Conditions conditions;
    conditions.loss = seed % 2 == 0 ? 0.0 : 0.2;
    conditions.seed = seed;
    const CellGrid grid{Vec3(0, 0, 4), 4.0, 4.0, 12, 12, 4};
    const Layout layout = forest_in_space(500 + seed, grid, 0.45, 6);
    const Outcome outcome = fly(layout, conditions);
    EXPECT_GE(outcome.closest_m, 0.5) << "seed " << seed;
    EXPECT_EQ(outcome.hits, 0u) << "seed " << seed;
    for (std::size_t n = 0; n < outcome.flights.size(); ++n)
      EXPECT_EQ(outcome.flights[n].status, has_way(layout, n) ? NavStatus::Arrived : NavStatus::Unreachable)
          << "seed " << seed << " UAV " << n + 1 << " after " << outcome.decisions;
  }
}

TEST(Crowds, NeverTouchWhateverIsLost) {
  int arrived = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Conditions conditions;
    conditions.loss = 0.3;
    conditions.seed = seed;
    conditions.most_decisions = 150;
    conditions.radius_m = 0.4 + 0.005 * static_cast<double>(seed);
    const Layout layout = forest(seed, 10, 10, 0.15, 2.0, 14);
    const Outcome outcome = fly(layout, conditions);
    EXPECT_GE(outcome.closest_m, 2 * conditions.radius_m) << "seed " << seed;
    EXPECT_EQ(outcome.hits, 0u) << "seed " << seed;
    arrived += outcome.count(NavStatus::Arrived);
  }
  EXPECT_GT(arrived, 60 * 14 / 2);
}

}  // namespace
}  // namespace skein::gridnav
