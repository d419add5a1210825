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

TEST(Admission, ClosedTurnsNewcomersAwayButNotLateCopies) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.introduce(introduction(2, kAll), 0.0);
  admission.close();
  admission.introduce(introduction(1, {}), 0.1);
  EXPECT_TRUE(admission.take_refused().empty());
  EXPECT_EQ(admission.matched(kAgents), 2U);  // a late copy changes nothing
  admission.introduce(introduction(1, kAll, 555), 99.0);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{555, RefusalReason::IdInUse}}));
}

TEST(Admission, ClosedRefusesIdsThatNobodyHolds) {
  Admission admission = two();
  admission.introduce(introduction(1, kAll), 0.0);
  admission.close();
  admission.introduce(introduction(2, kAll), 0.0);
  EXPECT_EQ(admission.take_refused(), (std::vector<Refusal>{{nonce_of(2), RefusalReason::RunStarted}}));
}

}  // namespace
}  // namespace skein
