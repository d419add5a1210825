// When samples are due: simulated time over the rate, and planning rounds, in which it stands still, one by one.
#include "groundstation/replay/replay_pace.hpp"

#include <gtest/gtest.h>

namespace skein::replay {
namespace {

constexpr std::uint64_t kSecond = 1'000'000'000;

TEST(ReplayPace, FlightIsSimulatedTimeOverTheRate) {
  ReplayPace pace(4.0, 0.1);
  EXPECT_EQ(pace.due_s(7), 0.0);
  EXPECT_DOUBLE_EQ(pace.due_s(7 + 2 * kSecond), 0.5);
  EXPECT_DOUBLE_EQ(pace.due_s(7 + 2 * kSecond), 0.5);
  EXPECT_DOUBLE_EQ(pace.due_s(7 + 3 * kSecond), 0.75);
}

TEST(ReplayPace, ARoundInWhichTimeStandsStillStandsForItsOwn) {
  ReplayPace pace(2.0, 0.1);
  EXPECT_EQ(pace.due_s(0), 0.0);
  EXPECT_DOUBLE_EQ(pace.due_s(1), 0.05);
  EXPECT_DOUBLE_EQ(pace.due_s(1), 0.05);
  EXPECT_DOUBLE_EQ(pace.due_s(4), 0.2);  // of two rounds nothing was recorded
}

TEST(ReplayPace, TheFirstSampleIsDueAtOnceWhereverItBegins) {
  ReplayPace pace(1.0, 0.1);
  EXPECT_EQ(pace.due_s(500 * kSecond), 0.0);
  EXPECT_DOUBLE_EQ(pace.due_s(501 * kSecond), 1.0);
}

TEST(ReplayPace, WithoutARateEverythingIsDue) {
  ReplayPace pace(0.0, 0.1);
  EXPECT_EQ(pace.due_s(0), 0.0);
  EXPECT_EQ(pace.due_s(1), 0.0);
  EXPECT_EQ(pace.due_s(1000 * kSecond), 0.0);
}

}  // namespace
}  // namespace skein::replay
