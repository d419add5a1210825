// The ports over DDS within one process, by UDP: discovery, routing, latching, order, instances, refusals.
#include "idl/bus/dds_port.hpp"

#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <set>

#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

using testing::AtAgent;
using testing::AtWorld;
using ::testing::ElementsAre;
using testing::eventually;
using ::testing::IsEmpty;

/// Ports of one process would otherwise call each other, and the network would not be tested.
class OverUdp : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  }
  DdsConfig config(AgentId id) const {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    DdsConfig c;
    c.domain = testing::kDomain;
    c.swarm = testing::unique_swarm(name);
    c.id = id;
    c.nonce = 1000 + id;
    c.start_stamp_ns = 500;
    return c;
  }
};

constexpr std::array<AgentId, 2> kTwo{1, 2};
constexpr AgentId kAgents = 14;  // more than the stock limit of 10 instances

TEST_F(OverUdp, MatchesBothWaysAndForgetsWhoLeaves) {
  DdsWorldPort world(config(0), kTwo);
  DdsAgentPort one(config(1));
  auto two = std::make_unique<DdsAgentPort>(config(2));
  const std::vector<int> fds{world.wake_fd(), one.wake_fd(), two->wake_fd()};
  EXPECT_TRUE(eventually(fds, [&] {
    return world.matched() == std::vector<std::uint64_t>{1001, 1002} &&
           one.matched() == std::vector<std::uint64_t>{1000, 1002} &&
           two->matched() == std::vector<std::uint64_t>{1000, 1001};
  }));
  two.reset();
  EXPECT_TRUE(eventually({world.wake_fd(), one.wake_fd()}, [&] {
    return world.matched() == std::vector<std::uint64_t>{1001} && one.matched() == std::vector<std::uint64_t>{1000};
  }));
}

TEST_F(OverUdp, AnAgentWithoutASenseTopicIsNeverMatchedByTheWorld) {
  DdsWorldPort world(config(0), kTwo);
  DdsAgentPort known(config(1));
  DdsAgentPort unknown(config(9));
  EXPECT_TRUE(eventually({known.wake_fd(), unknown.wake_fd(), world.wake_fd()}, [&] {
    return !world.matched().empty() && known.matched() == std::vector<std::uint64_t>{1000, 1009} &&
           unknown.matched() == std::vector<std::uint64_t>{1001};
  }));
  EXPECT_EQ(world.matched(), std::vector<std::uint64_t>{1001});
}

TEST_F(OverUdp, TheLargestMissionReachesALateJoiner) {
  Mission mission = examples::mission();
  mission.vehicles.clear();
  for (AgentId id = 1; id <= kMaxAgents; ++id) {
    mission.vehicles.push_back(examples::mission().vehicles[0]);
    mission.vehicles.back().id = id;
  }
  mission.zones.assign(wire::kMaxZones, examples::mission().zones[1]);
  DdsWorldPort world(config(0), kTwo);
  Mission before = mission;
  before.seed = 1;
  world.publish(to_wire(before, examples::kStamp));
  world.publish(to_wire(mission, examples::kStamp));
  DdsAgentPort late(config(1));
  AtAgent at{late};
  ASSERT_TRUE(eventually({late.wake_fd()}, [&] { return !at.all<wire::Mission>().empty(); }));
  ASSERT_EQ(at.all<wire::Mission>().size(), 1u);
  EXPECT_EQ(from_wire(at.all<wire::Mission>()[0], {}).value(), mission);
  EXPECT_TRUE(world.flush(std::chrono::seconds(10)));
}

TEST_F(OverUdp, SenseReachesItsAgentAloneAndTicksArriveInOrder) {
  DdsWorldPort world(config(0), kTwo);
  DdsAgentPort one(config(1));
  DdsAgentPort two(config(2));
  const std::vector<int> fds{one.wake_fd(), two.wake_fd()};
  ASSERT_TRUE(eventually(fds, [&] { return one.matched().size() == 2 && two.matched().size() == 2; }));
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().size() == 2; }));
  AtAgent at_one{one};
  AtAgent at_two{two};
  world.publish(testing::sense(2));
  for (std::uint32_t round = 1; round <= 300; ++round) {
    world.publish(testing::tick(round));
    ASSERT_TRUE(eventually(fds, [&] {
      return at_one.all<wire::Tick>().size() == round && at_two.all<wire::Tick>().size() == round;
    })) << round;
  }
  const auto ticks = at_one.all<wire::Tick>();
  for (std::uint32_t round = 1; round <= 300; ++round) EXPECT_EQ(ticks[round - 1].round(), round);
  ASSERT_TRUE(eventually(fds, [&] { return at_two.all<wire::Sense>().size() == 1; }));
  EXPECT_THAT(at_one.all<wire::Sense>(), IsEmpty());
  EXPECT_EQ(world.lost() + one.lost() + two.lost(), 0u);
}

