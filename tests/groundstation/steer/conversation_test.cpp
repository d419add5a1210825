// Who steers reads best effort: whatever is missed of what is said of a command, the rest is enough, and nothing else
// is.
#include "groundstation/steer/conversation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/groundstation/watch/samples.hpp"

namespace skein {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using watch::at;
using watch::beacon_of;
using watch::tick_at;

constexpr std::uint64_t kId = 77;

/// The tick of the round in which a hold takes effect.
Tick taking_up(std::uint32_t round, std::uint64_t id = kId) {
  Tick tick = tick_at(round, Phase::Flying, round);
  tick.orders = {{id, kAllAgents, OrderKind::Hold, Vec3::Zero(), 0.0}};
  return tick;
}
Beacon acknowledging(AgentId agent, std::uint32_t round, std::uint64_t id = kId) {
  Beacon beacon = beacon_of(agent, round, AgentMode::Flying, round);
  beacon.acknowledged = {id};
  return beacon;
}
Tick answering(std::uint32_t round, OrderAnswer answer) {
  Tick tick = tick_at(round, Phase::Flying, round);
  tick.answers = {std::move(answer)};
  return tick;
}

TEST(Conversation, IsCompleteWhenAllWhoAreLiveHaveAcknowledged) {
  Conversation all(kId, kAllAgents, true);
  EXPECT_FALSE(all.run());
  all.take(at(tick_at(3, Phase::Flying, 3)));
  EXPECT_TRUE(all.run());
  EXPECT_FALSE(all.answer());
  EXPECT_FALSE(all.complete());
  all.take(at(taking_up(4)));
  EXPECT_TRUE(all.accepted());
  EXPECT_EQ(all.answer()->round, 4U);
  EXPECT_THAT(all.missing(), ElementsAre(1, 2));
  all.take(at(acknowledging(2, 4)));
  EXPECT_THAT(all.missing(), ElementsAre(1));
  EXPECT_FALSE(all.complete());
  all.take(at(acknowledging(1, 4)));
  EXPECT_TRUE(all.complete());
}

TEST(Conversation, TheAnswersAloneAreEnough) {
  Conversation all(kId, kAllAgents, true);
  all.take(at(answering(9, {kId, OrderResult::Accepted, 4, {1}, ""})));
  EXPECT_THAT(all.missing(), ElementsAre(2));
  all.take(at(answering(10, {kId, OrderResult::Accepted, 4, {1, 2}, ""})));
  EXPECT_TRUE(all.complete());
  EXPECT_EQ(all.answer()->round, 4U);
}

TEST(Conversation, WhoCameLaterIsNotConcerned) {
  Conversation all(kId, kAllAgents, true);
  Tick one = taking_up(4);
  one.roster.resize(1);
  all.take(at(one));
  all.take(at(tick_at(5, Phase::Flying, 5)));  // two are live now
  all.take(at(acknowledging(1, 4)));
  EXPECT_TRUE(all.complete());
}

TEST(Conversation, OneAgentIsConcernedAlone) {
  Conversation second(kId, 2, true);
  second.take(at(taking_up(4)));
  EXPECT_THAT(second.missing(), ElementsAre(2));
  second.take(at(acknowledging(1, 4)));
  EXPECT_FALSE(second.complete());
  second.take(at(acknowledging(2, 4)));
  EXPECT_TRUE(second.complete());
}

TEST(Conversation, ARefusalCompletesItAndNobodyIsWaitedFor) {
  Conversation all(kId, kAllAgents, true);
  all.take(at(answering(5, {kId, OrderResult::NotFlying, 0, {}, "the swarm is not in flight"})));
  EXPECT_TRUE(all.complete());
  EXPECT_FALSE(all.accepted());
  EXPECT_EQ(all.answer()->text, "the swarm is not in flight");
}

TEST(Conversation, AnInjectionIsTheWorldsAlone) {
  Conversation obstacle(kId, kAllAgents, false);
  obstacle.take(at(answering(5, {kId, OrderResult::Accepted, 5, {}, ""})));
  EXPECT_THAT(obstacle.missing(), IsEmpty());
  EXPECT_TRUE(obstacle.complete());
}

TEST(Conversation, OthersCommandsAreNotIts) {
  Conversation all(kId, kAllAgents, true);
  all.take(at(taking_up(4, kId + 1)));
  all.take(at(acknowledging(1, 4, kId + 1)));
  all.take(at(answering(5, {kId + 1, OrderResult::Refused, 0, {}, "no"})));
  EXPECT_FALSE(all.answer());
  EXPECT_THAT(all.acknowledged(), IsEmpty());
}

}  // namespace
}  // namespace skein
