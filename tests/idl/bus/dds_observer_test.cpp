// Who has no part in a run reads what it asks for, and nobody counts on it.
#include "idl/bus/dds_observer_port.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

using testing::eventually;
using AtObserver = testing::Collected<DdsObserverPort, ObserverInbound>;
using Nonces = std::vector<std::uint64_t>;

DdsConfig config(AgentId id, std::uint64_t nonce) {
  DdsConfig c;
  c.domain = 23;
  c.swarm = testing::unique_swarm(::testing::UnitTest::GetInstance()->current_test_info()->name());
  c.id = id;
  c.nonce = nonce;
  return c;
}

TopicEndpoints of(const DdsObserverPort& port, TopicId topic) {
  return port.endpoints()[static_cast<std::size_t>(topic)];
}

TEST(DdsObserverPort, ReadsWhatAgentsShareIfItAsksForIt) {
  constexpr std::array<AgentId, 1> kOne{1};
  DdsWorldPort world(config(0, 1000), kOne);
  world.publish(to_wire(examples::mission(), examples::kStamp));
  DdsAgentPort agent(config(1, 1100));
  DdsObserverPort everything(config(0, 1200), Observed::Shared);
  DdsObserverPort progress(config(0, 1300));
  AtObserver at_everything{everything};
  AtObserver at_progress{progress};
  ASSERT_TRUE(eventually({world.wake_fd(), agent.wake_fd(), everything.wake_fd(), progress.wake_fd()}, [&] {
    return world.matched() == Nonces{1100} && agent.matched() == Nonces{1000} && world.observed() &&
           at_everything.all<wire::Mission>().size() == 1 && at_progress.all<wire::Mission>().size() == 1;
  }));
  std::uint32_t round = 0;  // best effort: what comes before it is matched is lost
  EXPECT_TRUE(eventually({everything.wake_fd(), progress.wake_fd()}, [&] {
    world.publish(testing::tick(++round));
    agent.publish(testing::representative(1));
    agent.publish(testing::obstacle_map(1));
    agent.publish(testing::beacon(1, round));
    return !at_everything.all<wire::Tick>().empty() && !at_everything.all<wire::Beacon>().empty() &&
           !at_everything.all<wire::Representative>().empty() && !at_everything.all<wire::ObstacleMap>().empty() &&
           !at_progress.all<wire::Tick>().empty() && !at_progress.all<wire::Beacon>().empty();
  }));
  EXPECT_TRUE(at_progress.all<wire::Representative>().empty());
  EXPECT_TRUE(at_progress.all<wire::ObstacleMap>().empty());
  EXPECT_EQ(everything.lost(), 0U);
}

TEST(DdsObserverPort, CountsWhoWritesAndReads) {
  constexpr std::array<AgentId, 2> kTwo{1, 2};
  DdsObserverPort observer(config(0, 1200), Observed::Shared);
  EXPECT_EQ(of(observer, TopicId::Beacon).writers, 0U);
  DdsWorldPort world(config(0, 1000), kTwo);
  DdsAgentPort one(config(1, 1100));
  {
    DdsAgentPort two(config(2, 1101));
    EXPECT_TRUE(eventually({observer.wake_fd()}, [&] {
      return of(observer, TopicId::Beacon).writers == 2 && of(observer, TopicId::Beacon).readers == 1 &&
             of(observer, TopicId::Tick).writers == 1 && of(observer, TopicId::Tick).readers == 2 &&
             of(observer, TopicId::Sense).writers == 2 && of(observer, TopicId::Sense).readers == 2 &&
             of(observer, TopicId::Representative).writers == 3 && of(observer, TopicId::Mission).writers == 1;
    }));
  }
  EXPECT_TRUE(eventually({observer.wake_fd()}, [&] { return of(observer, TopicId::Beacon).writers == 1; }));
}

TEST(DdsObserverPort, SaysWhyNothingCanBeRead) {
  constexpr std::array<AgentId, 1> kOne{1};
  const DdsObserverPort observer(config(0, 1200));
  EXPECT_FALSE(observer.conflict());
  DdsConfig newer = config(0, 1000);
  ++newer.wire_version;
  const DdsWorldPort world(newer, kOne);
  EXPECT_TRUE(eventually({observer.wake_fd()}, [&] { return observer.conflict().has_value(); }));
}

}  // namespace
}  // namespace skein::bus
