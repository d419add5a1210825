// Cuts processes off from all others of a run, in the network namespace that the run has for itself, and heals it.
//
// All are on one loopback, so that sides are told apart by the UDP ports that only a process on the one side has open
// (/proc/PID/net/udp, by the inodes of /proc/PID/fd): what goes from those to any other port, or from any other to
// those, is dropped where it arrives. Dropped where it leaves, the sender's call would fail, which no network does.
// Ports of both sides (multicast) belong to neither; what the cut-off send there is dropped by the port that it comes
// from. Both directions and all ports begin and end at once (iptables-restore). Source: own. Complexity: O(ports^2)
// rules looked at a datagram.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace skein::chaos {

/// UDP ports that a process has open in its network namespace; none of a process that has ended.
[[nodiscard]] std::set<std::uint16_t> udp_ports_of(pid_t process);

/// Those of `cut` that none of `others` has.
[[nodiscard]] std::set<std::uint16_t> ports_of_one_side(const std::vector<pid_t>& cut,
                                                        const std::vector<pid_t>& others);

/// What iptables-restore is told for it, beside rules that are there already; without a port, that nothing is cut.
[[nodiscard]] std::string partition_rules(const std::set<std::uint16_t>& ports);

/// Puts rules into the network namespace of a process. @param scratch a file that may be written
/// @return whether it was done
[[nodiscard]] bool put_rules(pid_t inside, const std::string& rules, const std::string& scratch);

}  // namespace skein::chaos
