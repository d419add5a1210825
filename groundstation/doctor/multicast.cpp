#include <ifaddrs.h>
#include <net/if.h>
#include <poll.h>

#include <array>
#include <chrono>
#include <cstring>
#include <random>

#include "groundstation/doctor/probe.hpp"
#include "groundstation/doctor/udp_socket.hpp"

namespace skein::doctor {
namespace {

constexpr std::uint32_t kGroup = 0xEFFF0001;  ///< 239.255.0.1, of DDS discovery
constexpr int kTries = 3;
constexpr int kPatience_ms = 100;  ///< for each try; the way within one machine takes microseconds

/// Whether a datagram sent to the group on this interface comes back on it.
bool comes_back(const in_addr& interface) {
  const UdpSocket in;
  const UdpSocket out;
  ip_mreqn member{};
  member.imr_multiaddr.s_addr = htonl(kGroup);
  member.imr_address = interface;
  const int loop = 1;
  if (!in.bind(0) || !in.set(IPPROTO_IP, IP_ADD_MEMBERSHIP, member)) return false;
  if (!out.set(IPPROTO_IP, IP_MULTICAST_IF, interface) || !out.set(IPPROTO_IP, IP_MULTICAST_LOOP, loop)) return false;
  const sockaddr_in group = UdpSocket::address_of(kGroup, in.port());
  std::random_device random;
  const std::array<unsigned, 4> sent{random(), random(), random(), random()};
  for (int i = 0; i < kTries; ++i) {
    ::sendto(out.fd(), sent.data(), sizeof(sent), 0, reinterpret_cast<const sockaddr*>(&group), sizeof(group));
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatience_ms);
    pollfd polled{in.fd(), POLLIN, 0};
    while (std::chrono::steady_clock::now() < end && ::poll(&polled, 1, kPatience_ms) == 1) {
      std::array<unsigned, 4> heard{};
      const bool whole = ::recv(in.fd(), heard.data(), sizeof(heard), 0) == static_cast<ssize_t>(sizeof(heard));
      if (whole && heard == sent) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::string> interfaces_with_multicast() {
  std::vector<std::string> heard;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) return heard;
  for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
    const bool up = (entry->ifa_flags & IFF_UP) != 0;
    if (!up || entry->ifa_addr == nullptr || entry->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in address{};
    std::memcpy(&address, entry->ifa_addr, sizeof(address));
    if (comes_back(address.sin_addr)) heard.emplace_back(entry->ifa_name);
  }
  ::freeifaddrs(all);
  return heard;
}

}  // namespace skein::doctor
