#include "simworld/lockstep/pacer.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Pacer, WithoutAFactorNothingWaits) {
  Pacer pacer({0.0, 0.1}, 0.5);
  pacer.opened(Phase::Flying, 10.0);
  EXPECT_TRUE(pacer.may_open(10.0));
  EXPECT_EQ(pacer.late(), 0U);
}

TEST(Pacer, StepsAndRoundsTakeTheirTimeAndDoNotDrift) {
  Pacer pacer({2.0, 0.1}, 0.5);  // twice real time: rounds of 0.05 s, steps of 0.25 s
  pacer.opened(Phase::Planning, 100.0);
  EXPECT_FALSE(pacer.may_open(100.01));
  EXPECT_DOUBLE_EQ(pacer.due_s(), 100.05);
  EXPECT_TRUE(pacer.may_open(100.0501));  // the wait ends a little late: no drift
  pacer.opened(Phase::Flying, 100.0501);
  EXPECT_DOUBLE_EQ(pacer.due_s(), 100.30);
  EXPECT_FALSE(pacer.may_open(100.2));
  EXPECT_TRUE(pacer.may_open(100.31));
  pacer.opened(Phase::Flying, 100.31);
  EXPECT_DOUBLE_EQ(pacer.due_s(), 100.55);
  EXPECT_EQ(pacer.late(), 0U);
}

TEST(Pacer, RoundsOfAFlightStepShareItsTime) {
  Pacer pacer({1.0, 0.1}, 0.5);
  pacer.opened(Phase::Flying, 10.0, 5);
  EXPECT_DOUBLE_EQ(pacer.due_s(), 10.1);
}

TEST(Pacer, ALateAnswerCountsOnceAndStretches) {
  Pacer pacer({1.0, 0.1}, 0.5);
  pacer.opened(Phase::Flying, 10.0);
  EXPECT_TRUE(pacer.may_open(12.0));
  EXPECT_TRUE(pacer.may_open(12.5));
  EXPECT_EQ(pacer.late(), 1U);
  pacer.opened(Phase::Flying, 12.5);
  EXPECT_DOUBLE_EQ(pacer.due_s(), 13.0);
  EXPECT_FALSE(pacer.may_open(12.6));
  EXPECT_TRUE(pacer.may_open(13.0));
  EXPECT_EQ(pacer.late(), 1U);
}

}  // namespace
}  // namespace skein
