#include "idl/process/network_watch.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
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

TEST(NewAddress, IsOneBesideThoseInUse) {
  EXPECT_EQ(change({kBefore}, {kBefore, kOther}), kOther);
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
  EXPECT_EQ(change({kBefore, stopped(kOther)}, {kBefore, kOther}), kOther) << "no participant has been made for it yet";
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

constexpr bool kInNeed = true;

/// What the watch has made anew for, as the log says it; "" if for nothing.
std::string followed(NetworkWatch& watch, bool in_need = kInNeed) {
  bool renewed = false;
  const auto said = watch.follow(
      in_need, [&] { renewed = true; }, steady_now_s());
  return renewed ? said.value_or("nothing") : said ? "nothing made anew: " + *said : "";
}

/// The same within 10 s.
std::string said(NetworkWatch& watch) {
  for (const double end_s = steady_now_s() + 10.0; steady_now_s() < end_s;) {
    wait_readable({watch.fd()}, 0.1);
    if (std::string change = followed(watch); !change.empty()) return change;
  }
  return "";
}

std::string made_for(const std::string& address) {
  return "the network changed (" + address + "): DDS participant made anew";
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

/// A renewal that fails is tried again a second later, and no sooner. @return as watched()
int failing_renewal(NetworkWatch& watch) {
  int tries = 0;
  const auto fail = [&] {
    ++tries;
    throw std::runtime_error("no participant");
  };
  const double now_s = steady_now_s();
  const auto failed = watch.follow(kInNeed, fail, now_s);
  if (!failed || failed->find("a0 10.6.0.9") == std::string::npos) return 9;
  if (failed->find("no participant") == std::string::npos) return 10;
  if (watch.follow(kInNeed, fail, now_s + 0.5) || tries != 1) return 11;
  if (!watch.follow(
          kInNeed, [&] { ++tries; }, now_s + 1.5) ||
      tries != 2)
    return 12;
  return followed(watch).empty() ? 0 : 13;
}

/// In a network namespace of its own. @return 0, or the number of the first expectation that failed
int watched() {
  if (!run("ip link add a0 type veth peer name b0 && ip link set b0 up && ip link set a0 up && "
           "ip addr add 10.6.0.1/24 dev a0")) {
    return 1;
  }
  if (!runs("a0")) return 1;
  NetworkWatch watch;
  if (!followed(watch).empty()) return 2;
  run("ip link set a0 down && ip link set a0 up");
  if (!runs("a0") || !followed(watch).empty()) return 3;
  run("ip link del a0");
  if (!followed(watch).empty()) return 4;
  run("ip link add a0 type veth peer name b0 && ip addr add 10.6.0.1/24 dev a0 && ip link set a0 up");
  if (!followed(watch).empty()) return 5;  // no carrier: its other end is down
  run("ip link set b0 up");
  if (said(watch) != made_for("a0 10.6.0.1")) return 6;
  run("ip link add c0 type veth peer name d0 && ip link set d0 up && ip link set c0 up && ip addr add 10.7.0.1/24 dev "
      "c0");
  if (!runs("c0") || !followed(watch, !kInNeed).empty()) return 7;
  if (followed(watch) != made_for("c0 10.7.0.1")) return 8;  // it changed before
  run("ip addr add 10.6.0.9/24 dev a0");
  return failing_renewal(watch);
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
    EXPECT_EQ(followed(watch), "");
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
