#include "idl/process/network_watch.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>
#include <tuple>

namespace skein {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Reads all events off the socket. @return whether there was one
bool drained(int fd) {
  std::array<char, 8192> events{};
  bool any = false;
  for (;;) {
    if (::recv(fd, events.data(), events.size(), MSG_DONTWAIT) >= 0) {
      any = true;
    } else if (errno == ENOBUFS) {
      any = true;  // some were too many to be kept; the machine is looked at anyway
    } else if (errno != EINTR) {
      return any;
    }
  }
}

bool is_running(const NetworkAddress& wanted, std::span<const NetworkAddress> among) {
  return std::ranges::any_of(among, [&](const NetworkAddress& one) {
    return one.running && std::tie(one.index, one.address) == std::tie(wanted.index, wanted.address);
  });
}

}  // namespace

std::vector<NetworkAddress> network_addresses() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) fail("getifaddrs");
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(list, &::freeifaddrs);
  std::vector<NetworkAddress> found;
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    if ((entry->ifa_flags & IFF_LOOPBACK) != 0) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* address = reinterpret_cast<const sockaddr_in*>(entry->ifa_addr);
    if (::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) == nullptr) continue;
    // an alias has a label of its own, "eth0:1", and is the same interface
    const std::string label = entry->ifa_name;
    const std::string name = label.substr(0, label.find(':'));
    const std::uint32_t index = ::if_nametoindex(name.c_str());
    if (index == 0) continue;  // gone since
    constexpr unsigned kRunning = IFF_UP | IFF_RUNNING;
    found.push_back({index, name, text.data(), (entry->ifa_flags & kRunning) == kRunning});
  }
  return found;
}

std::optional<NetworkAddress> new_address(std::span<const NetworkAddress> before, std::span<const NetworkAddress> now) {
  const bool any_before = std::ranges::any_of(before, &NetworkAddress::running);
  const bool one_went =
      std::ranges::any_of(before, [&](const NetworkAddress& old) { return old.running && !is_running(old, now); });
  if (any_before && !one_went) return std::nullopt;
  const auto fresh = std::ranges::find_if(
      now, [&](const NetworkAddress& candidate) { return candidate.running && !is_running(candidate, before); });
  return fresh == now.end() ? std::nullopt : std::optional(*fresh);
}

NetworkWatch::NetworkWatch() : fd_(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE)) {
  if (fd_ < 0) fail("netlink socket");
  sockaddr_nl groups{};
  groups.nl_family = AF_NETLINK;
  groups.nl_groups = RTMGRP_LINK | RTMGRP_IPV4_IFADDR;
  try {
    if (::bind(fd_, reinterpret_cast<const sockaddr*>(&groups), sizeof groups) != 0) fail("netlink bind");
    known_ = network_addresses();
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

NetworkWatch::~NetworkWatch() {
  ::close(fd_);
}

std::optional<std::string> NetworkWatch::take() {
  if (!drained(fd_)) return std::nullopt;
  std::vector<NetworkAddress> now = network_addresses();
  const std::optional<NetworkAddress> fresh = new_address(known_, now);
  if (!fresh) return std::nullopt;
  known_ = std::move(now);
  return fresh->interface + " " + fresh->address;
}

}  // namespace skein
