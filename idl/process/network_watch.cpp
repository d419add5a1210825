#include "idl/process/network_watch.hpp"

#include <arpa/inet.h>
#include <fmt/core.h>
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

constexpr double kAgain_s = 1.0;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Reads all events off the socket. @return whether there was one
bool drained(int fd) {
  std::array<char, 8192> events{};
  bool any = false;
  for (;;) {
    // ENOBUFS: some were too many to be kept; the machine is looked at anyway
    if (::recv(fd, events.data(), events.size(), MSG_DONTWAIT) >= 0 || errno == ENOBUFS) {
      any = true;
    } else if (errno != EINTR) {
      return any;
    }
  }
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
  for (const NetworkAddress& candidate : now) {
    const bool known = std::ranges::any_of(before, [&](const NetworkAddress& old) {
      return old.running && std::tie(old.index, old.address) == std::tie(candidate.index, candidate.address);
    });
    if (candidate.running && !known) return candidate;
  }
  return std::nullopt;
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

std::optional<std::string> NetworkWatch::follow(bool in_need, const std::function<void()>& renew, double now_s) {
  if (drained(fd_)) changed_ = true;
  if (!changed_ || !in_need || now_s < not_before_s_) return std::nullopt;
  std::string what = "the network changed";
  try {
    std::vector<NetworkAddress> now = network_addresses();
    const std::optional<NetworkAddress> fresh = new_address(known_, now);
    changed_ = false;
    if (!fresh) return std::nullopt;
    what = fmt::format("the network changed ({} {})", fresh->interface, fresh->address);
    changed_ = true;
    renew();
    changed_ = false;
    known_ = std::move(now);
    return what + ": DDS participant made anew";
  } catch (const std::exception& error) {
    not_before_s_ = now_s + kAgain_s;
    return fmt::format("{}, but DDS cannot follow, and tries again: {}", what, error.what());
  }
}

}  // namespace skein
