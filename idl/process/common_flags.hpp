// The flags that every binary takes: where the bus is, how much is logged.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace skein {

struct CommonFlags {
  std::uint32_t domain = 0;
  std::string swarm;  ///< empty: none was given
  std::string profile = "udp";
  std::string log_level = "info";
  double startup_timeout_s = 30.0;
};

/// Adds --domain (SKEIN_DOMAIN), --swarm (SKEIN_SWARM), --profile (SKEIN_PROFILE), --log-level, --startup-timeout
/// (SKEIN_STARTUP_TIMEOUT), checked.
void add_common_flags(CLI::App& app, CommonFlags& flags);

/// The same flags as arguments for a child process.
[[nodiscard]] std::vector<std::string> arguments_of(const CommonFlags& flags);

/// Parses, and checks SKEIN_ISA and that all arguments are UTF-8, since reports and recordings hold nothing else; on
/// `--help` or a fault it prints (one line for a fault, at most about 400 bytes) and gives the exit code: 0 or 2.
[[nodiscard]] std::optional<int> parse_or_exit_code(CLI::App& app, int argc, char** argv);

/// Opens /dev/null for each of the standard streams that is closed, so that no file or socket takes its place. First
/// thing in every main.
void keep_standard_streams();

/// Logs of this process go to standard error, each line named after `name`.
void start_log(const std::string& name, const CommonFlags& flags);

/// A number that no other process draws: run ids, nonces. In no hash.
[[nodiscard]] std::uint64_t random_id();

}  // namespace skein
