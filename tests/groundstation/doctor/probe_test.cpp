// The probes on the machine that runs the tests: they see what the test does to it.
#include "groundstation/doctor/probe.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "groundstation/doctor/ports.hpp"
#include "groundstation/doctor/udp_socket.hpp"

namespace skein::doctor {
namespace {

// Each test has a domain of its own: they may run at the same time, and hold ports.
TEST(Probe, ReadsWhatEveryMachineHas) {
  const MachineFigures machine = probe({3, 84});
  EXPECT_GE(machine.cores, 1U);
  EXPECT_GT(machine.memory_bytes, 64U << 20);
  EXPECT_GT(machine.descriptors, 16U);
  EXPECT_GE(machine.descriptors_most, machine.descriptors);
  EXPECT_GT(machine.receive_buffer_bytes, 1024U);
  EXPECT_LE(machine.receive_buffer_bytes, kBufferAsked_bytes);
  EXPECT_GT(machine.send_buffer_bytes, 1024U);
}

TEST(Probe, HearsItsOwnMulticast) {
  EXPECT_FALSE(interfaces_with_multicast().empty());
}

TEST(Probe, CountsAHeldPortOut) {
  constexpr std::uint32_t kDomain = 86;
  const std::uint32_t before = probe({3, kDomain}).free_port_pairs;
  EXPECT_GT(before, 0U);
  EXPECT_LE(before, kTriedPairs);
  UdpSocket holder;
  std::uint32_t pair = 0;
  while (pair < kTriedPairs && !holder.bind(own_port_of(kDomain, pair) + 1)) ++pair;
  ASSERT_LT(pair, kTriedPairs);
  EXPECT_EQ(probe({3, kDomain}).free_port_pairs, before - 1);
}

TEST(Probe, ADiscoveryPortMayBeSharedButNotHeldAlone) {
  constexpr std::uint32_t kDomain = 87;
  {
    const UdpSocket sharing;
    ASSERT_TRUE(sharing.set(SOL_SOCKET, SO_REUSEADDR, 1));
    ASSERT_TRUE(sharing.bind(discovery_port_of(kDomain)));
    EXPECT_TRUE(probe({3, kDomain}).discovery_port);
  }
  const UdpSocket alone;
  ASSERT_TRUE(alone.bind(discovery_port_of(kDomain)));
  EXPECT_FALSE(probe({3, kDomain}).discovery_port);
}

TEST(Probe, SeesALoweredLimit) {
  constexpr std::uint32_t kDomain = 88;
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  rlimit lowered = limit;
  lowered.rlim_cur = 40;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &lowered), 0);
  const MachineFigures machine = probe({3, kDomain});
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  EXPECT_EQ(machine.descriptors, 40U);
  EXPECT_FALSE(can_run(findings_of(machine, {3, kDomain})));
}

}  // namespace
}  // namespace skein::doctor
