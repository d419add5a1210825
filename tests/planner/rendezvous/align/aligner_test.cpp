#include "planner/rendezvous/align/aligner.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/planner/rendezvous/layouts.hpp"

namespace skein::rendezvous {
namespace {

Representative published(const Problem& problem, const Aligner& aligner) {
  Representative r;
  r.agent = problem.own().id;
  r.stage = aligner.settled() ? PlanStage::Settled : PlanStage::Aligning;
  r.violated = aligner.violated();
  r.particle = {aligner.controls().m0_m, aligner.controls().m1_m};
  r.path_length_m = aligner.length_m();
  r.own_length_m = aligner.length_m();
  return r;
}

TEST(Aligner, OneUavAlone) {
  const Problem problem = make_problem(test::open_field(1), 1);
  Aligner aligner({40000.0, 9000.0}, {40000.0, 9000.0});
  EXPECT_EQ(aligner.advance(problem, {}), Aligner::Outcome::Aligning);  // its own best
  EXPECT_EQ(aligner.advance(problem, {}), Aligner::Outcome::Aligning);  // settled
  EXPECT_TRUE(aligner.settled());
  EXPECT_EQ(aligner.advance(problem, {}), Aligner::Outcome::Agreed);
  EXPECT_NEAR(aligner.length_m(), 35061.1, 0.5);
}

TEST(Aligner, MovesToTheLongestPublishedLengthExactly) {
  const Problem problem = make_problem(test::layout_a(1), 2);
  Representative peer;
  peer.agent = 1;
  peer.particle = {37333.0, 7879.0};
  peer.path_length_m = problem.participants[0].hermite.length_m({37333.0, 7879.0});
  peer.own_length_m = peer.path_length_m;
  peer.stage = PlanStage::Aligning;
  Aligner aligner({8000.0, 29000.0}, {71400.0, 121500.0});
  (void)aligner.advance(problem, {&peer, 1});
  EXPECT_LT(aligner.length_m(), 32000.0);
  (void)aligner.advance(problem, {&peer, 1});
  EXPECT_NEAR(aligner.length_m(), peer.path_length_m, 1e-9 * peer.path_length_m);
  EXPECT_FALSE(aligner.settled()) << "it has just moved";
  (void)aligner.advance(problem, {&peer, 1});
  EXPECT_TRUE(aligner.settled());
  EXPECT_EQ(aligner.advance(problem, {&peer, 1}), Aligner::Outcome::Aligning) << "the peer has not settled";
  EXPECT_TRUE(aligner.settled());
  peer.stage = PlanStage::Settled;
  EXPECT_EQ(aligner.advance(problem, {&peer, 1}), Aligner::Outcome::Agreed);
}

/// The first two UAVs of the open field, with other safety radii; their slots are 1.08 km apart.
Mission crossing(double safety_m) {
  Mission mission = test::open_field(1);
  mission.vehicles.resize(2);
  for (VehicleSpec& v : mission.vehicles) v.safety_radius_m = safety_m;
  return mission;
}

TEST(Aligner, TheHigherIdGivesWay) {
  const Mission mission = crossing(100.0);
  const Problem problem = make_problem(mission, 2);
  Aligner aligner({8000.0, 29000.0}, {71400.0, 121500.0});
  Representative peer;
  peer.agent = 1;
  peer.stage = PlanStage::Aligning;
  peer.particle = {37333.0, 7879.0};
  peer.path_length_m = problem.participants[0].hermite.length_m({37333.0, 7879.0});
  peer.own_length_m = peer.path_length_m;
  for (int r = 0; r < 3; ++r) (void)aligner.advance(problem, {&peer, 1});
  ASSERT_TRUE(aligner.settled());
  const DensePath first = sample_densely(problem, problem.participants[0].hermite.path({37333.0, 7879.0}));
  const DensePath second = sample_densely(problem, problem.own().hermite.path(aligner.controls()));
  EXPECT_TRUE(keeps_apart(first, second, 200.0));
}

TEST(Aligner, FailsWithSeparationWhenNoWayIsLeft) {
  // Slots are 1.08 km apart: safety radii of 600 m overlap in formation whatever the paths.
  const Mission mission = crossing(600.0);
  std::vector<Problem> problems{make_problem(mission, 1), make_problem(mission, 2)};
  std::vector<Aligner> aligners{{{37333.0, 7879.0}, {37333.0, 7879.0}}, {{8000.0, 29000.0}, {71400.0, 121500.0}}};
  std::vector<Representative> last;
  for (std::size_t i = 0; i < 2; ++i) last.push_back(published(problems[i], aligners[i]));
  for (Representative& r : last) r.own_length_m = 1.0;
  std::vector<Aligner::Outcome> outcomes(2, Aligner::Outcome::Aligning);
  int rounds = 0;
  for (; outcomes[0] == Aligner::Outcome::Aligning; ++rounds) {
    std::vector<Representative> next;
    for (std::size_t i = 0; i < 2; ++i) {
      outcomes[i] = aligners[i].advance(problems[i], {&last[1 - i], 1});
      next.push_back(published(problems[i], aligners[i]));
    }
    last = next;
  }
  EXPECT_EQ(rounds, mission.planner.equalise_rounds + 1);
  EXPECT_EQ(outcomes[0], Aligner::Outcome::Failed);
  EXPECT_EQ(outcomes[1], Aligner::Outcome::Failed);
  EXPECT_EQ(aligners[1].violated(), Constraint::Separation);
  EXPECT_EQ(aligners[1].violated_peer(), 1U);
  EXPECT_EQ(aligners[0].violated(), Constraint::Separation);
  EXPECT_EQ(aligners[0].violated_peer(), 2U);
}

}  // namespace
}  // namespace skein::rendezvous
