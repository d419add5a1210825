#include "idl/bus/peer_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

namespace skein::bus {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr ProcessKey kFirst{1};
constexpr ProcessKey kSecond{2};

PeerInfo info(Role role, std::uint64_t nonce, std::int64_t start_stamp_ns = 0) {
  return {role, "geese", role == Role::Agent ? AgentId{1} : kWorldId, nonce, 1, start_stamp_ns};
}

constexpr double kNow_s = 100.0;  ///< everything is found then

/// One endpoint a kind: the entity is that of match().
void find(PeerBook& book, const ProcessKey& process, std::uint16_t endpoint, bool is_there, double now_s) {
  book.found(process, static_cast<EntityKey>(std::countr_zero(endpoint)), endpoint, is_there, now_s);
}

/// Finds all endpoints that the roles have in common, and matches all but those in `missing`.
void match(PeerBook& book, const ProcessKey& process, Role peer, std::uint16_t missing = 0) {
  for (unsigned bit = 0; bit < 2 * kTopics.size(); ++bit) {
    const auto endpoint = static_cast<std::uint16_t>(1U << bit);
    if ((expected_matches(book.own().role, peer) & endpoint) == 0) continue;
    book.found(process, bit, endpoint, true, kNow_s);
    if ((endpoint & missing) == 0) book.matched(process, endpoint);
  }
}

TEST(PeerBook, CountsAProcessOnceItIsKnownAndAllItsEndpointsAreMatched) {
  PeerBook book(info(Role::Agent, 5));
  const auto sense = endpoint_bit(TopicId::Sense, false);
  match(book, kFirst, Role::World, sense);
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
  book.discovered(kFirst, info(Role::World, 9));
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
  book.matched(kFirst, sense);
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(9));
  match(book, kSecond, Role::Agent);
  book.discovered(kSecond, info(Role::Agent, 7));
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7, 9));
  find(book, kFirst, sense, false, kNow_s);
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7));
  book.gone(kSecond);
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
}

// Two endpoints matched at the same moment in two threads of DDS: one is named twice, the other never.
TEST(PeerBook, AMatchThatIsNeverNamedCountsOnceItsEndpointHasBeenThereForAWhile) {
  PeerBook book(info(Role::Agent, 5));
  const auto writer = endpoint_bit(TopicId::Representative, true);
  book.discovered(kFirst, info(Role::Agent, 7));
  book.discovered(kSecond, info(Role::Agent, 8));
  match(book, kFirst, Role::Agent);
  match(book, kSecond, Role::Agent, writer);
  book.matched(kFirst, writer);
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7));
  EXPECT_THAT(book.matched_nonces(kNow_s + 0.99 * kSettled_s), ElementsAre(7));
  EXPECT_THAT(book.matched_nonces(kNow_s + kSettled_s), ElementsAre(7, 8));
  find(book, kSecond, writer, true, kNow_s + 5.0);  // told again: as old as it was
  EXPECT_THAT(book.matched_nonces(kNow_s + kSettled_s), ElementsAre(7, 8));
  find(book, kSecond, writer, false, kNow_s + 5.0);
  EXPECT_THAT(book.matched_nonces(kNow_s + 10.0), ElementsAre(7));
}

TEST(PeerBook, AnEndpointThatIsNamedButNotThereDoesNotCount) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  for (unsigned bit = 0; bit < 2 * kTopics.size(); ++bit) book.matched(kFirst, static_cast<std::uint16_t>(1U << bit));
  EXPECT_THAT(book.matched_nonces(kNow_s + 10.0), IsEmpty());
}

