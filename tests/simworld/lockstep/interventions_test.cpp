// What holds a tick, and what lets it go.
#include "simworld/lockstep/interventions.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/stage.hpp"

namespace skein {
namespace {

constexpr Moment kMoment{Phase::Planning, 5};
const std::vector<RosterEntry> kBack{{2, 2, 555, false, false}};

Fault fault(FaultKind kind) {
  return {kind, 2, kMoment.phase, kMoment.number};
}

/// Interventions whose agents are live or not, as the test says.
struct Played {
  explicit Played(std::vector<Fault> faults, std::vector<RosterChange> replay = {})
      : interventions(std::move(faults), std::move(replay), &control) {}
  bool act() {
    return interventions.carry_out(
        kMoment, [this](AgentId) { return live; }, 0.0);
  }

  bool live = true;
  test::FakeControl control;
  Interventions interventions;
};

TEST(Interventions, AKillHoldsUntilTheProcessIsGone) {
  Played played({fault(FaultKind::Kill)});
  EXPECT_TRUE(played.act());
  EXPECT_EQ(played.control.killed, (std::vector<AgentId>{2}));
  EXPECT_TRUE(played.interventions.holds({}));
  EXPECT_FALSE(played.interventions.awaits_return());
  played.interventions.process_ended(2);
  EXPECT_FALSE(played.interventions.holds({}));
  EXPECT_TRUE(played.interventions.unused_faults().empty());
}

TEST(Interventions, AStopHoldsUntilTheProcessIsStopped) {
  Played played({fault(FaultKind::Stop)});
  EXPECT_TRUE(played.act());
  EXPECT_TRUE(played.interventions.holds({}));
  played.interventions.process_stopped(2);
  EXPECT_FALSE(played.interventions.holds({}));
  EXPECT_TRUE(played.interventions.is_stopped(2));
}

TEST(Interventions, AContHoldsUntilADroppedAgentIsBack) {
  Played played({fault(FaultKind::Cont)});
  played.interventions.process_stopped(2);
  played.live = false;
  EXPECT_TRUE(played.act());
  EXPECT_EQ(played.control.continued, (std::vector<AgentId>{2}));
  EXPECT_FALSE(played.interventions.is_stopped(2));
  EXPECT_TRUE(played.interventions.holds({}));
  EXPECT_TRUE(played.interventions.awaits_return());
  EXPECT_FALSE(played.interventions.holds(kBack));
}

TEST(Interventions, AContOfALiveAgentHoldsNothing) {
  Played played({fault(FaultKind::Cont)});
  EXPECT_TRUE(played.act());
  EXPECT_FALSE(played.interventions.holds({}));
}

TEST(Interventions, ARestartHoldsUntilTheOldIsGoneAndTheNewIsBack) {
  Played played({fault(FaultKind::Restart)});
  EXPECT_TRUE(played.act());
  EXPECT_EQ(played.control.restarted, (std::vector<AgentId>{2}));
  EXPECT_TRUE(played.interventions.holds(kBack)) << "the old one is still there";
  played.interventions.process_ended(2);
  EXPECT_TRUE(played.interventions.holds({}));
  EXPECT_FALSE(played.interventions.holds(kBack));
}

TEST(Interventions, ARestartOfAnEndedProcessWaitsForTheNewOneAlone) {
  Played played({fault(FaultKind::Restart)});
  played.interventions.process_ended(2);
  EXPECT_TRUE(played.act());
  EXPECT_FALSE(played.interventions.holds(kBack));
}

TEST(Interventions, FaultsOnOneAgentTakePlaceOneAfterTheOther) {
  Played played({fault(FaultKind::Restart), fault(FaultKind::Kill)});
  EXPECT_TRUE(played.act());
  EXPECT_FALSE(played.act());
  EXPECT_TRUE(played.control.killed.empty());
  played.interventions.process_ended(2);
  EXPECT_FALSE(played.interventions.holds(kBack));
  EXPECT_TRUE(played.act());
  EXPECT_EQ(played.control.killed, (std::vector<AgentId>{2}));
}

TEST(Interventions, WhatCannotBeDoneToAnEndedProcessStaysUnused) {
  Played played({fault(FaultKind::Kill), fault(FaultKind::Stop), fault(FaultKind::Cont)});
  played.interventions.process_ended(2);
  EXPECT_FALSE(played.act());
  EXPECT_EQ(played.interventions.unused_faults().size(), 3U);
}

TEST(Interventions, AnotherMomentIsNotDue) {
  Played played({{FaultKind::Kill, 2, Phase::Planning, 6}, {FaultKind::Kill, 2, Phase::Flying, 5}});
  EXPECT_FALSE(played.act());
}

TEST(Interventions, AnEndBeforeTheReturnFails) {
  Played played({fault(FaultKind::Restart)});
  played.act();
  played.interventions.process_ended(2);
  played.interventions.process_ended(2);
  EXPECT_TRUE(played.interventions.holds(kBack));
  EXPECT_EQ(played.interventions.failure(0.0, 1.0, 1.0), "agent 2 ended before it was back");
}

TEST(Interventions, PatienceDependsOnWhatIsAwaited) {
  Played kill({fault(FaultKind::Kill)});
  kill.act();
  EXPECT_FALSE(kill.interventions.failure(9.0, 10.0, 30.0).has_value());
  EXPECT_EQ(kill.interventions.failure(11.0, 10.0, 30.0), "the fault on agent 2 took no effect within 10 s");
  Played restart({fault(FaultKind::Restart)});
  restart.act();
  EXPECT_FALSE(restart.interventions.failure(29.0, 10.0, 30.0).has_value());
  EXPECT_EQ(restart.interventions.failure(31.0, 10.0, 30.0), "the fault on agent 2 took no effect within 30 s");
}

TEST(Interventions, AReplayRepeatsLossesAndStartsReturns) {
  const RosterChange loss{0, 5, 2, 1, LossReason::Deadline};
  const RosterChange back{0, 7, 2, 2, LossReason::Rejoined};
  Played played({}, {loss, back});
  EXPECT_TRUE(played.interventions.repeat(4, test::roster_of(2), 0.0).empty());
  const auto losses = played.interventions.repeat(5, test::roster_of(2), 0.0);
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_EQ(losses[0].reason, LossReason::Deadline);
  played.interventions.end(2);
  EXPECT_EQ(played.control.killed, (std::vector<AgentId>{2}));
  played.interventions.process_ended(2);
  EXPECT_FALSE(played.interventions.may_return(2)) << "its return is not due";
  EXPECT_TRUE(played.interventions.repeat(7, test::roster_of(1), 0.0).empty());
  EXPECT_TRUE(played.interventions.may_return(2));
  EXPECT_TRUE(played.act());
  EXPECT_EQ(played.control.restarted, (std::vector<AgentId>{2}));
  EXPECT_FALSE(played.act());
  EXPECT_FALSE(played.interventions.holds(kBack));
  EXPECT_TRUE(played.interventions.unused_changes().empty());
}

TEST(Interventions, ALossOfAnotherIncarnationIsNotRepeated) {
  Played played({}, {{0, 5, 2, 3, LossReason::Left}});
  EXPECT_TRUE(played.interventions.repeat(5, test::roster_of(2), 0.0).empty());
  EXPECT_EQ(played.interventions.unused_changes().size(), 1U);
}

}  // namespace
}  // namespace skein
