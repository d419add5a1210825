// A port whose participant is made anew: the same process to all others, with what had arrived, and what is latched.
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

#include "idl/bus/dds_observer_port.hpp"
#include "tests/idl/bus/waiting.hpp"

namespace skein::bus {
namespace {

using testing::AtAgent;
using testing::AtWorld;
using testing::eventually;

constexpr std::array<AgentId, 2> kTwo{1, 2};
constexpr std::uint32_t kDomain = 20;
using Nonces = std::vector<std::uint64_t>;

DdsConfig config(AgentId id) {
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  DdsConfig c;
  c.domain = kDomain;
  c.swarm = testing::unique_swarm(name);
  c.id = id;
  c.nonce = 1000 + id;
  c.start_stamp_ns = 500;
  c.run = id == kWorldId ? 77 : 0;
  return c;
}

/// A world and two agents, over UDP although they share a process.
class Renewal : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    eprosima::fastrtps::LibrarySettingsAttributes settings;
    settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
    eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
  }
  [[nodiscard]] bool all_matched() {
    return eventually({world.wake_fd(), one.wake_fd(), two.wake_fd()}, [&] {
      return world.matched() == Nonces{1001, 1002} && one.matched() == Nonces{1000, 1002} &&
             two.matched() == Nonces{1000, 1001};
    });
  }
  /// Everybody hears everybody: by what is published again and again until it is heard, as the lockstep does.
  [[nodiscard]] bool all_heard(std::uint32_t round) {
    AtWorld at_world{world};
    AtAgent at_one{one};
    AtAgent at_two{two};
    const auto heard = [&](auto& at) {
      return std::ranges::any_of(at.template all<wire::Tick>(), [&](const auto& t) { return t.round() == round; });
    };
    const auto answered = [&](AgentId id) {
      return std::ranges::any_of(at_world.all<wire::Beacon>(),
                                 [&](const auto& b) { return b.agent() == id && b.round() == round; });
    };
    return eventually({world.wake_fd(), one.wake_fd(), two.wake_fd()}, [&] {
      world.publish(testing::tick(round));
      one.publish(testing::beacon(1, round));
      two.publish(testing::beacon(2, round));
      return heard(at_one) && heard(at_two) && answered(1) && answered(2);
    });
  }

  DdsWorldPort world{config(0), kTwo};
  DdsAgentPort one{config(1)};
  DdsAgentPort two{config(2)};
};

TEST_F(Renewal, OfAnAgentMatchesItAgainWithEverybody) {
  ASSERT_TRUE(all_matched());
  ASSERT_TRUE(all_heard(1));
  one.renew();
  EXPECT_TRUE(all_matched());
  EXPECT_TRUE(all_heard(2));
}

TEST_F(Renewal, OfTheWorldMatchesItAgainWithoutAConflict) {
  ASSERT_TRUE(all_matched());
  world.renew();
  EXPECT_TRUE(all_matched());
  EXPECT_TRUE(all_heard(1));
  EXPECT_EQ(world.conflict(), std::nullopt);
  EXPECT_EQ(one.conflict(), std::nullopt);
}

TEST_F(Renewal, OfAllAtOnceMatchesThemAgain) {
  ASSERT_TRUE(all_matched());
  world.renew();
  one.renew();
  two.renew();
  EXPECT_TRUE(all_matched());
  EXPECT_TRUE(all_heard(1));
}

TEST_F(Renewal, KeepsWhatHadArrivedAndWakesItsOwner) {
  ASSERT_TRUE(all_matched());
  world.publish(testing::tick(1));
  ASSERT_TRUE(world.flush(std::chrono::seconds(10)));
  one.renew();
  pollfd polled{one.wake_fd(), POLLIN, 0};
  EXPECT_EQ(::poll(&polled, 1, 0), 1);
  AtAgent at{one};
  ASSERT_EQ(at.all<wire::Tick>().size(), 1u);
  EXPECT_EQ(at.all<wire::Tick>()[0].round(), 1u);
}

TEST_F(Renewal, PublishesTheMissionAgainForWhoComesLater) {
  world.publish(to_wire(examples::mission(), examples::kStamp));
  world.renew();
  DdsConfig third = config(2);
  third.nonce = 2002;
  DdsAgentPort late(third);
  DdsObserverPort observer([&] {
    DdsConfig own = config(0);
    own.nonce = 3000;
    return own;
  }());
  observer.renew();
  AtAgent at{late};
  std::vector<ObserverInbound> seen;
  EXPECT_TRUE(eventually({late.wake_fd(), observer.wake_fd()}, [&] {
    observer.take(seen);
    return at.all<wire::Mission>().size() == 1 &&
           std::ranges::any_of(seen, [](const auto& s) { return std::holds_alternative<wire::Mission>(s); });
  }));
}

// Threads of DDS deliver while the participant that they belong to is made anew, and serve in the owner's place.
TEST_F(Renewal, UnderTrafficNeitherHangsNorLosesThePort) {
  std::atomic<std::uint64_t> delivered = 0;
  std::atomic<bool> over = false;
  const std::array<AgentId, 1> third{2};
  DdsConfig busy = config(2);
  busy.nonce = 2002;
  DdsAgentGroup group(busy, third, [&] {
    ++delivered;
    return false;
  });
  std::thread traffic([&] {
    for (std::uint32_t round = 1; !over; ++round) {
      world.publish(testing::tick(round));
      one.publish(testing::representative(1));
      std::this_thread::yield();
    }
  });
  std::vector<AgentInbound> arrived;
  bool heard = true;
  for (int renewal = 0; renewal < 12 && heard; ++renewal) {
    const std::uint64_t before = delivered;
    heard = eventually({group.wake_fd()}, [&] {
      group.port(0).take(arrived);
      arrived.clear();
      return delivered > before;
    });
    group.renew();
  }
  over = true;
  traffic.join();
  EXPECT_TRUE(heard);
}

}  // namespace
}  // namespace skein::bus
