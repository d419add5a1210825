#include "idl/process/dds_config.hpp"

#include <chrono>

namespace skein {

std::string swarm_of(const CommonFlags& flags) {
  return flags.swarm.empty() ? "skein" : flags.swarm;
}

bus::DdsConfig dds_config(const CommonFlags& flags, AgentId id, std::uint64_t nonce) {
  bus::DdsConfig config;
  config.domain = flags.domain;
  config.swarm = swarm_of(flags);
  config.profile = flags.profile == "shm" ? bus::Profile::Shm : bus::Profile::Udp;
  config.id = id;
  config.nonce = nonce;
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  config.start_stamp_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count();
  return config;
}

}  // namespace skein
