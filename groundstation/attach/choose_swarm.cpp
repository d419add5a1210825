#include "groundstation/attach/choose_swarm.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <optional>

#include "idl/bus/dds_observer_port.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/poll.hpp"

namespace skein {
namespace {

constexpr double kHearAll_s =
    1.5;                         ///< in which all swarms of a domain are heard: they announce themselves every second
constexpr double kLook_s = 1.0;  ///< a network that DDS could not follow is looked at again
constexpr int kUsage = 2;
constexpr int kStartUp = 3;

}  // namespace

std::string ended_by(int signal) {
  return fmt::format("ended by {}", signal == SIGINT ? "SIGINT" : signal == SIGHUP ? "SIGHUP" : "SIGTERM");
}

SwarmChoice choose_swarm(const CommonFlags& flags, const SignalWatch& signals) {
  if (!flags.swarm.empty()) return {flags.swarm, 0, ""};
  NetworkWatch network;
  bus::DdsSwarmFinder finder(dds_config(flags, kWorldId, random_id()));
  double until_s = steady_now_s() + flags.startup_timeout_s;
  std::vector<std::string> swarms;
  while (steady_now_s() < until_s) {
    wait_readable({finder.wake_fd(), signals.fd(), network.fd()}, std::clamp(until_s - steady_now_s(), 0.0, kLook_s));
    while (const std::optional<int> signal = signals.take()) {
      if (*signal != SIGWINCH) return {"", 128 + *signal, ended_by(*signal)};
    }
    const bool first = swarms.empty();
    const auto what = network.follow(
        first, [&] { finder.renew(); }, steady_now_s());
    if (what) fmt::print(stderr, "{}\n", *what);
    swarms = finder.swarms();
    if (first && !swarms.empty()) until_s = std::min(until_s, steady_now_s() + kHearAll_s);
  }
  if (swarms.empty()) {
    return {"", kStartUp, fmt::format("no swarm in domain {} within {} s", flags.domain, flags.startup_timeout_s)};
  }
  if (swarms.size() > 1) {
    return {"", kUsage,
            fmt::format("domain {} has {} swarms: {}; choose one with --swarm", flags.domain, swarms.size(),
                        fmt::join(swarms, ", "))};
  }
  return {swarms.front(), 0, ""};
}

}  // namespace skein
