#include "planner/core/geometry/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

Terrain draw(RandomStream& stream) {
  Terrain t;
  for (double* k : {&t.a, &t.b, &t.c, &t.d, &t.e, &t.f, &t.g, &t.h, &t.l}) *k = stream.uniform(-1.0, 1.0);
  t.unit_m = stream.uniform(1.0, 1000.0);
  return t;
}

Vec3 place(const Terrain& t, RandomStream& stream) {
  return t.unit_m * Vec3(stream.uniform(-9.0, 9.0), stream.uniform(-9.0, 9.0), stream.uniform(-2.0, 4.0));
}

TEST(Terrain, ByHand) {
  const Terrain level;
  EXPECT_EQ(ground_m(level, Vec2(3.0, 4.0)), 0.0);
  EXPECT_EQ(tilt_of(level), 1.0);
  EXPECT_EQ(height_above_m(level, Vec3(1.0, 2.0, 5.0)), 5.0);
  // a sin(pi/2) + c sin(pi/2) + e cos(0) + g sin(0), in kilometres, at the origin.
  const Terrain t{0.1, 0.5 * math::kPi, 0.2, 0.5 * math::kPi, 0.4, 2.0, 7.0, 3.0, 4.0, 1000.0};
  EXPECT_NEAR(ground_m(t, Vec2::Zero()), 700.0, 1e-9);
  EXPECT_NEAR(highest_m(t), 7700.0, 1e-9);
  EXPECT_NEAR(slope_bound(t), std::sqrt(0.05) + 0.8 + 35.0, 1e-12);
  EXPECT_NEAR(bend_bound_per_m(t), (0.2 + 1.6 + 175.0) / 1000.0, 1e-12);
}

TEST(Terrain, SlopesAndHeightsAlongSegmentsKeepTheBounds) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 40);
    const Terrain t = draw(stream);
    const Vec3 a = place(t, stream);
    const Vec3 step(stream.uniform(-1.0, 1.0), stream.uniform(-1.0, 1.0), stream.uniform(-1.0, 1.0));
    const Vec3 b = a + t.unit_m * step;
    const double rise = std::fabs(ground_m(t, b.head<2>()) - ground_m(t, a.head<2>()));
    EXPECT_LE(ground_m(t, a.head<2>()), highest_m(t)) << "seed " << seed;
    EXPECT_LE(rise, slope_bound(t) * (b - a).head<2>().norm() + 1e-9) << "seed " << seed;
    double least = height_above_m(t, a);
    for (int i = 0; i <= 1000; ++i) least = std::min(least, height_above_m(t, a + i / 1000.0 * (b - a)));
    const double bound = least_height_above_m(t, a, b);
    EXPECT_LE(bound, least + 1e-9) << "seed " << seed;
    EXPECT_GE(bound, least - bend_bound_per_m(t) * (b - a).squaredNorm() / 8.0 - 1e-9) << "seed " << seed;
  }
}

TEST(Terrain, HeightOverTiltIsNeverMoreThanTheDistance) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomStream stream(seed, 0, Purpose::Test, 41);
    const Terrain t = draw(stream);
    const Vec3 p = place(t, stream);
    const double height = height_above_m(t, p);
    if (height <= 0.0) continue;
    double least = height;
    for (int i = -50; i <= 50; ++i) {
      for (int j = -50; j <= 50; ++j) {
        const Vec2 q = p.head<2>() + height / 50.0 * Vec2(i, j);
        least = std::min(least, (Vec3(q.x(), q.y(), ground_m(t, q)) - p).norm());
      }
    }
    EXPECT_GE(least, height / tilt_of(t) * (1.0 - 1e-12)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein
