// The course of a run from hand-made answers: phases, rounds, roster, state hash.
#include "simworld/lockstep/run.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/simworld/lockstep/rounds.hpp"
#include "tests/simworld/missions.hpp"

namespace skein {
namespace {

using test::decide;

Run run_of(AgentId count, WorldOptions options = {}) {
  return Run(test::kRun, test::abreast(count), options, false);
}

TEST(Run, OpensWithAPlanningRoundOfAll) {
  skein::Run run = run_of(2);
  const std::uint64_t start = run.state_hash();
  EXPECT_EQ(start, mission_hash(test::abreast(2)));
  const Tick tick = run.begin(test::roster_of(2));
  EXPECT_EQ(tick.run, test::kRun);
  EXPECT_EQ(tick.round, 1U);
  EXPECT_EQ(tick.step, 0U);
  EXPECT_EQ(tick.phase, Phase::Planning);
  EXPECT_EQ(tick.world_hash, start);
  EXPECT_EQ(tick.roster, test::roster_of(2));
}

TEST(Run, PlansFliesAndEnds) {
  skein::Run run = run_of(2);
  Tick tick = run.begin(test::roster_of(2));
  tick = decide(run, tick, AgentMode::Planning);
  EXPECT_EQ(tick.phase, Phase::Planning);
  EXPECT_EQ(tick.round, 2U);
  tick = decide(run, tick, AgentMode::Ready);
  EXPECT_EQ(tick.phase, Phase::Flying);
  EXPECT_EQ(tick.step, 1U);
  EXPECT_EQ(tick.time_s, 0.0);
  EXPECT_TRUE(tick.roster[0].sense);
  EXPECT_EQ(run.planning_rounds(), 2U);
  tick = decide(run, tick, AgentMode::Flying);
  EXPECT_EQ(tick.step, 2U);
  EXPECT_EQ(tick.time_s, 1.0);
  tick = test::fly_on(run, tick, 2);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(tick.time_s, 3.0);
  EXPECT_FALSE(tick.roster[0].sense);
  EXPECT_EQ(run.steps_flown(), 3U);
  EXPECT_EQ(run.rounds(), 6U);
  EXPECT_EQ(run.plan()[1].length_m, 1002.0);
  EXPECT_THROW((void)decide(run, tick, AgentMode::Flying), std::logic_error);
}

TEST(Run, WaitsForTheLastToBeReady) {
  skein::Run run = run_of(2);
  Tick tick = run.begin(test::roster_of(2));
  tick = decide(run, tick, AgentMode::Ready, {}, [](Beacon& beacon) {
    if (beacon.agent == 2) beacon.mode = AgentMode::Planning;
  });
  EXPECT_EQ(tick.phase, Phase::Planning);
}

TEST(Run, CountsTheRepresentativesOfTheRoundBefore) {
  skein::Run run = run_of(2);
  Tick tick = run.begin(test::roster_of(2));
  EXPECT_FALSE(tick.roster[0].representative);
  tick = decide(run, tick, AgentMode::Planning, {}, [](Beacon& beacon) { beacon.representative = beacon.agent == 1; });
  EXPECT_TRUE(tick.roster[0].representative);
  EXPECT_FALSE(tick.roster[1].representative);
}

TEST(Run, KnowsWhereItIsGoing) {
  skein::Run run = run_of(2);
  const Tick tick = run.begin(test::roster_of(2));
  Barrier barrier;
  barrier.open(tick, 0.0);
  barrier.accept(test::closing(1, 1, AgentMode::Ready));
  const std::vector<Loss> lost{{2, LossReason::Deadline}};
  EXPECT_EQ(run.next(barrier, lost), (Moment{Phase::Flying, 1}));
  barrier.accept(test::closing(2, 1, AgentMode::Planning));
  EXPECT_EQ(run.next(barrier, {}), (Moment{Phase::Planning, 2}));
  const Tick flight = run.decide(barrier, lost);
  barrier.open(flight, 0.0);
  EXPECT_EQ(run.next(barrier, {}), (Moment{Phase::Flying, 2}));
}

TEST(Run, RefusesToDecideWithoutAnAnswer) {
  skein::Run run = run_of(2);
  const Tick tick = run.begin(test::roster_of(2));
  Barrier barrier;
  barrier.open(tick, 0.0);
  barrier.accept(test::closing(1, 1));
  EXPECT_THROW((void)run.decide(barrier, {}), std::logic_error);
}

TEST(Run, LossesTakeEffectInTheNextTick) {
  skein::Run run = run_of(3);
  Tick tick = run.begin(test::roster_of(3));
  tick = decide(run, tick, AgentMode::Planning, std::vector<Loss>{{2, LossReason::Left}});
  ASSERT_EQ(tick.roster.size(), 2U);
  EXPECT_EQ(tick.roster[1].agent, 3U);
  ASSERT_EQ(run.changes().size(), 1U);
  EXPECT_EQ(run.changes()[0], (RosterChange{0, 2, 2, 1, LossReason::Left}));
  tick = decide(run, tick, AgentMode::Ready);
  tick = decide(run, tick, AgentMode::Flying, std::vector<Loss>{{3, LossReason::Deadline}});
  EXPECT_EQ(run.changes()[1], (RosterChange{2, 4, 3, 1, LossReason::Deadline}));
  EXPECT_EQ(run.world().vehicle(3).status, VehicleStatus::Removed);
}

TEST(Run, AnswersOfALostAgentDoNotCount) {
  const std::vector<Loss> lost{{2, LossReason::ProcessEnded}};
  const auto hash_with = [&](bool answered) {
    skein::Run run = run_of(2);
    const Tick tick = run.begin(test::roster_of(2));
    Barrier barrier;
    barrier.open(tick, 0.0);
    barrier.accept(test::closing(1, 1));
    if (answered) barrier.accept(test::closing(2, 1, AgentMode::Failed));
    const Tick next = run.decide(barrier, lost);
    EXPECT_EQ(next.phase, Phase::Planning);
    return run.state_hash();
  };
  EXPECT_EQ(hash_with(true), hash_with(false));
}

/// What agent 2 answers after its return.
void as_rejoined(Beacon& beacon) {
  if (beacon.agent != 2) return;
  beacon.incarnation = 2;
  beacon.mode = AgentMode::Rejoined;
}

const std::vector<Loss> kSecondLost{{2, LossReason::ProcessEnded}};
const std::vector<RosterEntry> kSecondBack{{2, 2, 555, false, false}};

/// Decides a round that loses agent 2 and lets it come back at once.
Tick restart_second(skein::Run& run, const Tick& tick, AgentMode mode) {
  Barrier barrier;
  barrier.open(tick, 0.0);
  for (const RosterEntry& entry : tick.roster) {
    Beacon beacon = test::closing(entry.agent, tick.round, mode);
    beacon.representative = true;
    barrier.accept(beacon);
    barrier.accept(test::representative(entry.agent, tick.round));
  }
  return run.decide(barrier, kSecondLost, kSecondBack);
}

TEST(Run, WhoComesBackIsNamedButHoldsUpNoPlanning) {
  skein::Run run = run_of(3);
  Tick tick = restart_second(run, run.begin(test::roster_of(3)), AgentMode::Planning);
  ASSERT_EQ(tick.roster.size(), 3U);
  EXPECT_EQ(tick.roster[1].incarnation, 2U);
  EXPECT_FALSE(tick.roster[1].representative) << "that sample was its old incarnation's";
  EXPECT_TRUE(tick.roster[0].representative);
  ASSERT_EQ(run.changes().size(), 2U);
  EXPECT_EQ(run.changes()[1], (RosterChange{0, 2, 2, 2, LossReason::Rejoined}));
  tick = decide(run, tick, AgentMode::Ready, {}, as_rejoined);
  EXPECT_EQ(tick.phase, Phase::Flying);
  EXPECT_EQ(run.plan()[1].length_m, 0.0);
  EXPECT_NEAR(*run.plan_spread_m(), 2.0, 1e-12) << "of agents 1 and 3";
  for (int step = 0; step < 3; ++step) tick = decide(run, tick, AgentMode::Flying, {}, as_rejoined);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_EQ(run.verdict().code, ExitCode::AgentLost);
  EXPECT_EQ(run.verdict().completed_without, (std::vector<AgentId>{2}));
  EXPECT_EQ(
      run.verdict().reason,
      "agent 2 was lost at step 0, round 2: process_ended; agent 2 rejoined at step 0, round 2; the others arrived");
}

TEST(Run, PlanningEndsWhenOnlyReturnedAgentsAreLeft) {
  skein::Run run = run_of(2);
  Tick tick = restart_second(run, run.begin(test::roster_of(2)), AgentMode::Planning);
  const std::vector<Loss> first_lost{{1, LossReason::ProcessEnded}};
  tick = decide(run, tick, AgentMode::Planning, first_lost, as_rejoined);
  EXPECT_EQ(tick.phase, Phase::Finished);
  EXPECT_NE(run.verdict().reason.find("no agent is left that took part in planning"), std::string::npos);
}

TEST(Run, NobodyComesBackToARunThatIsOver) {
  skein::Run run = run_of(1);
  const Tick tick = run.begin(test::roster_of(1));
  Barrier barrier;
  barrier.open(tick, 0.0);
  const std::vector<Loss> lost{{1, LossReason::ProcessEnded}};
  const std::vector<RosterEntry> back{{1, 2, 555, false, false}};
  EXPECT_TRUE(run.decide(barrier, lost, back).roster.empty());
  EXPECT_EQ(run.changes().size(), 1U);
}

TEST(Run, AReturnIsInTheHash) {
  const auto hash_with = [](std::span<const RosterEntry> back) {
    skein::Run run = run_of(2);
    const Tick tick = run.begin(test::roster_of(2));
    Barrier barrier;
    barrier.open(tick, 0.0);
    barrier.accept(test::closing(1, 1));
    (void)run.decide(barrier, kSecondLost, back);
    return run.state_hash();
  };
  EXPECT_NE(hash_with({}), hash_with(kSecondBack));
}

/// The hash after one planning and one flight round of two agents, with the flight beacons edited.
std::uint64_t hash_after(const Mission& mission, std::uint64_t run_id, const test::Edit& edit) {
  skein::Run run(run_id, mission, {}, false);
  Tick tick = run.begin(test::roster_of(2));
  tick = decide(run, tick, AgentMode::Ready);
  (void)decide(run, tick, AgentMode::Flying, {}, edit);
  return run.state_hash();
}

TEST(Run, HashDependsOnEachOfItsInputs) {
  const Mission mission = test::abreast(2);
  const std::uint64_t plain = hash_after(mission, 1, {});
  EXPECT_EQ(plain, hash_after(mission, 1, {}));
  Mission other_seed = mission;
  other_seed.seed = 6;
  EXPECT_NE(plain, hash_after(other_seed, 1, {}));
  EXPECT_NE(plain, hash_after(mission, 1, [](Beacon& beacon) { beacon.state_hash += beacon.agent == 2; }));
  EXPECT_NE(plain, hash_after(mission, 1, [](Beacon& beacon) { beacon.commanded_velocity_mps.y() = 1e-6; }));
}

TEST(Run, HashLeavesOutWhatIsNoState) {
  const Mission mission = test::abreast(2);
  const std::uint64_t plain = hash_after(mission, 1, {});
  EXPECT_EQ(plain, hash_after(mission, 2, {}));
  EXPECT_EQ(plain, hash_after(mission, 1, [](Beacon& beacon) {
              beacon.step = 77;
              beacon.cost = 3.0;
              beacon.pose.heading_rad = 1.0;
            }));
}

TEST(Run, HashDependsOnRosterAndIncarnation) {
  const auto hash_of = [](std::uint32_t incarnation, std::span<const Loss> lost) {
    skein::Run run = run_of(3);
    auto roster = test::roster_of(3);
    roster[2].incarnation = incarnation;
    const Tick tick = run.begin(roster);
    (void)decide(run, tick, AgentMode::Planning, lost, [&](Beacon& beacon) {
      if (beacon.agent == 3) beacon.incarnation = incarnation;
    });
    return run.state_hash();
  };
  const std::vector<Loss> lost{{2, LossReason::Left}};
  EXPECT_NE(hash_of(1, {}), hash_of(2, {}));
  EXPECT_NE(hash_of(1, {}), hash_of(1, lost));
}

}  // namespace
}  // namespace skein
