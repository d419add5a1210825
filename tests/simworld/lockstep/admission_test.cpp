// Who may take part, introduction by introduction.
#include "simworld/lockstep/admission.hpp"

#include <gtest/gtest.h>

#include "tests/simworld/lockstep/samples.hpp"

namespace skein {
namespace {

using test::introduction;
using test::nonce_of;

constexpr double kSilence_s = 10.0;
const std::vector<std::uint64_t> kAll{test::kWorldNonce, nonce_of(1), nonce_of(2)};
const std::vector<std::uint64_t> kAgents{nonce_of(1), nonce_of(2)};

Admission two() {
  return {test::kRun, test::kWorldNonce, {1, 2}, kSilence_s};
}

TEST(Admission, StartsWhenAllAreMatchedBothWays) {
  Admission admission = two();
  EXPECT_EQ(admission.missing(kAgents), (std::vector<AgentId>{1, 2}));
  admission.introduce(introduction(2, {nonce_of(1), test::kWorldNonce}), 0.0);  // in any order
  EXPECT_EQ(admission.introduced(), 1U);
  EXPECT_FALSE(admission.roster(kAgents).has_value());
  admission.introduce(introduction(1, {nonce_of(2), test::kWorldNonce}), 1.0);
  const auto roster = admission.roster(kAgents);
  ASSERT_TRUE(roster.has_value());
  EXPECT_EQ(*roster, test::roster_of(2));
  EXPECT_EQ(admission.matched(kAgents), 2U);
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Admission, OneSidedMatchesDoNotStart) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(2, {test::kWorldNonce}), 0.0);  // does not see agent 1 yet
  EXPECT_FALSE(admission.roster(kAgents).has_value());
  EXPECT_EQ(admission.missing(kAgents), (std::vector<AgentId>{1, 2}));
  admission.introduce(introduction(2, {nonce_of(1)}), 0.0);  // does not see the world
  EXPECT_FALSE(admission.roster(kAgents).has_value());
  EXPECT_EQ(admission.missing(kAgents), (std::vector<AgentId>{2}));
  admission.introduce(introduction(2, kAll), 0.0);
  EXPECT_FALSE(admission.roster(std::vector{nonce_of(1)}).has_value());  // the world does not see agent 2
  EXPECT_TRUE(admission.roster(kAgents).has_value());
}

TEST(Admission, WaitsUntilEverybodyHasTheMission) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  Beacon without = introduction(2, kAll);
  without.run = 0;
  admission.introduce(without, 0.0);
  EXPECT_EQ(admission.introduced(), 2U);
  EXPECT_FALSE(admission.roster(kAgents).has_value());
}

TEST(Admission, NamesWhatKeepsTheRunFromStarting) {
  Admission admission = two();
  EXPECT_EQ(admission.obstacles(kAgents), "agent 1 was not heard, agent 2 was not heard");
  EXPECT_FALSE(admission.lacks_mission());
  admission.introduce(introduction(1, {test::kWorldNonce}), 0.0);
  Beacon without = introduction(2, {nonce_of(1)});
  without.run = 0;
  admission.introduce(without, 0.0);
  EXPECT_TRUE(admission.lacks_mission());
  EXPECT_EQ(admission.obstacles(std::vector{nonce_of(2)}),
            "the world is not matched with agent 1, agent 1 is not matched with agent 2, agent 2 lacks the mission, "
            "agent 2 is not matched with the world");
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(2, kAll), 0.0);
  EXPECT_FALSE(admission.lacks_mission());
  EXPECT_EQ(admission.obstacles(kAgents), "");
}

TEST(Admission, NamesADozenObstaclesAtMost) {
  std::vector<AgentId> ids;
  for (AgentId id = 1; id <= 40; ++id) ids.push_back(id);
  const Admission admission(test::kRun, test::kWorldNonce, ids, kSilence_s);
  const std::string text = admission.obstacles({});
  EXPECT_NE(text.find("agent 12 was not heard, and 28 more"), std::string::npos) << text;
}

TEST(Admission, RefusesASecondProcessOnceTheHolderIsHeardAgain) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(1, kAll, 555), 1.0);
  EXPECT_TRUE(admission.take_refused().empty());  // the holder may be gone
  admission.introduce(introduction(1, kAll), 2.0);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{555, RefusalReason::IdInUse}}));
  EXPECT_TRUE(admission.take_refused().empty());
  admission.introduce(introduction(2, kAll), 2.0);
  EXPECT_EQ(admission.roster(kAgents)->front().nonce, nonce_of(1));
}

TEST(Admission, SilentHolderLosesItsId) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(1, {test::kWorldNonce, nonce_of(2), 555}, 555), 9.9);
  admission.introduce(introduction(1, {test::kWorldNonce, nonce_of(2), 555}, 555), 10.0);
  admission.introduce(introduction(2, {test::kWorldNonce, nonce_of(1), 555}), 10.0);
  const std::vector<std::uint64_t> seen{nonce_of(2), 555};
  const auto roster = admission.roster(seen);
  ASSERT_TRUE(roster.has_value());
  EXPECT_EQ(roster->front().nonce, 555U);
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Admission, ForgetsAProcessThatLeft) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.forget(nonce_of(1));
  EXPECT_EQ(admission.introduced(), 0U);
  admission.introduce(introduction(1, kAll, 555), 0.1);  // takes the id at once
  EXPECT_EQ(admission.introduced(), 1U);
  admission.introduce(introduction(1, kAll, 555), 0.2);
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Admission, RefusesUnknownIdsOnceEach) {
  Admission admission = two();
  admission.introduce(introduction(9, kAll), 0.0);
  admission.introduce(introduction(9, kAll), 0.0);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{nonce_of(9), RefusalReason::UnknownId}}));
  admission.introduce(introduction(9, kAll), 1.0);  // it did not hear: said again
  EXPECT_EQ(admission.take_refused().size(), 1U);
}

