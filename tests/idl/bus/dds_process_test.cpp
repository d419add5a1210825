// Two processes: what only a second process can prove of the bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <csignal>

#include "tests/idl/bus/waiting.hpp"

extern char** environ;

namespace skein::bus {
namespace {

using testing::AtWorld;
using ::testing::ElementsAre;
using testing::eventually;

constexpr std::uint64_t kPeerNonce = 4242;
constexpr std::array<AgentId, 2> kTwo{1, 2};

/// A running idl_bus_peer; killed with its scope if it still runs.
class Process {
 public:
  explicit Process(const std::string& swarm) {
    std::array<std::string, 5> words{SKEIN_BUS_PEER, std::to_string(testing::kDomain), swarm, "1",
                                     std::to_string(kPeerNonce)};
    std::array<char*, 6> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
    if (::posix_spawn(&pid_, SKEIN_BUS_PEER, nullptr, nullptr, arguments.data(), environ) != 0) pid_ = -1;
    EXPECT_GT(pid_, 0);
  }
  ~Process() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void kill() {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
  /// Its exit code, once it has one.
  std::optional<int> ended() {
    int status = 0;
    if (pid_ <= 0 || ::waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t pid_ = -1;
};

DdsConfig world_config(const std::string& swarm) {
  DdsConfig c;
  c.domain = testing::kDomain;
  c.swarm = swarm;
  c.nonce = 1000;
  return c;
}

bool says_matched(AtWorld& at) {
  const auto beacons = at.all<wire::Beacon>();
  return std::ranges::any_of(
      beacons, [](const wire::Beacon& beacon) { return beacon.matched() == std::vector<std::uint64_t>{1000}; });
}

TEST(TwoProcesses, MatchAnswerThreeHundredTicksAndPart) {
  const std::string swarm = testing::unique_swarm("TwoProcesses");
  DdsWorldPort world(world_config(swarm), kTwo);
  AtWorld at{world};
  world.publish(to_wire(examples::mission(), examples::kStamp));
  Process peer(swarm);
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().size() == 1 && says_matched(at); }));
  EXPECT_THAT(world.matched(), ElementsAre(kPeerNonce));
  world.publish(testing::sense(2));
  world.publish(testing::sense(1));
  // topics keep no order among each other: the mission may come after the first match, and after sense
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] {
    const auto beacons = at.all<wire::Beacon>();
    return beacons.back().step() == 1 && beacons.back().generation() == 1;
  }));
  constexpr std::uint32_t kRounds = 300;
  for (std::uint32_t round = 1; round <= kRounds; ++round) {
    world.publish(testing::tick(round, round == kRounds ? Phase::Finished : Phase::Flying));
    ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return at.all<wire::Beacon>().back().round() == round; })) << round;
  }
  const wire::Beacon last = at.all<wire::Beacon>().back();
  EXPECT_EQ(last.step(), 1u) << "missions that the late joiner got";
  EXPECT_EQ(last.generation(), 1u) << "sense samples of its own";
  EXPECT_EQ(last.state_hash(), 0u) << "ticks out of order";
  std::optional<int> code;
  EXPECT_TRUE(eventually({}, [&] { return (code = peer.ended()).has_value(); }));
  EXPECT_EQ(code, 0);
  EXPECT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().empty(); }));
  EXPECT_EQ(world.lost(), 0u);
}

TEST(TwoProcesses, AKilledOneIsForgottenWhenItsLeaseEnds) {
  const std::string swarm = testing::unique_swarm("Killed");
  DdsWorldPort world(world_config(swarm), kTwo);
  AtWorld at{world};
  Process peer(swarm);
  ASSERT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().size() == 1 && says_matched(at); }));
  peer.kill();
  EXPECT_TRUE(eventually({world.wake_fd()}, [&] { return world.matched().empty(); }));
}

}  // namespace
}  // namespace skein::bus
