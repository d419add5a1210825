#include "idl/process/network_watch.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>

#include "idl/process/poll.hpp"

namespace skein {
namespace {

const NetworkAddress kBefore{2, "eth0", "10.89.0.5", true};
const NetworkAddress kOther{3, "eth1", "10.90.0.5", true};

std::optional<NetworkAddress> change(std::vector<NetworkAddress> before, std::vector<NetworkAddress> now) {
  return new_address(before, now);
}

NetworkAddress stopped(NetworkAddress address) {
  address.running = false;
  return address;
}

TEST(NewAddress, IsOneOfAnotherInterfaceThoughItsNameAndAddressAreTheSame) {
  NetworkAddress again = kBefore;
  again.index = 7;
  EXPECT_EQ(change({kBefore}, {again}), again);
}

TEST(NewAddress, IsNoneThatComesBesideThoseInUse) {
  EXPECT_EQ(change({kBefore}, {kBefore, kOther}), std::nullopt);
  EXPECT_EQ(change({kBefore}, {stopped(kBefore), kOther}), kOther);
}

TEST(NewAddress, IsAnotherAddressOfAKnownInterface) {
  NetworkAddress moved = kBefore;
  moved.address = "10.89.0.6";
  EXPECT_EQ(change({kBefore}, {moved}), moved);
}

TEST(NewAddress, IsNotTheOneThatCameBackNorOneThatWentAlone) {
  EXPECT_EQ(change({kBefore}, {kBefore}), std::nullopt);
  EXPECT_EQ(change({kBefore, kOther}, {kOther}), std::nullopt);
  EXPECT_EQ(change({kBefore}, {}), std::nullopt);
  EXPECT_EQ(change({kBefore}, {stopped(kBefore)}), std::nullopt);
}

TEST(NewAddress, WaitsUntilItsInterfaceRuns) {
  EXPECT_EQ(change({kBefore}, {stopped(kOther)}), std::nullopt);
  EXPECT_EQ(change({stopped(kOther)}, {kOther}), kOther) << "no participant has been made for it yet";
}

TEST(NewAddress, IsTheFirstOneOfAMachineWithoutANetwork) {
  EXPECT_EQ(change({}, {kOther}), kOther);
}

TEST(NetworkWatch, LeavesLoopbackOut) {
  for (const NetworkAddress& address : network_addresses()) {
    EXPECT_NE(address.interface, "lo");
    EXPECT_NE(address.index, 0u);
  }
}

bool run(const std::string& command) {
  return std::system(command.c_str()) == 0;
}

/// What the watch says within 10 s; "" if nothing.
std::string said(NetworkWatch& watch) {
  for (const double end_s = steady_now_s() + 10.0; steady_now_s() < end_s;) {
    wait_readable({watch.fd()}, 0.1);
    if (const auto change = watch.take()) return *change;
  }
  return "";
}

/// Whether the interface runs, within 10 s.
bool runs(const std::string& interface) {
  for (int look = 0; look < 100; ++look) {
    for (const NetworkAddress& address : network_addresses()) {
      if (address.interface == interface && address.running) return true;
    }
    wait_readable({}, 0.1);
  }
  return false;
}

/// In a network namespace of its own. @return 0, or the number of the first expectation that failed
int watched() {
  if (!run("ip link add a0 type veth peer name b0 && ip link set b0 up && ip link set a0 up && "
           "ip addr add 10.6.0.1/24 dev a0")) {
    return 1;
  }
  if (!runs("a0")) return 1;
  NetworkWatch watch;
  if (watch.take()) return 2;
  run("ip link set a0 down && ip link set a0 up");
  if (!runs("a0") || watch.take()) return 3;
  run("ip link add c0 type veth peer name d0 && ip link set d0 up && ip link set c0 up && ip addr add 10.7.0.1/24 dev "
      "c0");
  if (!runs("c0") || watch.take()) return 4;
  run("ip link del c0 && ip link del a0");
  if (watch.take()) return 5;
  run("ip link add a0 type veth peer name b0 && ip addr add 10.6.0.1/24 dev a0 && ip link set a0 up");
  if (watch.take()) return 6;  // no carrier: its other end is down
  run("ip link set b0 up");
  if (said(watch) != "a0 10.6.0.1") return 7;
  run("ip addr add 10.6.0.9/32 dev a0 && ip addr del 10.6.0.1/24 dev a0");
  if (said(watch) != "a0 10.6.0.9") return 8;
  return watch.take() ? 9 : 0;
}

/// Whether this process may have a network of its own, and has `ip` to change it with.
bool may_have_own_network() {
  const pid_t child = ::fork();
  if (child == 0) {
    const bool own = ::unshare(CLONE_NEWNET) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0;
    ::_exit(own && run("ip link add a0 type veth peer name b0 2>/dev/null") ? 0 : 1);
  }
  int status = 1;
  return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
}

TEST(NetworkWatch, FiresWhenAnAddressIsThereThatAParticipantDoesNotKnow) {
  if (!may_have_own_network()) {  // nothing can be changed here: then nothing fires
    NetworkWatch watch;
    EXPECT_EQ(watch.take(), std::nullopt);
    return;
  }
  const pid_t child = ::fork();
  if (child == 0) {
    if (::unshare(CLONE_NEWNET) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) ::_exit(99);
    ::_exit(watched());
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "the number of the expectation in watched() that failed";
}

}  // namespace
}  // namespace skein