TEST(PeerBook, AGroupIsMatchedOnceEachOfItsAgentsHasItsSenseTopic) {
  PeerInfo three = info(Role::Agent, 50);
  three.members = 3;
  const auto world_sense = endpoint_bit(TopicId::Sense, true);
  PeerBook world(info(Role::World, 9));
  world.discovered(kFirst, three);
  match(world, kFirst, Role::Agent);
  world.matched(kFirst, world_sense);
  EXPECT_THAT(world.matched_nonces(kNow_s), IsEmpty());
  world.matched(kFirst, world_sense);
  EXPECT_THAT(world.matched_nonces(kNow_s), ElementsAre(50, 51, 52));
  const auto group_sense = endpoint_bit(TopicId::Sense, false);
  PeerBook group(three);
  group.discovered(kFirst, info(Role::World, 9));
  PeerInfo others = three;
  others.nonce = 60;
  group.discovered(kSecond, others);
  match(group, kFirst, Role::World);
  match(group, kSecond, Role::Agent);
  EXPECT_THAT(group.matched_nonces(kNow_s + 9.0), ElementsAre(60, 61, 62)) << "two writers of the world are missing";
  for (const EntityKey writer : {100U, 101U}) {
    group.found(kFirst, writer, group_sense, true, kNow_s);
    EXPECT_THAT(group.matched_nonces(kNow_s), ElementsAre(60, 61, 62));
    group.matched(kFirst, group_sense);
  }
  EXPECT_THAT(group.matched_nonces(kNow_s), ElementsAre(9, 60, 61, 62));
  group.found(kFirst, 101, group_sense, false, kNow_s);
  EXPECT_THAT(group.matched_nonces(kNow_s + 9.0), ElementsAre(60, 61, 62));
}

TEST(PeerBook, ANoticeAfterTheEndBringsNobodyBack) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  match(book, kFirst, Role::Agent);
  book.gone(kFirst);
  find(book, kFirst, endpoint_bit(TopicId::Tick, true), false, kNow_s);
  book.matched(kFirst, endpoint_bit(TopicId::Tick, true));
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
}

TEST(PeerBook, ObserversAndOtherWorldsAreNotCounted) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, std::nullopt);
  book.discovered(kSecond, info(Role::World, 9, 1));
  match(book, kFirst, Role::Agent);
  match(book, kSecond, Role::Agent);
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
}

TEST(PeerBook, OnlyTheLaterWorldIsInConflictAndTheHigherNonceIfAtTheSameTime) {
  PeerBook book(info(Role::World, 5, 100));
  book.discovered(kFirst, info(Role::World, 1, 101));
  book.discovered(kSecond, info(Role::World, 6, 100));
  EXPECT_EQ(book.conflict(), std::nullopt);
  book.discovered(kSecond, info(Role::World, 4, 100));
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("nonce 4"));
  book.gone(kSecond);
  EXPECT_EQ(book.conflict(), std::nullopt);
  book.discovered(kSecond, info(Role::World, 9, 99));
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("nonce 9"));
}

TEST(PeerBook, AWorldThatDiedIsNoConflictForTheOneThatGoesOnWithItsRun) {
  PeerInfo own = info(Role::World, 5, 100);
  own.run = 42;
  PeerBook book(own);
  PeerInfo dead = info(Role::World, 4, 99);
  dead.run = 42;
  book.discovered(kFirst, dead);
  EXPECT_EQ(book.conflict(), std::nullopt);
  dead.run = 43;
  book.discovered(kFirst, dead);
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("nonce 4"));
  PeerBook silent(info(Role::World, 5, 100));
  dead.run = 0;
  silent.discovered(kFirst, dead);
  EXPECT_THAT(silent.conflict().value_or(""), HasSubstr("nonce 4")) << "none says which run it has";
}

PeerInfo renewed(PeerInfo info, std::uint32_t renewals) {
  info.renewals = renewals;
  return info;
}

TEST(PeerBook, AProcessOfAnotherSwarmMayHaveTheSameNonce) {
  for (const bool other_first : {false, true}) {
    PeerBook book(info(Role::World, 5));
    PeerInfo other = info(Role::Agent, 7);
    other.swarm = "ducks";
    book.discovered(other_first ? kFirst : kSecond, other);
    book.discovered(other_first ? kSecond : kFirst, info(Role::Agent, 7));
    match(book, other_first ? kSecond : kFirst, Role::Agent);
    EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7));
  }
}

TEST(PeerBook, EndpointsOfAnotherSwarmAreNotCounted) {
  PeerBook book(info(Role::Observer, 5));
  PeerInfo other = info(Role::World, 7);
  other.swarm = "ducks";
  book.discovered(kFirst, other);
  match(book, kFirst, Role::World);
  EXPECT_THAT(book.endpoints(ProcessKey{3}), ::testing::Each(0U));
}

