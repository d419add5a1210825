#include "groundstation/watch/rate_meter.hpp"

#include <gtest/gtest.h>

namespace skein::watch {
namespace {

TEST(RateMeter, NothingCameMeansZero) {
  const RateMeter meter;
  EXPECT_EQ(meter.at(5.0).samples_per_s, 0.0);
  EXPECT_EQ(meter.samples(), 0U);
}

TEST(RateMeter, TakesTheLastTwoSeconds) {
  RateMeter meter;
  for (int i = 0; i < 50; ++i) meter.add(0.1 * i + 0.01, 30);  // ten a second, for five seconds
  const Rate rate = meter.at(4.95);
  EXPECT_NEAR(rate.samples_per_s, 10.0, 0.3);
  EXPECT_NEAR(rate.bytes_per_s, 300.0, 9.0);
  EXPECT_EQ(meter.samples(), 50U);
  EXPECT_EQ(meter.bytes(), 1500U);
}

TEST(RateMeter, ForgetsWhatIsOlder) {
  RateMeter meter;
  meter.add(0.9, 100);
  meter.add(1.0, 100);
  EXPECT_GT(meter.at(1.1).bytes_per_s, 0.0);
  EXPECT_EQ(meter.at(3.5).bytes_per_s, 0.0);
}

TEST(RateMeter, IsRightFromTheFirstSecondOn) {
  RateMeter meter;
  for (int i = 0; i <= 10; ++i) meter.add(0.1 * i, 10);
  EXPECT_NEAR(meter.at(1.0).samples_per_s, 10.0, 1e-9);
}

TEST(RateMeter, OneAloneHasNoRate) {
  RateMeter meter;
  meter.add(1.0, 100);
  EXPECT_EQ(meter.at(1.5).samples_per_s, 0.0);
  EXPECT_EQ(meter.samples(), 1U);
}

}  // namespace
}  // namespace skein::watch
