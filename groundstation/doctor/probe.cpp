#include "groundstation/doctor/probe.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "groundstation/doctor/ports.hpp"
#include "groundstation/doctor/udp_socket.hpp"

namespace skein::doctor {
namespace {

/// What the kernel grants of kBufferAsked_bytes; it doubles the figure for its own use.
std::uint64_t granted_bytes(int option) {
  const UdpSocket socket;
  int bytes = static_cast<int>(kBufferAsked_bytes);
  [[maybe_unused]] const bool accepted = socket.set(SOL_SOCKET, option, bytes);
  socklen_t size = sizeof(bytes);
  if (::getsockopt(socket.fd(), SOL_SOCKET, option, &bytes, &size) != 0) return 0;
  return static_cast<std::uint64_t>(bytes) / 2;
}

bool can_share_discovery_port(std::uint32_t domain) {
  const UdpSocket socket;
  return socket.set(SOL_SOCKET, SO_REUSEADDR, 1) && socket.bind(discovery_port_of(domain));
}

std::uint32_t free_pairs(std::uint32_t domain) {
  std::uint32_t pairs = 0;
  for (std::uint32_t p = 0; p < pairs_of(domain); ++p) {
    const UdpSocket first;
    const UdpSocket second;
    if (first.bind(own_port_of(domain, p)) && second.bind(own_port_of(domain, p) + 1)) ++pairs;
  }
  return pairs;
}

std::optional<std::uint64_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  return file >> value ? std::optional(value) : std::nullopt;  // "max" is no number
}

/// MemAvailable, or what the control group's limit leaves of it, if that is less.
std::uint64_t available_bytes() {
  std::uint64_t available = 0;
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    if (word == "MemAvailable:" && file >> available) break;
  }
  available *= 1024;
  const std::string folder = "/sys/fs/cgroup/";
  for (const auto& [limit, used] : {std::pair{"memory.max", "memory.current"},
                                    std::pair{"memory/memory.limit_in_bytes", "memory/memory.usage_in_bytes"}}) {
    const auto most = number_in(folder + limit);
    const auto current = number_in(folder + used);
    if (most && current) available = std::min(available, *most - std::min(*most, *current));
  }
  return available;
}

unsigned usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const int count = ::sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 1;
  return static_cast<unsigned>(std::max(count, 1));
}

std::uint32_t left_behind() {
  std::uint32_t files = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm", error)) {
    if (entry.path().filename().string().find("fastrtps_") != std::string::npos) ++files;
  }
  return files;
}

}  // namespace

MachineFigures probe(const Swarm& swarm) {
  MachineFigures machine;
  machine.multicast_heard = interfaces_with_multicast();
  machine.discovery_port = can_share_discovery_port(swarm.domain);
  machine.free_port_pairs = free_pairs(swarm.domain);
  machine.receive_buffer_bytes = granted_bytes(SO_RCVBUF);
  machine.send_buffer_bytes = granted_bytes(SO_SNDBUF);
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) == 0) {
    machine.descriptors = limit.rlim_cur;
    machine.descriptors_most = limit.rlim_max;
  }
  machine.memory_bytes = available_bytes();
  struct statvfs shm {};
  if (::statvfs("/dev/shm", &shm) == 0) machine.shm_bytes = std::uint64_t{shm.f_bavail} * shm.f_frsize;
  machine.shm_left_behind = left_behind();
  machine.cores = usable_cores();
  return machine;
}

}  // namespace skein::doctor
