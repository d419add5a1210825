// Whether the machine's network is still the one that a DDS participant was made for.
//
// A participant joins multicast groups on the interfaces that are there when it is made. One that is disconnected takes
// its memberships along: what is connected later is another interface to the kernel, though name and address may be the
// same. So an address is known by its interface's index, and what is there is another network when, loopback aside,
//
//   { (index, address) : running now } is no subset of { (index, address) : running when it was made }
//
// A link that goes down and up again keeps its index and heals by itself; an interface that disappears alone leaves
// nothing to make a participant for; one with an address that is not running yet (no carrier) would make one that is
// deaf again: all three wait for the next event. And a participant that hears whom it should is left alone: bridges of
// containers come and go on a healthy machine. Source: rtnetlink(7), groups RTMGRP_LINK and RTMGRP_IPV4_IFADDR;
// getifaddrs(3). Complexity: one system call without an event, O(addresses log addresses) with one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace skein {

/// Of silence, after which a process is in need: of the world, or in the world of an agent.
inline constexpr double kInNeed_s = 1.0;

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

/// The first running address of `now` that was not there, or not running, before; nothing if there is none.
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
  /// Calls `renew`, which makes the participant anew, if it was made for another network and is `in_need`: it does not
  /// hear whom it should. Returns at once; call it again and again while in need, for the network may have changed
  /// before. If `renew` throws it is called again a second later.
  /// @return what happened, in one line; nothing if nothing did
  [[nodiscard]] std::optional<std::string> follow(bool in_need, const std::function<void()>& renew, double now_s);

 private:
  int fd_;
  std::vector<NetworkAddress> known_;  ///< when the participant was made
  bool changed_ = false;               ///< something happened since the last look
  double not_before_s_ = 0.0;          ///< of the next try, after one that failed
};

}  // namespace skein
