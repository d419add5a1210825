// Several agents of one process over one participant: matching, routing, and no missed wake-up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "idl/bus/dds_port.hpp"
#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

using testing::AtAgent;
using testing::AtWorld;
using ::testing::ElementsAre;
using testing::eventually;
using Nonces = std::vector<std::uint64_t>;

constexpr std::array<AgentId, 3> kThree{1, 2, 4};
constexpr std::array<AgentId, 2> kPair{2, 4};

DdsConfig config(AgentId id, std::uint64_t nonce) {
  DdsConfig c;
  c.domain = testing::kDomain + 2;
  c.swarm = testing::unique_swarm(::testing::UnitTest::GetInstance()->current_test_info()->name());
  c.id = id;
  c.nonce = nonce;
  return c;
}

/// What one port of a group has taken so far.
struct AtPort {
  AgentPort& port;
  std::vector<AgentInbound> samples{};

  template <typename Sample>
  std::vector<Sample> all() {
    port.take(samples);
    std::vector<Sample> found;
    for (const AgentInbound& sample : samples) {
      if (const auto* held = std::get_if<Sample>(&sample)) found.push_back(*held);
    }
    return found;
  }
};

TEST(DdsAgentGroup, AllItsAgentsMatchAndAreMatched) {
  DdsWorldPort world(config(0, 1000), kThree);
  DdsAgentPort one(config(1, 1100));
  DdsAgentGroup group(config(2, 1200), kPair);
  EXPECT_TRUE(eventually({world.wake_fd(), one.wake_fd(), group.wake_fd()}, [&] {
    return world.matched() == Nonces{1100, 1200, 1201} && one.matched() == Nonces{1000, 1200, 1201} &&
           group.port(0).matched() == Nonces{1000, 1100, 1201} && group.port(1).matched() == Nonces{1000, 1100, 1200};
  }));
}

TEST(DdsAgentGroup, IsNotMatchedWithAWorldThatLacksOneOfItsAgents) {
  constexpr std::array<AgentId, 2> kWithoutFour{1, 2};
  DdsWorldPort world(config(0, 1000), kWithoutFour);
  DdsAgentPort one(config(1, 1100));
  DdsAgentGroup group(config(2, 1200), kPair);
  EXPECT_TRUE(eventually({world.wake_fd(), one.wake_fd(), group.wake_fd()}, [&] {
    return world.matched() == Nonces{1100} && one.matched() == Nonces{1000, 1200, 1201} &&
           group.port(0).matched() == Nonces{1100, 1201};
  }));
}

TEST(DdsAgentGroup, HandsEverySampleToThoseWhoseItIs) {
  DdsWorldPort world(config(0, 1000), kThree);
  world.publish(to_wire(examples::mission(), examples::kStamp));
  DdsAgentPort one(config(1, 1100));
  DdsAgentGroup group(config(2, 1200), kPair);
  ASSERT_TRUE(eventually({world.wake_fd(), one.wake_fd(), group.wake_fd()}, [&] {
    return world.matched().size() == 3 && one.matched().size() == 3 && group.port(0).matched().size() == 3;
  }));
  AtPort two{group.port(0)};
  AtPort four{group.port(1)};
  AtAgent at_one{one};
  AtWorld at_world{world};
  for (const AgentId id : kThree) world.publish(testing::sense(id));
  world.publish(testing::tick(1));
  one.publish(testing::representative(1));
  group.port(0).publish(testing::representative(2));
  one.publish(testing::obstacle_map(1));
  group.port(1).publish(testing::obstacle_map(4));
  world.publish(testing::obstacle_map(9));  // what the world repeats
  group.port(0).publish(testing::beacon(2, 1));
  group.port(1).publish(testing::beacon(4, 1));
  EXPECT_EQ(four.all<wire::Representative>().size(), 1U) << "without the network";
  EXPECT_TRUE(eventually({world.wake_fd(), one.wake_fd(), group.wake_fd()}, [&] {
    group.receive();
    return two.all<wire::Mission>().size() == 1 && four.all<wire::Mission>().size() == 1 &&
           two.all<wire::Tick>().size() == 1 && four.all<wire::Tick>().size() == 1 &&
           two.all<wire::Sense>().size() == 1 && four.all<wire::Sense>().size() == 1 &&
           two.all<wire::Representative>().size() == 1 && four.all<wire::Representative>().size() == 2 &&
           at_one.all<wire::Representative>().size() == 1 && at_world.all<wire::Representative>().size() == 2 &&
           two.all<wire::ObstacleMap>().size() == 3 && four.all<wire::ObstacleMap>().size() == 2 &&
           at_one.all<wire::ObstacleMap>().size() == 2 && at_world.all<wire::ObstacleMap>().size() == 2 &&
           at_world.all<wire::Beacon>().size() == 2;
  }));
  EXPECT_EQ(two.all<wire::Sense>()[0].agent(), 2U);
  EXPECT_EQ(four.all<wire::Sense>()[0].agent(), 4U);
  EXPECT_EQ(two.all<wire::Representative>()[0].agent(), 1U) << "nobody hears itself";
  EXPECT_EQ(group.lost(), 0U);
  EXPECT_TRUE(group.flush(std::chrono::seconds(10)));
}

TEST(DdsAgentGroup, WakesForTheAgentThatLacksTheFewestAndAlwaysForATick) {
  DdsWorldPort world(config(0, 1000), kThree);
  DdsAgentPort one(config(1, 1100));
  DdsAgentGroup group(config(2, 1200), kPair);
  ASSERT_TRUE(eventually({world.wake_fd(), one.wake_fd(), group.wake_fd()}, [&] {
    return world.matched().size() == 3 && one.matched().size() == 3 && group.port(0).matched().size() == 3;
  }));
  const auto readable = [&] {
    pollfd polled{group.wake_fd(), POLLIN, 0};
    return ::poll(&polled, 1, 0) == 1;
  };
  group.port(0).wake_after(kOnTick);
  group.port(1).wake_after(kOnTick);
  group.receive();
  one.publish(testing::representative(1));
  ASSERT_TRUE(one.flush(std::chrono::seconds(10)));
  EXPECT_FALSE(readable());
  group.port(0).publish(testing::representative(2));
  EXPECT_FALSE(readable()) << "nor for a representative of its own process";
  group.port(1).wake_after(1);
  EXPECT_TRUE(readable()) << "it is there already";
  group.port(1).wake_after(kOnTick);
  group.receive();
  EXPECT_FALSE(readable());
  world.publish(testing::tick(1));
  EXPECT_TRUE(eventually({group.wake_fd()}, readable));
}

TEST(DdsAgentGroup, RefusesListsThatAreEmptyUnorderedOrOutOfRange) {
  const auto make = [](std::vector<AgentId> ids) { const DdsAgentGroup group(config(1, 5), ids); };
  EXPECT_THROW(make({}), std::invalid_argument);
  EXPECT_THROW(make({2, 1}), std::invalid_argument);
  EXPECT_THROW(make({1, 1}), std::invalid_argument);
  EXPECT_THROW(make({0, 1}), std::invalid_argument);
  EXPECT_THROW(make({1, kMaxAgents + 1}), std::invalid_argument);
}

}  // namespace
}  // namespace skein::bus
