#include "idl/bus/topics.hpp"

#include <gtest/gtest.h>

#include <bit>

namespace skein::bus {
namespace {

TEST(Topics, TheTableIsInOrderOfItsIds) {
  for (std::size_t i = 0; i < kTopics.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kTopics[i].id), i);
    EXPECT_TRUE(kTopics[i].name.starts_with("skein/")) << kTopics[i].name;
    EXPECT_TRUE(kTopics[i].type.starts_with("skein::v7::")) << kTopics[i].type;
    EXPECT_NE(kTopics[i].writers, 0);
    EXPECT_NE(kTopics[i].readers, 0);
  }
}

TEST(Topics, OnlyTheMissionIsLatched) {
  for (const TopicSpec& spec : kTopics) EXPECT_EQ(spec.latched, spec.id == TopicId::Mission);
}

TEST(Topics, TwoAgentsShareRepresentativeAndObstacleMapBothWays) {
  EXPECT_EQ(expected_matches(Role::Agent, Role::Agent),
            endpoint_bit(TopicId::Representative, true) | endpoint_bit(TopicId::Representative, false) |
                endpoint_bit(TopicId::ObstacleMap, true) | endpoint_bit(TopicId::ObstacleMap, false));
}

TEST(Topics, NobodyWaitsForAnOperator) {
  for (const Role role : {Role::Agent, Role::World}) {
    for (const Role peer : {Role::Agent, Role::World}) {
      const auto bits = expected_matches(role, peer);
      EXPECT_EQ(bits & endpoint_bit(TopicId::Command, false), 0);
      EXPECT_EQ(bits & endpoint_bit(TopicId::Inject, false), 0);
    }
  }
}

TEST(Topics, AgentAndWorldShareEightEndpointsSeenFromEitherSide) {
  const auto agent = expected_matches(Role::Agent, Role::World);
  const auto world = expected_matches(Role::World, Role::Agent);
  EXPECT_EQ(std::popcount(agent), 8);
  EXPECT_EQ(std::popcount(world), 8);
  EXPECT_EQ(agent, endpoint_bit(TopicId::Mission, false) | endpoint_bit(TopicId::Tick, false) |
                       endpoint_bit(TopicId::Sense, false) | endpoint_bit(TopicId::Beacon, true) |
                       endpoint_bit(TopicId::Representative, true) | endpoint_bit(TopicId::Representative, false) |
                       endpoint_bit(TopicId::ObstacleMap, true) | endpoint_bit(TopicId::ObstacleMap, false));
}

}  // namespace
}  // namespace skein::bus
