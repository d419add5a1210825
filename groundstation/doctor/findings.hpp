// Whether a machine can run a swarm of N agents over DDS: what its figures mean, and what to do about them.
//
// What N agents need was measured (docs/doctor.md): P = N + 1 processes take two UDP ports and 18 descriptors each,
// 6.2 + 0.075 N MB of memory, and about 0.0072 P^2 / cores seconds to discover each other, twice as long with Debian's
// own socket buffers. Fail: the swarm will not run, or not start within its 30 s. Warn: it will run, but slower or less
// surely than it could. Pure: figures in, findings out. Complexity: O(1).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace skein::doctor {

/// Bytes that the DDS sockets ask for, each way.
inline constexpr std::uint64_t kBufferAsked_bytes = 4U << 20;

/// What is to be run.
struct Swarm {
  std::uint32_t agents = 3;
  std::uint32_t domain = 0;    ///< 0 to 232
  bool shared_memory = false;  ///< --profile shm
};

/// What the machine has, as probe() reads it.
struct MachineFigures {
  std::vector<std::string> multicast_heard;  ///< interfaces on which a multicast datagram came back to this machine
  bool discovery_port = false;               ///< the domain's shared multicast port can be bound
  std::uint32_t free_port_pairs = 0;         ///< unicast ports of the domain that nobody holds
  std::uint64_t receive_buffer_bytes = 0;    ///< granted when kBufferAsked_bytes are asked for
  std::uint64_t send_buffer_bytes = 0;       ///< likewise
  std::uint64_t descriptors = 0;             ///< RLIMIT_NOFILE, soft
  std::uint64_t descriptors_most = 0;        ///< and hard
  std::uint64_t memory_bytes = 0;            ///< available: the machine's, or what its control group leaves
  std::uint64_t shm_bytes = 0;               ///< free in /dev/shm
  std::uint32_t shm_left_behind = 0;         ///< files of Fast DDS in /dev/shm
  unsigned cores = 1;                        ///< that this process may use
};

enum class Level : std::uint8_t { Ok, Warn, Fail };

struct Finding {
  std::string what;
  Level level = Level::Ok;
  std::string figure;  ///< what was found, beside what is needed
  std::string remedy;  ///< one line; empty with Ok
};

/// One of each kind, in the order in which a start would run into them.
[[nodiscard]] std::vector<Finding> findings_of(const MachineFigures& machine, const Swarm& swarm);

/// Whether no finding fails.
[[nodiscard]] bool can_run(const std::vector<Finding>& findings);

[[nodiscard]] const char* name_of(Level level);

}  // namespace skein::doctor
