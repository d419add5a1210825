// Only the whole swarm can prove this: whoever is lost, in whichever round, the others end in the same round, Ready,
// with one length. And many UAVs at once find their way past each other.
#include <gtest/gtest.h>

#include "planner/core/random/random_stream.hpp"
#include "tests/planner/rendezvous/layouts.hpp"
#include "tests/planner/rendezvous/swarm_run.hpp"

namespace skein::rendezvous {
namespace {

void expect_one_length(const test::SwarmRun& run) {
  ASSERT_TRUE(run.all(PlanStatus::Ready));
  const double length_m = run.planners[0].path_length_m();
  for (const Planner& planner : run.planners) {
    EXPECT_NEAR(planner.path_length_m(), length_m, 1e-9 * length_m);
    EXPECT_EQ(check_alone(planner.planar().problem(), planner.planar().path()), Constraint::None);
    const DensePath own = sample_densely(planner.planar().problem(), planner.planar().path());
    for (const Planner& other : run.planners) {
      if (&other == &planner) continue;
      const DensePath dense = sample_densely(planner.planar().problem(), other.planar().path());
      EXPECT_TRUE(keeps_apart(own, dense,
                              required_separation_m(planner.planar().problem().own(), other.planar().problem().own())));
    }
  }
}

TEST(LossProperty, TheOthersEndTogetherInEveryCase) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    for (std::size_t lost = 0; lost < 3; ++lost) {
      RandomStream stream(seed, static_cast<std::uint32_t>(lost), Purpose::Test, 40);
      // Half of the losses fall into the few rounds of the alignment.
      const int when = static_cast<int>(stream.below(2) == 0 ? stream.below(51) : 51 + stream.below(3));
      const test::SwarmRun run = test::run_swarm(test::layout_a(seed), 200, [&](int round, test::SwarmRun& swarm) {
        if (round != when) return;
        swarm.planners.erase(swarm.planners.begin() + static_cast<std::ptrdiff_t>(lost));
        if (!swarm.last.empty()) swarm.last.erase(swarm.last.begin() + static_cast<std::ptrdiff_t>(lost));
      });
      SCOPED_TRACE("seed " + std::to_string(seed) + ", UAV " + std::to_string(lost + 1) + " lost in round " +
                   std::to_string(when));
      ASSERT_EQ(run.planners.size(), 2U);
      expect_one_length(run);
    }
  }
}

TEST(LossProperty, TheLastOneLeftStillPlans) {
  const test::SwarmRun run = test::run_swarm(test::layout_b(3), 200, [](int round, test::SwarmRun& swarm) {
    if (round != 20 && round != 52) return;
    swarm.planners.erase(swarm.planners.begin());
    swarm.last.erase(swarm.last.begin());
  });
  ASSERT_EQ(run.planners.size(), 1U);
  expect_one_length(run);
}

TEST(LossProperty, RingsFindTheirWayPastEachOther) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_one_length(test::run_swarm(test::ring(seed, 5, 10000.0, 2000.0)));
  }
  expect_one_length(test::run_swarm(test::ring(1, 12, 10000.0, 2000.0)));
}

}  // namespace
}  // namespace skein::rendezvous
