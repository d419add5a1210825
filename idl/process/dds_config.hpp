// Where a process's port goes, from its flags.
#pragma once

#include "idl/bus/dds_port.hpp"
#include "idl/process/common_flags.hpp"

namespace skein {

/// The swarm of the flags; without one, "skein".
[[nodiscard]] std::string swarm_of(const CommonFlags& flags);

/// The port's configuration for the process that starts now. @param id kWorldId for the world
[[nodiscard]] bus::DdsConfig dds_config(const CommonFlags& flags, AgentId id, std::uint64_t nonce);

}  // namespace skein
