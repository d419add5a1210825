// Announced zones: the delay that the seed draws, the states by step, and the aircraft.
#include "simworld/movers/traffic.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace skein {
namespace {

Announcement announced() {
  Announcement zone;
  zone.shape = Cylinder{Vec2(0, 0), 30.0};
  zone.from_s = 100.0;
  zone.to_s = 120.0;
  zone.early_s = 10.0;
  return zone;
}

TEST(Traffic, IsEarlyOrLateWithinItsBounds) {
  Traffic traffic;
  traffic.late_s = 40.0;
  double least_s = 1e9;
  double most_s = -1e9;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Occupation occupation = occupation_of(announced(), traffic, seed, 0);
    EXPECT_DOUBLE_EQ(occupation.to_s - occupation.from_s, 20.0);
    least_s = std::min(least_s, occupation.from_s);
    most_s = std::max(most_s, occupation.from_s);
  }
  EXPECT_GE(least_s, 90.0);
  EXPECT_LT(least_s, 92.0);
  EXPECT_LE(most_s, 140.0);
  EXPECT_GT(most_s, 138.0);
  EXPECT_NE(occupation_of(announced(), traffic, 1, 0).from_s, occupation_of(announced(), traffic, 1, 1).from_s);
}

TEST(Traffic, StatesFollowEachOther) {
  const Occupation late{115.0, 135.0};
  const auto state = [&](std::uint32_t step) { return state_in(announced(), late, step, 1.0); };
  EXPECT_EQ(state(1), ZoneState::Ahead);
  EXPECT_EQ(state(90), ZoneState::Ahead) << "from 89 s to 90 s";
  EXPECT_EQ(state(91), ZoneState::Unconfirmed);
  EXPECT_EQ(state(115), ZoneState::Unconfirmed);
  EXPECT_EQ(state(116), ZoneState::Occupied);
  EXPECT_EQ(state(136), ZoneState::Occupied) << "over, but not confirmed";
  EXPECT_EQ(state(137), ZoneState::Clear);
  EXPECT_EQ(state(100'000), ZoneState::Clear);
  EXPECT_FALSE(is_closed(ZoneState::Ahead));
  EXPECT_TRUE(is_closed(ZoneState::Unconfirmed));
  EXPECT_TRUE(is_closed(ZoneState::Occupied));
  EXPECT_FALSE(is_closed(ZoneState::Clear));
}

TEST(Traffic, WhoIsEarlyOccupiesWithoutBeingUnconfirmedForLong) {
  const Occupation early{90.0, 110.0};
  EXPECT_EQ(state_in(announced(), early, 90, 1.0), ZoneState::Ahead);
  EXPECT_EQ(state_in(announced(), early, 91, 1.0), ZoneState::Occupied);
}

TEST(Traffic, AnAircraftFliesThroughDuringTheOccupation) {
  const Mover mover = mover_of({5.0, Vec3(-40, 0, 0), Vec3(40, 0, 60)}, {115.0, 135.0}, "announced.1");
  EXPECT_EQ(mover.at_s, 115.0);
  EXPECT_EQ(mover.until_s, 135.0);
  EXPECT_EQ(mover.position_m, Vec3(-40, 0, 0));
  EXPECT_TRUE(std::get<LineMotion>(mover.motion).velocity_mps.isApprox(Vec3(4, 0, 3)));
  EXPECT_FALSE(mover.sudden);
  EXPECT_DOUBLE_EQ(speed_of(mover), 5.0);
}

}  // namespace
}  // namespace skein