TEST_F(OverUdp, AllInstancesOfFourteenAgentsArrive) {
  std::vector<AgentId> ids;
  for (AgentId id = 1; id <= kAgents; ++id) ids.push_back(id);
  DdsWorldPort world(config(0), ids);
  std::vector<std::unique_ptr<DdsAgentPort>> agents;
  for (const AgentId id : ids) agents.push_back(std::make_unique<DdsAgentPort>(config(id)));
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] {
    return world.matched().size() == kAgents &&
           std::ranges::all_of(agents, [](const auto& agent) { return agent->matched().size() == kAgents; });
  }));
  for (const AgentId id : ids) {
    agents[id - 1]->publish(testing::representative(id));
    agents[id - 1]->publish(testing::beacon(id, 1));
  }
  AtWorld at_world{world};
  AtAgent at_last{*agents.back()};
  EXPECT_TRUE(eventually({world.wake_fd(), agents.back()->wake_fd()}, [&] {
    return at_world.all<wire::Beacon>().size() == kAgents && at_world.all<wire::Representative>().size() == kAgents &&
           at_last.all<wire::Representative>().size() == kAgents - 1;
  }));
  // the world repeats each agent's sample under its key
  for (const AgentId id : ids) world.publish(testing::representative(id));
  EXPECT_TRUE(eventually({agents.back()->wake_fd()},
                         [&] { return at_last.all<wire::Representative>().size() == 2 * kAgents - 1; }));
  std::set<AgentId> heard;
  for (const auto& sample : at_last.all<wire::Representative>()) heard.insert(sample.agent());
  EXPECT_EQ(heard.size(), kAgents);
}

TEST_F(OverUdp, SwarmsOfOneDomainDoNotHearEachOther) {
  DdsConfig other = config(0);
  other.swarm += "-other";
  DdsWorldPort world(config(0), kTwo);
  DdsWorldPort stranger(other, kTwo);
  DdsAgentPort one(config(1));
  AtAgent at{one};
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().size() == 1; }));
  stranger.publish(testing::tick(99));
  world.publish(testing::tick(1));
  ASSERT_TRUE(eventually({one.wake_fd()}, [&] { return !at.all<wire::Tick>().empty(); }));
  EXPECT_TRUE(stranger.flush(std::chrono::seconds(10)));
  EXPECT_EQ(at.all<wire::Tick>()[0].round(), 1u);
  EXPECT_THAT(stranger.matched(), IsEmpty());
  EXPECT_EQ(world.conflict(), std::nullopt);
}

TEST_F(OverUdp, TheLaterOfTwoWorldsIsInConflict) {
  DdsConfig second = config(0);
  second.nonce = 7;
  second.start_stamp_ns = 501;
  DdsWorldPort earlier(config(0), kTwo);
  DdsWorldPort later(second, kTwo);
  EXPECT_TRUE(eventually({later.wake_fd()}, [&] { return later.conflict().has_value(); }));
  EXPECT_THAT(later.conflict().value_or(""), ::testing::HasSubstr("already has a world"));
  EXPECT_EQ(earlier.conflict(), std::nullopt);
}

TEST_F(OverUdp, AnAgentNamesAWorldOfAnotherWireVersion) {
  DdsConfig newer = config(0);
  newer.wire_version = wire::kWireVersion + 1;
  DdsWorldPort world(newer, kTwo);
  DdsAgentPort one(config(1));
  EXPECT_TRUE(eventually({one.wake_fd()}, [&] { return one.conflict().has_value(); }));
  EXPECT_THAT(one.conflict().value_or(""),
              ::testing::HasSubstr("wire version " + std::to_string(wire::kWireVersion + 1)));
}

TEST_F(OverUdp, RefusesConfigurationsOutOfRange) {
  DdsConfig wild = config(1);
  wild.swarm = "*";
  EXPECT_THROW(DdsAgentPort{wild}, std::invalid_argument);
  DdsConfig far = config(1);
  far.domain = 233;
  EXPECT_THROW(DdsAgentPort{far}, std::invalid_argument);
  EXPECT_NO_THROW(DdsAgentPort{config(0)}) << "one that asks for an id";
  EXPECT_THROW(DdsAgentPort{config(kMaxAgents + 1)}, std::invalid_argument);
  constexpr std::array<AgentId, 2> kTwice{1, 1};
  EXPECT_THROW((DdsWorldPort{config(0), kTwice}), std::invalid_argument);
}

TEST_F(OverUdp, HasNothingInSharedMemory) {
  const auto in_shared_memory = [] {
    std::string lines;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
      if (line.find("/dev/shm/") != std::string::npos) lines += line + "\n";
    }
    return lines;
  };
  DdsWorldPort world(config(0), kTwo);
  DdsAgentPort one(config(1));
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().size() == 1; }));
  EXPECT_EQ(in_shared_memory(), "");
  DdsConfig shared = config(2);
  shared.profile = Profile::Shm;
  const DdsAgentPort two(shared);
  EXPECT_NE(in_shared_memory(), "") << "the check sees what the shm profile maps";
}

}  // namespace
}  // namespace skein::bus
