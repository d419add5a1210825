#include "idl/bus/peer_info.hpp"

#include <gtest/gtest.h>

namespace skein::bus {
namespace {

const PeerInfo kGoose{Role::Agent, "geese_1", 3, 0xffffffffffffffffULL, 1, 1700000000000000000};

TEST(PeerInfo, GoesThroughText) {
  EXPECT_EQ(to_text(kGoose),
            "skein role=agent swarm=geese_1 id=3 nonce=18446744073709551615 wire=1 start=1700000000000000000");
  EXPECT_EQ(peer_info_from(to_text(kGoose)), kGoose);
}

TEST(PeerInfo, SaysHowManyAgentsShareTheProcessIfNotOne) {
  PeerInfo group = kGoose;
  group.members = 8;
  EXPECT_EQ(to_text(group), to_text(kGoose) + " members=8");
  EXPECT_EQ(peer_info_from(to_text(group)), group);
  EXPECT_EQ(peer_info_from(to_text(kGoose) + " members=0"), std::nullopt);
  EXPECT_EQ(peer_info_from(to_text(kGoose) + " members=257"), std::nullopt);
}

TEST(PeerInfo, SaysWhichRunAWorldHas) {
  PeerInfo world = kGoose;
  world.run = 42;
  EXPECT_EQ(to_text(world), to_text(kGoose) + " run=42");
  EXPECT_EQ(peer_info_from(to_text(world)), world);
  EXPECT_EQ(peer_info_from(to_text(kGoose) + " run=x"), std::nullopt);
}

TEST(PeerInfo, SaysHowOftenTheProcessMadeItsParticipantAnew) {
  PeerInfo renewed = kGoose;
  renewed.renewals = 2;
  EXPECT_EQ(to_text(renewed), to_text(kGoose) + " renewals=2");
  EXPECT_EQ(peer_info_from(to_text(renewed)), renewed);
  EXPECT_EQ(peer_info_from(to_text(kGoose) + " renewals=-1"), std::nullopt);
}

TEST(PeerInfo, SkipsWordsThatALaterVersionMayAdd) {
  EXPECT_EQ(peer_info_from(to_text(kGoose) + " colour=grey extra"), kGoose);
}

TEST(PeerInfo, IsNothingForOthersUserData) {
  EXPECT_EQ(peer_info_from(""), std::nullopt);
  EXPECT_EQ(peer_info_from("enclave=/;"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein role=agent swarm=a id=3 nonce=4 wire=1"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein role=pilot swarm=a id=3 nonce=4 wire=1 start=5"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein role=agent swarm=a id=-3 nonce=4 wire=1 start=5"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein role=agent swarm=a id=3x nonce=4 wire=1 start=5"), std::nullopt);
  EXPECT_EQ(peer_info_from("skein role=agent swarm=a id=3 nonce=99999999999999999999 wire=1 start=5"), std::nullopt);
}

}  // namespace
}  // namespace skein::bus
