// What the processes of a deployment find in their environment: the one place with these settings.
//
// A setting is an environment variable that Skein's binaries (idl/process/common_flags.hpp, agent/main.cpp) or Fast DDS
// read; a flag on the command line goes before it, and so does a variable that is set already. QoS is not here: it is
// the same everywhere (idl/bus/dds_qos.cpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skein {

struct Setting {
  std::string name;
  std::string value;
  std::string why;  ///< one line
};

/// Names of the deployments, ascending.
[[nodiscard]] std::vector<std::string> deployments();

/// @param server HOST:PORT of the discovery server; used by `discovery-server` alone
/// @return nothing for an unknown deployment
[[nodiscard]] std::optional<std::vector<Setting>> settings_of(std::string_view deployment, std::string_view server);

/// A script for sh, to be read with `.` or eval: exports each setting that is not set yet.
[[nodiscard]] std::string shell_text(std::string_view deployment, const std::vector<Setting>& settings);

}  // namespace skein
