#include "groundstation/watch/step_clock.hpp"

#include <gtest/gtest.h>

namespace skein::watch {
namespace {

void feed(StepClock& clock, std::uint32_t first, std::uint32_t count, double period_s) {
  for (std::uint32_t k = first; k < first + count; ++k) {
    Tick tick;
    tick.round = k;
    tick.step = k;
    tick.time_s = 0.5 * k;
    tick.phase = Phase::Flying;
    clock.take(tick, static_cast<std::int64_t>(period_s * k * 1e9));
  }
}

TEST(StepClock, TellsTheUsualPeriodAndThePace) {
  StepClock clock;
  feed(clock, 1, 5, 0.1);
  EXPECT_FALSE(clock.period_s());
  feed(clock, 6, 20, 0.1);
  EXPECT_NEAR(*clock.period_s(), 0.1, 1e-9);
  EXPECT_NEAR(clock.times_real_time().value(), 5.0, 1e-6);
  EXPECT_EQ(clock.opened_ns(20), std::int64_t{2000000000});
  EXPECT_FALSE(clock.opened_ns(99));
}

TEST(StepClock, AMissedTickIsNoLongPeriod) {
  StepClock clock;
  for (std::uint32_t k = 1; k < 60; k += 2) feed(clock, 3 * k, 2, 0.1);
  EXPECT_NEAR(*clock.period_s(), 0.1, 1e-9);
}

TEST(StepClock, OfSlowStepsThePaceIsThatOfTheLastTwo) {
  StepClock clock;
  feed(clock, 1, 5, 4.0);
  EXPECT_NEAR(clock.times_real_time().value(), 0.125, 1e-9);
}

TEST(StepClock, WaitingHasNoPace) {
  StepClock clock;
  Tick tick;
  tick.phase = Phase::Waiting;
  clock.take(tick, 0);
  clock.take(tick, 500000000);
  EXPECT_FALSE(clock.times_real_time());
}

TEST(StepClock, WhatNobodyStampedHasNoPace) {
  StepClock clock;
  feed(clock, 1, 20, 0.0);
  EXPECT_FALSE(clock.times_real_time());
}

}  // namespace
}  // namespace skein::watch
