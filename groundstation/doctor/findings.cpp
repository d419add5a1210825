#include "groundstation/doctor/findings.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "groundstation/doctor/ports.hpp"

namespace skein::doctor {
namespace {

constexpr double kMega = 1024.0 * 1024.0;
constexpr std::uint64_t kDatagram_bytes = 65536;  ///< a buffer that holds less loses the largest samples
constexpr std::uint32_t kFewAgents = 12;          ///< so many start as fast with Debian's own buffers
constexpr std::uint64_t kDescriptors = 64;        ///< 18 were in use, whatever the number of agents
constexpr std::uint64_t kUnlimited = 1U << 30;
constexpr double kShm_mb = 0.64;  ///< of a process with --profile shm
constexpr double kSlow_s = 10.0;
constexpr double kStartUp_s = 30.0;  ///< --startup-timeout by default

std::uint32_t processes_of(const Swarm& swarm) {
  return swarm.agents + 1;  // and the world
}

double memory_mb(const Swarm& swarm) {
  return (6.2 + 0.075 * swarm.agents) * (processes_of(swarm) + 1);  // and the launcher
}

Finding multicast(const MachineFigures& machine) {
  if (!machine.multicast_heard.empty()) {
    return {"multicast", Level::Ok, fmt::format("heard on {}", fmt::join(machine.multicast_heard, ", ")), ""};
  }
  return {
      "multicast", Level::Fail, "sent on every interface, heard on none",
      "ip link set lo multicast on && ip route add 239.255.0.0/16 dev lo; let the firewall pass UDP to 239.255.0.1"};
}

Finding discovery_port(const MachineFigures& machine, const Swarm& swarm) {
  const std::uint32_t port = discovery_port_of(swarm.domain);
  if (machine.discovery_port) return {"discovery port", Level::Ok, fmt::format("UDP {} can be shared", port), ""};
  return {"discovery port", Level::Fail, fmt::format("UDP {} is held by a process that does not share it", port),
          fmt::format("choose another --domain, or end what holds it: ss -ulnp 'sport = :{}'", port)};
}

Finding ports(const MachineFigures& machine, const Swarm& swarm) {
  const std::uint32_t needed = processes_of(swarm);
  const std::string figure =
      fmt::format("{} pairs of UDP ports free in domain {}, {} needed", machine.free_port_pairs, swarm.domain, needed);
  if (machine.free_port_pairs < needed) {
    return {"ports", Level::Fail, figure, "choose another --domain (the upper ones have fewer ports), or fewer agents"};
  }
  if (needed > kOwnPairs) {
    return {"ports", Level::Warn, figure,
            fmt::format("keep domain {} unused: from process {} on its ports are taken", swarm.domain + 1, kOwnPairs)};
  }
  return {"ports", Level::Ok, figure, ""};
}

Finding buffer(const char* what, const char* key, std::uint64_t granted_bytes, const Swarm& swarm) {
  const std::string figure = fmt::format("{:.2f} MB granted, {:.2f} MB asked for",
                                         static_cast<double>(granted_bytes) / kMega, kBufferAsked_bytes / kMega);
  const std::string remedy = fmt::format("sysctl -w net.core.{}={}", key, kBufferAsked_bytes);
  if (granted_bytes < kDatagram_bytes) return {what, Level::Fail, figure, remedy};
  if (granted_bytes < kBufferAsked_bytes && swarm.agents > kFewAgents) {
    return {what, Level::Warn, figure + ": discovery takes twice as long", remedy};
  }
  return {what, Level::Ok, figure, ""};
}

Finding descriptors(const MachineFigures& machine) {
  const std::string limit = machine.descriptors < kUnlimited ? fmt::format("{}", machine.descriptors) : "unlimited";
  const std::string figure = fmt::format("{} for each process, {} needed", limit, kDescriptors);
  if (machine.descriptors >= kDescriptors) return {"descriptors", Level::Ok, figure, ""};
  return {"descriptors", Level::Fail, figure,
          machine.descriptors_most >= kDescriptors ? fmt::format("ulimit -n {}", kDescriptors)
                                                   : "raise nofile in /etc/security/limits.conf"};
}

Finding memory(const MachineFigures& machine, const Swarm& swarm) {
  const double available_mb = static_cast<double>(machine.memory_bytes) / kMega;
  const double needed_mb = memory_mb(swarm);
  const std::string figure = fmt::format("{:.0f} MB available, about {:.0f} MB needed", available_mb, needed_mb);
  if (available_mb < needed_mb) return {"memory", Level::Fail, figure, "end other programs, or run fewer agents"};
  if (available_mb < 2.0 * needed_mb) {
    return {"memory", Level::Warn, figure, "less than twice what is needed: end other programs"};
  }
  return {"memory", Level::Ok, figure, ""};
}

Finding cores(const MachineFigures& machine, const Swarm& swarm) {
  const double p = processes_of(swarm);
  const bool small_buffers = std::min(machine.receive_buffer_bytes, machine.send_buffer_bytes) < kBufferAsked_bytes;
  const double discovery_s = 0.0072 * p * p / machine.cores * (small_buffers ? 2.0 : 1.0);
  const std::string figure =
      fmt::format("{}: about {:.1f} s until {:.0f} processes have found each other", machine.cores, discovery_s, p);
  if (discovery_s > kStartUp_s) {
    return {"cores", Level::Fail, figure, fmt::format("more than the {} s of a start-up: fewer agents", kStartUp_s)};
  }
  if (discovery_s > kSlow_s) return {"cores", Level::Warn, figure, "--startup-timeout 120, or fewer agents"};
  return {"cores", Level::Ok, figure, ""};
}

Finding shared_memory(const MachineFigures& machine, const Swarm& swarm) {
  if (!swarm.shared_memory) return {"/dev/shm", Level::Ok, "not used by --profile udp", ""};
  const double free_mb = static_cast<double>(machine.shm_bytes) / kMega;
  const double needed_mb = kShm_mb * processes_of(swarm);
  const std::string figure = fmt::format("{:.0f} MB free, {:.1f} MB needed, {} files left behind", free_mb, needed_mb,
                                         machine.shm_left_behind);
  if (free_mb < needed_mb) {
    return {"/dev/shm", Level::Fail, figure, "fastdds shm clean, mount -o remount,size=1g /dev/shm, or --profile udp"};
  }
  if (machine.shm_left_behind > 0) {
    return {"/dev/shm", Level::Warn, figure, "if no DDS program runs: fastdds shm clean"};
  }
  return {"/dev/shm", Level::Ok, figure, ""};
}

}  // namespace

std::vector<Finding> findings_of(const MachineFigures& machine, const Swarm& swarm) {
  return {multicast(machine),
          discovery_port(machine, swarm),
          ports(machine, swarm),
          buffer("receive buffer", "rmem_max", machine.receive_buffer_bytes, swarm),
          buffer("send buffer", "wmem_max", machine.send_buffer_bytes, swarm),
          descriptors(machine),
          memory(machine, swarm),
          cores(machine, swarm),
          shared_memory(machine, swarm)};
}

bool can_run(const std::vector<Finding>& findings) {
  return std::ranges::find(findings, Level::Fail, &Finding::level) == findings.end();
}

const char* name_of(Level level) {
  return level == Level::Ok ? "ok" : level == Level::Warn ? "warn" : "fail";
}

}  // namespace skein::doctor
