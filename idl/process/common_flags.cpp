#include "idl/process/common_flags.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <random>

#include "idl/process/number_within.hpp"
#include "planner/core/isa/isa.hpp"
#include "planner/core/text/utf8.hpp"

namespace skein {
namespace {

/// DDS partitions expand wildcards, so a swarm's name may hold none.
std::string check_swarm(const std::string& name) {
  const bool legal =
      !name.empty() && name.size() <= 64 &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") == std::string::npos;
  return legal ? "" : fmt::format("'{}' is no swarm name; allowed: 1 to 64 letters, digits, - and _", name);
}

}  // namespace

void add_common_flags(CLI::App& app, CommonFlags& flags) {
  app.add_option("--domain", flags.domain, "DDS domain, 0 to 232")
      ->envname("SKEIN_DOMAIN")
      ->check(CLI::Range(0, 232))
      ->capture_default_str();
  app.add_option("--swarm", flags.swarm, "name of the swarm: letters, digits, - and _")
      ->envname("SKEIN_SWARM")
      ->check(check_swarm);
  app.add_option("--profile", flags.profile, "transport: udp or shm")
      ->envname("SKEIN_PROFILE")
      ->check(CLI::IsMember({"udp", "shm"}))
      ->capture_default_str();
  app.add_option("--log-level", flags.log_level, "debug, info, warn, error or off")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.add_option("--startup-timeout", flags.startup_timeout_s, "seconds until all agents must be matched")
      ->envname("SKEIN_STARTUP_TIMEOUT")
      ->check(number_within(0.1, 3600.0))
      ->capture_default_str();
}

std::vector<std::string> arguments_of(const CommonFlags& flags) {
  return {"--domain",          std::to_string(flags.domain),
          "--swarm",           flags.swarm,
          "--profile",         flags.profile,
          "--log-level",       flags.log_level,
          "--startup-timeout", fmt::format("{}", flags.startup_timeout_s)};
}

std::optional<int> parse_or_exit_code(CLI::App& app, int argc, char** argv) {
  const auto complain = [&](const std::string& what) {
    std::cerr << app.get_name() << ": " << one_line(what) << " (see --help)\n";
    return 2;
  };
  for (int i = 1; i < argc; ++i) {
    if (!is_utf8(argv[i])) return complain(fmt::format("argument {} is not UTF-8: {}", i, argv[i]));
  }
  try {
    app.parse(argc, argv);
    if (const auto fault = isa_fault(std::getenv(kIsaVariable))) {
      std::cerr << app.get_name() << ": " << *fault << '\n';
      return 2;
    }
    return std::nullopt;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& help) {
    return app.exit(help);
  } catch (const CLI::RequiredError& error) {
    // a verb that there is not is no verb at all: what was given instead says more
    const std::vector<std::string> unknown = app.remaining();
    const std::string what = unknown.empty() ? error.what() : fmt::format("'{}' is not known", unknown.front());
    return complain(what);
  } catch (const CLI::ParseError& error) {
    return complain(error.what());
  }
}

void keep_standard_streams() {
  // the lowest free descriptor is taken: a closed one of the three, until none is left
  int lowest = open("/dev/null", O_RDWR);
  while (lowest >= 0 && lowest <= STDERR_FILENO) lowest = open("/dev/null", O_RDWR);
  if (lowest >= 0) close(lowest);
}

void start_log(const std::string& name, const CommonFlags& flags) {
  auto logger = spdlog::stderr_logger_mt(name);
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e [%n] %l: %v");
  logger->set_level(spdlog::level::from_str(flags.log_level));
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(logger);
}

std::uint64_t random_id() {
  std::random_device device;
  std::uint64_t id = 0;
  while (id == 0) id = (static_cast<std::uint64_t>(device()) << 32U) | device();
  return id;
}

}  // namespace skein
