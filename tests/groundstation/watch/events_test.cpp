#include "groundstation/watch/events.hpp"

#include <gtest/gtest.h>

#include "tests/groundstation/watch/samples.hpp"

namespace skein::watch {
namespace {

TEST(Events, APhaseIsToldOnce) {
  const Tick planning = tick_at(1, Phase::Planning);
  ASSERT_EQ(changes(nullptr, planning).size(), 1U);
  EXPECT_EQ(changes(nullptr, planning).front().what, "planning");
  EXPECT_TRUE(changes(&planning, tick_at(2, Phase::Planning)).empty());
  EXPECT_EQ(changes(&planning, tick_at(2, Phase::Flying)).front().kind, EventKind::Phase);
}

TEST(Events, WhoLeavesAndComesBackIsNamed) {
  const Tick both = tick_at(5, Phase::Flying, 4);
  Tick one = tick_at(6, Phase::Flying, 5);
  one.roster.pop_back();
  const auto lost = changes(&both, one);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost.front(), (Event{2.5, 5, 6, 2, EventKind::Roster, "lost", "incarnation_1_no_longer_live"}));
  Tick again = tick_at(7, Phase::Flying, 6);
  again.roster[1].incarnation = 2;
  const auto back = changes(&one, again);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back.front().what, "rejoined");
  EXPECT_EQ(back.front().reason, "incarnation_2");
}

TEST(Events, ARefusalIsToldOnceWithItsReason) {
  const Tick before = tick_at(1, Phase::Planning);
  Tick now = tick_at(2, Phase::Planning);
  now.refused = {{0xabc, RefusalReason::IdInUse}};
  const auto events = changes(&before, now);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.front().what, "nonce_0000000000000abc");
  EXPECT_EQ(events.front().reason, "id_in_use");
  EXPECT_TRUE(changes(&now, now).empty());
}

TEST(Events, ACommandIsTold) {
  const Tick before = tick_at(5, Phase::Flying, 4);
  Tick now = tick_at(6, Phase::Flying, 5);
  now.orders = {{7, 2, OrderKind::Goto, Vec3(1.0, -2.0, 3.0), 0.0}};
  const auto events = changes(&before, now);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].agent, 2U);
  EXPECT_EQ(events[0].kind, EventKind::Command);
  EXPECT_EQ(events[0].what, "goto");
  EXPECT_EQ(events[0].reason, "1.0 -2.0 3.0");
}

TEST(Events, AnInjectionIsToldByItsAnswer) {
  const Tick before = tick_at(5, Phase::Flying, 4);
  Tick now = tick_at(6, Phase::Flying, 5);
  now.answers = {{7, OrderResult::Accepted, 6, {}, ""}, {8, OrderResult::Refused, 0, {}, "no"}};
  ASSERT_EQ(changes(&before, now).size(), 1U);
  EXPECT_EQ(changes(&before, now)[0].what, "injection");
  now.orders = {{7, 2, OrderKind::Hold, Vec3::Zero(), 0.0}};
  EXPECT_EQ(changes(&before, now)[0].what, "hold");
  EXPECT_EQ(changes(&before, now).size(), 1U);
  Tick later = tick_at(7, Phase::Flying, 6);
  later.answers = now.answers;
  EXPECT_TRUE(changes(&now, later).empty());
}

TEST(Events, TheOutcomeHasItsReason) {
  const Tick before = tick_at(8, Phase::Flying, 7);
  Tick last = tick_at(9, Phase::Finished, 7);
  last.outcome = Outcome{4, "agent 2 was lost"};
  const auto events = changes(&before, last);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].what, "exit_4");
  EXPECT_EQ(events[1].reason, "agent 2 was lost");
}

TEST(Events, AFailedPlanNamesItsConstraintAndPeer) {
  const Beacon before = beacon_of(1, 3, AgentMode::Planning);
  Beacon now = beacon_of(1, 4, AgentMode::Failed);
  now.constraint = Constraint::Separation;
  now.constraint_peer = 2;
  const auto events = changes(&before, now, 0.0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.front().what, "failed");
  EXPECT_EQ(events.front().reason, "separation agent 2");
}

TEST(Events, TheMonitorsModeAndItsReasonAreTold) {
  const Beacon before = beacon_of(1, 3, AgentMode::Flying, 2);
  Beacon now = beacon_of(1, 4, AgentMode::Flying, 3);
  now.safety_mode = SafetyMode::Controlled;
  now.safety_reason = SafetyReason::Peer;
  EXPECT_EQ(changes(&before, now, 1.5).front(), (Event{1.5, 3, 4, 1, EventKind::Safety, "controlled", "peer"}));
  Beacon other = now;
  other.safety_reason = SafetyReason::Obstacle;
  EXPECT_EQ(changes(&now, other, 1.5).front().reason, "obstacle");
  EXPECT_EQ(changes(&now, before, 1.5).front().what, "autonomous");
}

TEST(Events, WhoIsFirstHeardInTroubleIsNews) {
  Beacon now = beacon_of(1, 4, AgentMode::Flying, 3);
  EXPECT_TRUE(changes(nullptr, now, 1.5).empty());
  now.safety_mode = SafetyMode::Hold;
  EXPECT_EQ(changes(nullptr, now, 1.5).size(), 1U);
}

}  // namespace
}  // namespace skein::watch
