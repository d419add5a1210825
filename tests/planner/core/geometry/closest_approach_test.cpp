#include "planner/core/geometry/closest_approach.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

TEST(ClosestApproach, HeadOnPassAtHalfTime) {
  const Approach a = closest_approach(Vec2(0.0, 0.0), Vec2(10.0, 0.0), Vec2(10.0, 3.0), Vec2(0.0, 3.0));
  EXPECT_DOUBLE_EQ(a.distance_m, 3.0);
  EXPECT_DOUBLE_EQ(a.fraction, 0.5);
}

TEST(ClosestApproach, PartingPointsAreClosestAtTheStart) {
  const Approach a =
      closest_approach(Vec3(0.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(a.distance_m, 2.0);
  EXPECT_EQ(a.fraction, 0.0);
}

TEST(ClosestApproach, SameVelocityKeepsTheDistance) {
  const Approach a = closest_approach(Vec2(0.0, 0.0), Vec2(5.0, 1.0), Vec2(3.0, 4.0), Vec2(8.0, 5.0));
  EXPECT_DOUBLE_EQ(a.distance_m, 5.0);
  EXPECT_EQ(a.fraction, 0.0);
}

TEST(ClosestApproach, NoSampleIsCloserAndOneIsAsClose) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 10);
    const auto point = [&] {
      return Vec3(stream.uniform(-9.0, 9.0), stream.uniform(-9.0, 9.0), stream.uniform(-9.0, 9.0));
    };
    const Vec3 a0 = point(), a1 = point(), b0 = point(), b1 = point();
    const Approach found = closest_approach(a0, a1, b0, b1);
    double least = 1e9;
    for (int i = 0; i <= 2000; ++i) {
      const double f = i / 2000.0;
      least = std::min(least, ((a0 + f * (a1 - a0)) - (b0 + f * (b1 - b0))).norm());
    }
    EXPECT_LE(found.distance_m, least + 1e-12) << "seed " << seed;
    EXPECT_NEAR(found.distance_m, least, 0.02) << "seed " << seed;
    const double f = found.fraction;
    EXPECT_NEAR(((a0 + f * (a1 - a0)) - (b0 + f * (b1 - b0))).norm(), found.distance_m, 1e-12);
  }
}

}  // namespace
}  // namespace skein
