// A process that was stopped does not take its own standstill for the silence of others.
#include "idl/process/silence.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Silence, CountsFromTheLastTimeThatSomebodyWasHeard) {
  Silence silence(100.0);
  silence.look(101.0);
  EXPECT_DOUBLE_EQ(silence.silent_s(), 1.0);
  silence.heard();
  EXPECT_DOUBLE_EQ(silence.silent_s(), 0.0);
  for (double now_s = 102.0; now_s <= 131.0; now_s += 1.0) silence.look(now_s);
  EXPECT_DOUBLE_EQ(silence.silent_s(), 30.0);
  EXPECT_DOUBLE_EQ(silence.stood_still_s(), 0.0);
}

TEST(Silence, BeginsAnewWhenItsOwnerStoodStill) {
  Silence silence(100.0);
  silence.look(101.0);
  silence.look(141.0);
  EXPECT_DOUBLE_EQ(silence.silent_s(), 0.0);
  EXPECT_DOUBLE_EQ(silence.stood_still_s(), 40.0);
  silence.look(142.5);
  EXPECT_DOUBLE_EQ(silence.silent_s(), 1.5);
}

TEST(Silence, IsMeasuredAtTheLastLook) {
  Silence silence(100.0);
  silence.look(100.5);
  // however late its owner asks: it was stopped since, and has not looked
  EXPECT_DOUBLE_EQ(silence.silent_s(), 0.5);
}

TEST(Silence, WhatWaitedForItsOwnerProvesNoLifeAfterTheStall) {
  Silence silence(100.0);
  silence.look(111.0);
  silence.heard();
  EXPECT_DOUBLE_EQ(silence.stood_still_s(), 11.0);
  silence.look(112.9);
  silence.heard();
  EXPECT_DOUBLE_EQ(silence.stood_still_s(), 0.0);
}

TEST(Silence, StallsAddUp) {
  Silence silence(100.0);
  silence.look(103.0);
  silence.look(103.1);
  silence.look(108.1);
  EXPECT_DOUBLE_EQ(silence.stood_still_s(), 8.0);
}

}  // namespace
}  // namespace skein
