// Whether the machine's network is still the one that a DDS participant was made for.
//
// A participant joins multicast groups on the interfaces that are there when it is made. One that is disconnected takes
// its memberships along: what is connected later is another interface to the kernel, though name and address may be the
// same. So an address is known by its interface's index, and the participant is to be made anew when, loopback aside,
//
//   A = { (index, address) : running now },  B = { (index, address) : running when it was made },
//   A has what B has not, and (A lacks what B has, or B is empty)
//
// A link that goes down and up again keeps its index and heals by itself; an interface that disappears alone leaves
// nothing to make a participant for; one with an address that is not running yet (no carrier) would make one that is
// deaf again: all three wait for the next event. One that comes beside those in use (a bridge of containers) takes
// nothing away, and is not joined. Source: rtnetlink(7), groups RTMGRP_LINK and RTMGRP_IPV4_IFADDR;
// getifaddrs(3). Complexity: one system call without an event, O(addresses log addresses) with one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace skein {

/// An IPv4 address of one of the machine's interfaces.
struct NetworkAddress {
  std::uint32_t index = 0;  ///< of the interface, which another one never has again
  std::string interface;
  std::string address;   ///< in dots
  bool running = false;  ///< the interface is up, and has a carrier

  bool operator==(const NetworkAddress&) const = default;
};

/// Those of all interfaces but loopback. @throws std::system_error
[[nodiscard]] std::vector<NetworkAddress> network_addresses();

/// The first running address of `now` that was not running before, if it comes in place of one that was, or is the
/// first of all; else nothing.
[[nodiscard]] std::optional<NetworkAddress> new_address(std::span<const NetworkAddress> before,
                                                        std::span<const NetworkAddress> now);

class NetworkWatch {
 public:
  /// From now on: make it before the participant. @throws std::system_error
  NetworkWatch();
  ~NetworkWatch();
  NetworkWatch(const NetworkWatch&) = delete;
  NetworkWatch& operator=(const NetworkWatch&) = delete;

  /// Readable when something happened to an interface or an address.
  [[nodiscard]] int fd() const { return fd_; }
  /// Why the participant must be made anew, "eth0 10.89.0.5", or nothing; returns at once. What is there then is what
  /// the next one is made for. @throws std::system_error
  [[nodiscard]] std::optional<std::string> take();

 private:
  int fd_;
  std::vector<NetworkAddress> known_;  ///< when the participant was made
};

}  // namespace skein
