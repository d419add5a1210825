// When maps are due to be equal, and which then are not: three UAVs at rest, made by hand.
#include "simworld/lockstep/map_watch.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/transits.hpp"

namespace skein {
namespace {

/// Radio 25 m; UAVs 20 m apart on a line.
Mission three(RadioOptions radio = {.range_m = 25.0}) {
  Mission mission = test::transit_of(
      {test::crosser(1, Vec3(6, 18, 6)), test::crosser(2, Vec3(26, 18, 6)), test::crosser(3, Vec3(46, 18, 6))},
      {Vec3(74, 18, 6), Vec3(74, 26, 6), Vec3(74, 34, 6)});
  mission.transit->radio = radio;
  return mission;
}

std::vector<MapHolder> at_rest(std::vector<std::uint64_t> hashes) {
  std::vector<MapHolder> holders;
  for (const VehicleSpec& vehicle : three().vehicles) {
    holders.push_back({vehicle.id, 1, vehicle.start.position_m, hashes[vehicle.id - 1]});
  }
  return holders;
}

void rest(MapWatch& watch, std::uint32_t from, std::uint32_t to, const std::vector<MapHolder>& holders) {
  for (std::uint32_t step = from; step <= to; ++step) watch.add(step, holders);
}

TEST(MapWatch, MapsAreDueWhenTheirGroupHadTheTime) {
  MapWatch watch(three());
  const std::uint32_t settling = watch.settling_steps().value();
  rest(watch, 1, settling, at_rest({1, 2, 3}));
  EXPECT_EQ(watch.due(), 0U);
  watch.add(settling + 1, at_rest({1, 2, 3}));
  EXPECT_EQ(watch.due(), 3U);
  EXPECT_EQ(watch.differing(), 3U);
  watch.add(settling + 2, at_rest({7, 7, 7}));
  EXPECT_EQ(watch.due(), 3U);
  EXPECT_EQ(watch.differing(), 0U);
}

TEST(MapWatch, WhoMovesComesBackOrIsLostBeginsTheTimeAnew) {
  const std::uint32_t settling = MapWatch(three()).settling_steps().value();
  const auto after = [&](const auto& change) {
    MapWatch watch(three());
    rest(watch, 1, settling, at_rest({1, 2, 3}));
    std::vector<MapHolder> changed = at_rest({1, 2, 3});
    change(changed);
    rest(watch, settling + 1, 2 * settling, changed);
    EXPECT_EQ(watch.due(), 0U);
    watch.add(2 * settling + 1, changed);
    return watch.differing();
  };
  EXPECT_EQ(after([](auto& holders) { holders[1].position_m.y() += 1e-3; }), 3U);
  EXPECT_EQ(after([](auto& holders) { holders[1].incarnation = 2; }), 3U);
  EXPECT_EQ(after([](auto& holders) { holders.erase(holders.begin()); }), 2U);
}

TEST(MapWatch, AGroupOwesNothingToAnother) {
  MapWatch watch(three());
  std::vector<MapHolder> apart = at_rest({1, 1, 3});
  apart[2].position_m.x() += 10.0;
  rest(watch, 1, 1 + watch.settling_steps().value(), apart);
  EXPECT_EQ(watch.due(), 2U) << "alone one is no group";
  EXPECT_EQ(watch.differing(), 0U);
  apart[0].map_hash = 9;
  watch.add(2 + watch.settling_steps().value(), apart);
  EXPECT_EQ(watch.differing(), 2U);
}

TEST(MapWatch, TheTimeIsWhatTheRadioNeeds) {
  const std::uint32_t ideal = settling_steps(three()).value();
  EXPECT_GT(settling_steps(three({.range_m = 25.0, .loss = 0.1})).value(), ideal);
  EXPECT_GT(settling_steps(three({.range_m = 25.0, .latency_rounds = 3.0})).value(), ideal);
  EXPECT_GT(settling_steps(three({.range_m = 25.0, .bit_rate_bps = 8e3})).value(), ideal);
  EXPECT_EQ(settling_steps(three({.range_m = 25.0, .bit_rate_bps = 4e3})), std::nullopt) << "no room for a tile";
  EXPECT_EQ(settling_steps(three({.loss = 1.0})), std::nullopt);
  Mission mission = three();
  mission.transit->planner.share_maps = 0.0;
  EXPECT_EQ(settling_steps(mission), std::nullopt);
  mission = three();
  mission.transit->sensor.miss = 0.1;
  EXPECT_EQ(settling_steps(mission), std::nullopt) << "who looks again sees something else";
  EXPECT_EQ(settling_steps(Mission{}), std::nullopt);
}

}  // namespace
}  // namespace skein