TEST(PeerBook, TheNewestParticipantOfAProcessIsTheProcess) {
  PeerBook book(info(Role::World, 5));
  const PeerInfo agent = info(Role::Agent, 7);
  book.discovered(kFirst, agent);
  match(book, kFirst, Role::Agent);
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7));
  book.discovered(kSecond, renewed(agent, 1));
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty()) << "the old one is matched, and dead";
  match(book, kSecond, Role::Agent);
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7)) << "once";
  book.discovered(kFirst, agent);  // a late copy
  book.gone(kFirst);               // its lease ends
  EXPECT_THAT(book.matched_nonces(kNow_s), ElementsAre(7));
  book.gone(kSecond);
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
}

TEST(PeerBook, WhoIsMadeAnewKnowsNobodyAndSaysSo) {
  PeerBook book(info(Role::Agent, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  match(book, kFirst, Role::Agent);
  book.renew();
  EXPECT_THAT(book.matched_nonces(kNow_s), IsEmpty());
  EXPECT_EQ(book.own(), renewed(info(Role::Agent, 5), 1));
}

TEST(PeerBook, AProcessesOwnOldParticipantIsNeitherAPeerNorAConflict) {
  PeerBook book(info(Role::World, 5, 100));
  book.renew();
  book.discovered(kFirst, info(Role::World, 5, 99));  // as a discovery server may still say
  EXPECT_EQ(book.conflict(), std::nullopt);
  PeerBook agent(info(Role::Agent, 7));
  agent.renew();
  agent.discovered(kFirst, info(Role::Agent, 7));
  match(agent, kFirst, Role::Agent);
  EXPECT_THAT(agent.matched_nonces(kNow_s), IsEmpty());
}

TEST(PeerBook, AnObserverIsInConflictWithAWorldOfAnotherVersion) {
  PeerBook book(info(Role::Observer, 5));
  PeerInfo world = info(Role::World, 9);
  book.discovered(kFirst, world);
  EXPECT_EQ(book.conflict(), std::nullopt);
  world.wire_version = 8;
  book.discovered(kFirst, world);
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("speaks wire version 8, this observer version 1"));
}

TEST(PeerBook, AWorldOfAnotherSwarmOrAnAgentOfAnotherVersionIsNoConflict) {
  PeerBook book(info(Role::Agent, 5));
  PeerInfo stranger = info(Role::World, 9);
  stranger.wire_version = 8;
  stranger.swarm = "ducks";
  book.discovered(kFirst, stranger);
  PeerInfo newer = info(Role::Agent, 8);
  newer.wire_version = 8;
  book.discovered(kSecond, newer);
  EXPECT_EQ(book.conflict(), std::nullopt);
  stranger.swarm = "geese";
  book.discovered(kFirst, stranger);
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("wire version 8"));
}

TEST(PeerBook, IsObservedByWhoReadsTicksWithoutAPartInTheRun) {
  PeerBook book(info(Role::World, 5));
  match(book, kFirst, Role::Agent);
  book.discovered(kFirst, info(Role::Agent, 7));
  EXPECT_FALSE(book.observed());
  book.discovered(kSecond, std::nullopt);
  find(book, kSecond, endpoint_bit(TopicId::Beacon, false), true, kNow_s);
  EXPECT_FALSE(book.observed());
  find(book, kSecond, endpoint_bit(TopicId::Tick, true), true, kNow_s);
  EXPECT_TRUE(book.observed());
  book.gone(kSecond);
  EXPECT_FALSE(book.observed());
}

TEST(PeerBook, CountsTheEndpointsOfAllOthers) {
  constexpr ProcessKey kOwn{3};
  PeerBook book(info(Role::Observer, 5));
  find(book, kOwn, endpoint_bit(TopicId::Beacon, true), true, kNow_s);
  const auto beacons = static_cast<std::size_t>(std::countr_zero(endpoint_bit(TopicId::Beacon, false)));
  EXPECT_EQ(book.endpoints(kOwn)[beacons], 0U);
  find(book, kFirst, endpoint_bit(TopicId::Beacon, false), true, kNow_s);
  find(book, kSecond, endpoint_bit(TopicId::Beacon, false), true, kNow_s);
  find(book, kSecond, endpoint_bit(TopicId::Beacon, true), true, kNow_s);
  EXPECT_EQ(book.endpoints(kOwn)[beacons], 2U);
  EXPECT_EQ(book.endpoints(kOwn)[beacons + 1], 1U);
  book.gone(kSecond);
  EXPECT_EQ(book.endpoints(kOwn)[beacons], 1U);
}

}  // namespace
}  // namespace skein::bus
