#include "agent/controller/separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/core/geometry/distance.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

TEST(Separation, ByHand) {
  const Segment own{Vec3(0, 0, 0), Vec3(0, 2, 0)};
  const Segment other{Vec3(4, 1, 0), Vec3(8, 1, 0)};
  const Separation s = separation(own, other);
  EXPECT_NEAR((s.normal - Vec3(-1, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(s.offset_m, -2.0, 1e-15);
  EXPECT_NEAR(s.half_gap_m, 2.0, 1e-15);
}

TEST(Separation, OfTouchingTailsIsNone) {
  const Segment a{Vec3(-1, 0, 0), Vec3(1, 0, 0)};
  EXPECT_LE(separation(a, {Vec3(0, -1, 0), Vec3(0, 1, 0)}).half_gap_m, 0.0);
  EXPECT_LE(separation(a, a).half_gap_m, 0.0);
}

/// A segment, now and then a point, now and then parallel to x.
Segment any_segment(RandomStream& random) {
  const auto any = [&] { return Vec3(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)); };
  const Vec3 from_m = any();
  const double kind = random.uniform();
  if (kind < 0.1) return {from_m, from_m};
  if (kind < 0.3) return {from_m, from_m + Vec3(random.uniform(-5, 5), 0, 0)};
  return {from_m, any()};
}

TEST(Separation, IsTheSameForBothAndNoNearerPointExists) {
  for (std::uint64_t n = 0; n < 20000; ++n) {
    RandomStream random(3, 0, Purpose::Test, n);
    const Segment a = any_segment(random);
    const Segment b = any_segment(random);
    const Separation own = separation(a, b);
    const Separation its = separation(b, a);
    ASSERT_TRUE(own.normal == -its.normal);
    ASSERT_EQ(own.offset_m, -its.offset_m);
    ASSERT_EQ(own.half_gap_m, its.half_gap_m);
    double least_m = 1e9;
    for (int k = 0; k <= 50; ++k) {
      const Vec3 place_m = a.from_m + k / 50.0 * (a.to_m - a.from_m);
      least_m = std::min(least_m, point_to_segment(place_m, b.from_m, b.to_m));
    }
    ASSERT_LE(distance_m(a, b), least_m + 1e-9);
    ASSERT_GE(distance_m(a, b), least_m - 0.2);
    ASSERT_NEAR(2.0 * own.half_gap_m, distance_m(a, b), 1e-6);
    for (const Vec3& end_m : {a.from_m, a.to_m}) {
      ASSERT_GE(own.normal.dot(end_m) - own.offset_m, own.half_gap_m - 1e-12);
    }
  }
}

}  // namespace
}  // namespace skein
