#include "agent/controller/half_spaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planner/core/random/random_stream.hpp"

namespace skein {
namespace {

TEST(HalfSpaces, OneCutsTheWishOff) {
  const std::vector<HalfSpace> spaces{{Vec3(-1, 0, 0), -2.0}};  // v_x <= 2
  const auto v = nearest_in(spaces, 0.0, 10.0, Vec3(5, 1, 3), false);
  ASSERT_TRUE(v);
  EXPECT_NEAR((*v - Vec3(2, 1, 3)).norm(), 0.0, 1e-12);
}

TEST(HalfSpaces, LeaveAWishThatFitsAsItIs) {
  const Vec3 wish(1.1, 2.2, 3.3);
  EXPECT_EQ(nearest_in({}, 0.0, 10.0, wish, false), wish);
}

TEST(HalfSpaces, OppositeOnesAreViolatedAlike) {
  const std::vector<HalfSpace> spaces{{Vec3(1, 0, 0), 1.0}, {Vec3(-1, 0, 0), 3.0}};  // v_x >= 1 and v_x <= -3
  EXPECT_FALSE(nearest_in(spaces, 0.0, 10.0, Vec3(0, 1, 0), false));
  const Vec3 v = nearest_or_least_violation(spaces, 10.0, Vec3(0, 1, 0), false);
  EXPECT_NEAR(v.x(), -1.0, 1e-3);
  EXPECT_NEAR(v.y(), 1.0, 1e-3);
}

TEST(HalfSpaces, NothingAllowedIsNearer) {
  int infeasible = 0;
  for (std::uint64_t n = 0; n < 3000; ++n) {
    RandomStream random(4, 0, Purpose::Test, n);
    const bool level = random.uniform() < 0.5;
    const auto any = [&](double most) {
      return Vec3(random.uniform(-most, most), random.uniform(-most, most), level ? 0.0 : random.uniform(-most, most));
    };
    std::vector<HalfSpace> spaces(random.below(8));
    for (HalfSpace& s : spaces) s = {any(1.0).normalized(), random.uniform(-5.0, 2.0)};
    const Vec3 wish = any(8.0);
    const auto outside = [&](const Vec3& v) {
      double worst = v.norm() - 6.0;
      for (const HalfSpace& s : spaces) worst = std::max(worst, s.least_mps - s.normal.dot(v));
      return worst;
    };
    const auto best = nearest_in(spaces, 0.0, 6.0, wish, level);
    infeasible += best ? 0 : 1;
    const Vec3 least = nearest_or_least_violation(spaces, 6.0, wish, level);
    if (best) {
      ASSERT_LE(outside(*best), 1e-6) << n;
      ASSERT_TRUE(least == *best);
    }
    for (int k = 0; k < 300; ++k) {
      const Vec3 v = any(6.0);
      if (v.norm() > 6.0) continue;
      if (best && outside(v) <= 0.0) {
        ASSERT_GE((v - wish).norm(), (*best - wish).norm() - 1e-6) << n;
      }
      if (!best) {
        ASSERT_GE(outside(v), outside(least) - 1e-3) << n;
      }
    }
  }
  EXPECT_GT(infeasible, 20);
}

}  // namespace
}  // namespace skein
