#include "planner/rendezvous/stages.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace skein::rendezvous {
namespace {

Representative sample(AgentId agent, Constraint violated) {
  Representative out;
  out.agent = agent;
  out.violated = violated;
  out.particle = {1.0, 2.0};
  return out;
}

TEST(Stages, TroubleIsWhatAPathViolatesAlone) {
  EXPECT_FALSE(anyone_in_trouble(sample(1, Constraint::None), {}));
  EXPECT_FALSE(anyone_in_trouble(sample(1, Constraint::Separation), std::vector{sample(2, Constraint::Separation)}));
  for (const Constraint c : {Constraint::Curvature, Constraint::Obstacle, Constraint::NoFly, Constraint::Length,
                             Constraint::Torsion, Constraint::Terrain}) {
    EXPECT_TRUE(anyone_in_trouble(sample(1, c), {}));
    EXPECT_TRUE(anyone_in_trouble(sample(1, Constraint::None), std::vector{sample(2, c)}));
  }
}

TEST(Stages, ThoseInTroubleTakeASegmentOrElseAll) {
  const Representative clear = sample(1, Constraint::None);
  const Representative asks = sample(1, Constraint::Separation);
  const Representative blocked = sample(1, Constraint::NoFly);
  const std::vector<Representative> clear_peers{sample(2, Constraint::None), sample(3, Constraint::Separation)};
  const std::vector<Representative> blocked_peers{sample(2, Constraint::None), sample(3, Constraint::Obstacle)};
  EXPECT_TRUE(takes_segment(blocked, clear_peers));
  EXPECT_TRUE(takes_segment(blocked, blocked_peers));
  EXPECT_FALSE(takes_segment(clear, blocked_peers));
  EXPECT_FALSE(takes_segment(asks, blocked_peers));
  EXPECT_TRUE(takes_segment(clear, clear_peers));
  EXPECT_TRUE(takes_segment(asks, clear_peers));
}

TEST(Stages, StandstillIsFiveRoundsWithoutAChange) {
  Standstill standstill;
  std::vector<Representative> peers{sample(2, Constraint::NoFly)};
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(standstill.lasts(sample(1, Constraint::None), peers)) << k;
  EXPECT_TRUE(standstill.lasts(sample(1, Constraint::None), peers));
  peers[0].particle[1] = 3.0;
  EXPECT_FALSE(standstill.lasts(sample(1, Constraint::None), peers));
  peers.clear();
  EXPECT_FALSE(standstill.lasts(sample(1, Constraint::None), peers));
}

TEST(Stages, EveryStageHasItsOwnSeedAndTheFirstThatOfTheRun) {
  EXPECT_EQ(seed_of_stage(7, 1), 7U);
  std::set<std::uint64_t> seeds;
  for (std::uint64_t run = 0; run < 100; ++run) {
    for (std::uint32_t stage = 1; stage <= 4; ++stage) EXPECT_TRUE(seeds.insert(seed_of_stage(run, stage)).second);
  }
}

}  // namespace
}  // namespace skein::rendezvous
