// Only many flights can prove it: wherever a fixed obstacle falls on somebody's way, all plan anew, keep clear and
// arrive in one step.
#include <gtest/gtest.h>

#include "tests/agent/behaviours/surprise_run.hpp"

namespace skein::test {
namespace {

TEST(SurpriseProperty, AllArriveInOneStep) {
  int surprised = 0;
  for (std::uint64_t seed = 1000; seed < 1060; ++seed) {
    const SurpriseRun run = run_surprise(seed);
    if (!run.planned || !run.surprised) continue;
    ++surprised;
    EXPECT_TRUE(run.together) << "seed " << seed << ": " << run.arrivals;
    EXPECT_TRUE(run.agreed) << "seed " << seed;
    EXPECT_GT(run.least_clearance_m, 0.0) << "seed " << seed;
  }
  EXPECT_GT(surprised, 40);
}

}  // namespace
}  // namespace skein::test