/// Both agents live.
Admission started() {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(2, kAll), 0.0);
  admission.close();
  return admission;
}

/// Agent 2's introduction after its loss, by a process that has heard the tick of round `round`.
Beacon again(std::uint64_t nonce, std::uint32_t round = 0) {
  Beacon beacon = introduction(2, {test::kWorldNonce, nonce_of(1)}, nonce);
  beacon.round = round;
  return beacon;
}

TEST(Admission, AfterTheStartALateCopyChangesNothing) {
  Admission admission = started();
  admission.introduce(introduction(1, {}), 0.1);
  EXPECT_TRUE(admission.take_refused().empty());
  EXPECT_EQ(admission.matched(kAgents), 2U);
  EXPECT_FALSE(admission.has_newcomers());
}

TEST(Admission, ALiveHolderKeepsItsIdByAnsweringALaterTick) {
  Admission admission = started();
  admission.introduce(introduction(1, kAll, 555), 99.0, 7);
  admission.answered(1, 7);  // may have been said before the newcomer came
  EXPECT_TRUE(admission.take_refused().empty());
  admission.introduce(introduction(1, kAll, 555), 99.2, 8);  // again: the first time counts
  admission.answered(2, 8);
  EXPECT_TRUE(admission.take_refused().empty());
  admission.answered(1, 8);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{555, RefusalReason::IdInUse}}));
  admission.answered(1, 9);
  EXPECT_TRUE(admission.take_refused().empty());
}

TEST(Admission, ANewProcessComesBackUnderTheNextIncarnation) {
  Admission admission = started();
  admission.lose(2, 5, false);
  admission.introduce(again(555), 1.0);
  EXPECT_TRUE(admission.has_newcomers());
  const std::vector<std::uint64_t> live{nonce_of(1)};
  EXPECT_TRUE(admission.returning(kAgents, live, 1.0).empty()) << "the world is not matched with it";
  const std::vector<std::uint64_t> seen{nonce_of(1), 555};
  ASSERT_EQ(admission.returning(seen, live, 1.0), (std::vector<RosterEntry>{{2, 2, 555, false, false}}));
  EXPECT_TRUE(admission.returning(seen, live, 2.1).empty()) << "not heard for over a second: it may be gone";
  admission.admit({2, 2, 555, false, false});
  EXPECT_FALSE(admission.has_newcomers());
  admission.lose(2, 9, false);
  admission.introduce(again(556), 3.0);
  EXPECT_EQ(admission.returning(std::vector<std::uint64_t>{556}, live, 3.0)[0].incarnation, 3U);
}

TEST(Admission, WhoComesBackIsMatchedWithAllLiveAgentsAndHasTheMission) {
  Admission admission = started();
  admission.lose(2, 5, false);
  const std::vector<std::uint64_t> seen{555};
  const std::vector<std::uint64_t> live{nonce_of(1)};
  Beacon lonely = again(555);
  lonely.matched = {test::kWorldNonce};
  admission.introduce(lonely, 1.0);
  EXPECT_TRUE(admission.returning(seen, live, 1.0).empty());
  EXPECT_EQ(admission.returning(seen, {}, 1.0).size(), 1U) << "nobody else is live";
  Beacon without = again(555);
  without.run = 0;
  admission.introduce(without, 1.0);
  EXPECT_TRUE(admission.returning(seen, live, 1.0).empty());
}

TEST(Admission, ADroppedProcessComesBackOnceItKnowsThatItIsDropped) {
  Admission admission = started();
  admission.lose(2, 5, true);
  admission.introduce(again(nonce_of(2), 4), 1.0);  // a late copy, from before
  EXPECT_FALSE(admission.has_newcomers());
  admission.introduce(again(nonce_of(2), 5), 1.0);
  EXPECT_TRUE(admission.has_newcomers());
}

TEST(Admission, ADeadProcessDoesNotComeBack) {
  Admission admission = started();
  admission.lose(2, 5, false);
  admission.introduce(again(nonce_of(2), 9), 1.0);
  EXPECT_FALSE(admission.has_newcomers());
}

TEST(Admission, ANewcomerThatEndsIsForgotten) {
  Admission admission = started();
  admission.lose(2, 5, false);
  admission.introduce(again(555), 1.0);
  admission.forget_newcomer(1);  // live: stays
  admission.forget_newcomer(2);
  EXPECT_FALSE(admission.has_newcomers());
  admission.introduce(again(556), 1.0);
  admission.forget(556);
  EXPECT_FALSE(admission.has_newcomers());
}

}  // namespace
}  // namespace skein
