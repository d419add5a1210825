// Reads what a machine has, by trying it: sends and receives multicast, binds ports, asks for socket buffers.
//
// Nothing of it reaches a running swarm: the multicast datagrams go to a port of their own, ports are held for a moment
// each. Complexity: O(interfaces + ports); at most a second where multicast is not heard.
#pragma once

#include "groundstation/doctor/findings.hpp"

namespace skein::doctor {

/// What cannot be read counts as absent (0, or not heard), but unlimited where a limit does not exist.
[[nodiscard]] MachineFigures probe(const Swarm& swarm);

/// Interfaces, by name, on which a datagram to the group of DDS discovery comes back to this machine.
[[nodiscard]] std::vector<std::string> interfaces_with_multicast();

}  // namespace skein::doctor
