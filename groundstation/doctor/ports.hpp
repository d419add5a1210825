// The UDP ports of a DDS domain: one for discovery, shared by all processes, and two of its own for each process.
//
//   discovery 7400 + 250 d;  of process p 7410 + 250 d + 2 p and 7411 + 250 d + 2 p
// Source: OMG DDSI-RTPS 2.2, section 9.6.1.1, with its default constants. Departs from source: none. Complexity: O(1).
#pragma once

#include <algorithm>
#include <cstdint>

namespace skein::doctor {

inline constexpr std::uint32_t kOwnPairs = 120;    ///< from this process on the ports are the next domain's
inline constexpr std::uint32_t kTriedPairs = 250;  ///< as many as our processes try

[[nodiscard]] constexpr std::uint32_t discovery_port_of(std::uint32_t domain) {
  return 7400 + 250 * domain;
}

/// The first of the two ports of process `p`.
[[nodiscard]] constexpr std::uint32_t own_port_of(std::uint32_t domain, std::uint32_t p) {
  return discovery_port_of(domain) + 10 + 2 * p;
}

/// How many processes may try to find ports: kTriedPairs, or fewer in the uppermost domains.
[[nodiscard]] constexpr std::uint32_t pairs_of(std::uint32_t domain) {
  return std::min(kTriedPairs, (65535 - own_port_of(domain, 0) - 1) / 2 + 1);
}

}  // namespace skein::doctor
