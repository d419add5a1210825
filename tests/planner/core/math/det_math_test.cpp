#include "planner/core/math/det_math.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace skein::math {
namespace {

TEST(DetMath, KnownValues) {
  EXPECT_DOUBLE_EQ(sin(kPi / 6.0), 0.5);
  EXPECT_DOUBLE_EQ(cos(kPi / 3.0), 0.5);
  EXPECT_DOUBLE_EQ(tan(kPi / 4.0), 1.0);
  EXPECT_DOUBLE_EQ(atan(1.0), kPi / 4.0);
  EXPECT_DOUBLE_EQ(asin(0.5), kPi / 6.0);
  EXPECT_DOUBLE_EQ(acos(0.5), kPi / 3.0);
  EXPECT_DOUBLE_EQ(exp(1.0), std::numbers::e);
  EXPECT_DOUBLE_EQ(log(std::numbers::e), 1.0);
  EXPECT_DOUBLE_EQ(pow(2.0, 10.0), 1024.0);
  EXPECT_DOUBLE_EQ(hypot(3.0, 4.0), 5.0);
  const SinCos both = sincos(1.0);
  EXPECT_EQ(both.sin, sin(1.0));
  EXPECT_EQ(both.cos, cos(1.0));
}

TEST(DetMath, AtanTakesAllQuadrants) {
  EXPECT_DOUBLE_EQ(atan2(1.0, 1.0), kPi / 4.0);
  EXPECT_DOUBLE_EQ(atan2(1.0, -1.0), 3.0 * kPi / 4.0);
  EXPECT_DOUBLE_EQ(atan2(-1.0, -1.0), -3.0 * kPi / 4.0);
  EXPECT_DOUBLE_EQ(atan2(-1.0, 1.0), -kPi / 4.0);
  EXPECT_DOUBLE_EQ(atan2(0.0, -1.0), kPi);
}

TEST(DetMath, WrapAngleKeepsTheUpperEnd) {
  EXPECT_EQ(wrap_angle(0.5), 0.5);
  EXPECT_EQ(wrap_angle(kPi), kPi);
  EXPECT_EQ(wrap_angle(-kPi), kPi);
  EXPECT_NEAR(wrap_angle(3.0 * kPi / 2.0), -kPi / 2.0, 1e-15);
  EXPECT_NEAR(wrap_angle(-7.0 * kPi / 2.0), kPi / 2.0, 1e-14);
  for (int k = -2000; k <= 2000; ++k) {
    const double angle = 0.0137 * k;
    const double wrapped = wrap_angle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(sin(wrapped), sin(angle), 1e-13);
    EXPECT_NEAR(cos(wrapped), cos(angle), 1e-13);
  }
}

}  // namespace
}  // namespace skein::math
