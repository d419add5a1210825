#include "planner/core/geometry/bounds.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Interval, ContainsItsEndsAndClampsToThem) {
  constexpr Interval range{-1.0, 3.0};
  EXPECT_EQ(range.width(), 4.0);
  EXPECT_TRUE(range.contains(-1.0));
  EXPECT_TRUE(range.contains(3.0));
  EXPECT_FALSE(range.contains(3.0000001));
  EXPECT_EQ(range.clamp(-5.0), -1.0);
  EXPECT_EQ(range.clamp(5.0), 3.0);
  EXPECT_EQ(range.clamp(0.5), 0.5);
}

}  // namespace
}  // namespace skein
