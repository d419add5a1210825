#include "idl/bus/peer_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

/// Matches all endpoints that the roles have in common but those in `missing`.
void match(PeerBook& book, const ProcessKey& process, Role peer, std::uint16_t missing = 0) {
  for (unsigned bit = 0; bit < 16; ++bit) {
    const auto endpoint = static_cast<std::uint16_t>(1U << bit);
    if ((expected_matches(book.own().role, peer) & endpoint & ~missing) != 0) book.matched(process, endpoint, true);
  }
}

TEST(PeerBook, CountsAProcessOnceItIsKnownAndAllItsEndpointsAreMatched) {
  PeerBook book(info(Role::Agent, 5));
  const auto sense = endpoint_bit(TopicId::Sense, false);
  match(book, kFirst, Role::World, sense);
  EXPECT_THAT(book.matched_nonces(), IsEmpty());
  book.discovered(kFirst, info(Role::World, 9));
  EXPECT_THAT(book.matched_nonces(), IsEmpty());
  book.matched(kFirst, sense, true);
  EXPECT_THAT(book.matched_nonces(), ElementsAre(9));
  match(book, kSecond, Role::Agent);
  book.discovered(kSecond, info(Role::Agent, 7));
  EXPECT_THAT(book.matched_nonces(), ElementsAre(7, 9));
  book.matched(kFirst, sense, false);
  EXPECT_THAT(book.matched_nonces(), ElementsAre(7));
  book.gone(kSecond);
  EXPECT_THAT(book.matched_nonces(), IsEmpty());
}

TEST(PeerBook, AGroupIsMatchedOnceEachOfItsAgentsHasItsSenseTopic) {
  PeerInfo three = info(Role::Agent, 50);
  three.members = 3;
  const auto world_sense = endpoint_bit(TopicId::Sense, true);
  PeerBook world(info(Role::World, 9));
  world.discovered(kFirst, three);
  match(world, kFirst, Role::Agent);
  world.matched(kFirst, world_sense, true);
  EXPECT_THAT(world.matched_nonces(), IsEmpty());
  world.matched(kFirst, world_sense, true);
  EXPECT_THAT(world.matched_nonces(), ElementsAre(50, 51, 52));
  const auto group_sense = endpoint_bit(TopicId::Sense, false);
  PeerBook group(three);
  group.discovered(kFirst, info(Role::World, 9));
  group.discovered(kSecond, three);
  match(group, kFirst, Role::World);
  match(group, kSecond, Role::Agent);
  group.matched(kFirst, group_sense, true);
  EXPECT_THAT(group.matched_nonces(), ElementsAre(50, 51, 52));
  group.matched(kFirst, group_sense, true);
  EXPECT_THAT(group.matched_nonces(), ElementsAre(9, 50, 51, 52));
  group.matched(kFirst, group_sense, false);
  EXPECT_THAT(group.matched_nonces(), ElementsAre(50, 51, 52));
}

TEST(PeerBook, ANoticeAfterTheEndBringsNobodyBack) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  match(book, kFirst, Role::Agent);
  book.gone(kFirst);
  book.matched(kFirst, endpoint_bit(TopicId::Tick, true), false);
  EXPECT_THAT(book.matched_nonces(), IsEmpty());
}

TEST(PeerBook, ObserversAndOtherWorldsAreNotCounted) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, std::nullopt);
  book.discovered(kSecond, info(Role::World, 9, 1));
  match(book, kFirst, Role::Agent);
  match(book, kSecond, Role::Agent);
  EXPECT_THAT(book.matched_nonces(), IsEmpty());
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

TEST(PeerBook, AWorldOfAnotherSwarmOrAnAgentOfAnotherVersionIsNoConflict) {
  PeerBook book(info(Role::Agent, 5));
  PeerInfo stranger = info(Role::World, 9);
  stranger.wire_version = 2;
  stranger.swarm = "ducks";
  book.discovered(kFirst, stranger);
  PeerInfo newer = info(Role::Agent, 8);
  newer.wire_version = 2;
  book.discovered(kSecond, newer);
  EXPECT_EQ(book.conflict(), std::nullopt);
  stranger.swarm = "geese";
  book.discovered(kFirst, stranger);
  EXPECT_THAT(book.conflict().value_or(""), HasSubstr("wire version 2"));
}

}  // namespace
}  // namespace skein::bus
