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

constexpr double kNow_s = 100.0;  ///< everything is found then

/// Finds all endpoints that the roles have in common, and matches all but those in `missing`.
void match(PeerBook& book, const ProcessKey& process, Role peer, std::uint16_t missing = 0) {
  for (unsigned bit = 0; bit < 16; ++bit) {
    const auto endpoint = static_cast<std::uint16_t>(1U << bit);
    if ((expected_matches(book.own().role, peer) & endpoint) == 0) continue;
    book.found(process, endpoint, true, kNow_s);
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
  book.found(kFirst, sense, false, kNow_s);
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
  book.found(kSecond, writer, true, kNow_s + 5.0);  // told again: as old as it was
  EXPECT_THAT(book.matched_nonces(kNow_s + kSettled_s), ElementsAre(7, 8));
  book.found(kSecond, writer, false, kNow_s + 5.0);
  EXPECT_THAT(book.matched_nonces(kNow_s + 10.0), ElementsAre(7));
}

TEST(PeerBook, AnEndpointThatIsNamedButNotThereDoesNotCount) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  for (unsigned bit = 0; bit < 16; ++bit) book.matched(kFirst, static_cast<std::uint16_t>(1U << bit));
  EXPECT_THAT(book.matched_nonces(kNow_s + 10.0), IsEmpty());
}

TEST(PeerBook, ANoticeAfterTheEndBringsNobodyBack) {
  PeerBook book(info(Role::World, 5));
  book.discovered(kFirst, info(Role::Agent, 7));
  match(book, kFirst, Role::Agent);
  book.gone(kFirst);
  book.found(kFirst, endpoint_bit(TopicId::Tick, true), false, kNow_s);
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
