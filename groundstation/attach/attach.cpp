#include "groundstation/attach/attach.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/attach/observed_run.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"
#include "idl/process/silence.hpp"

namespace skein {
namespace {

constexpr double kSilence_s = 30.0;     ///< without a tick of any phase, as agents take it
constexpr double kLastTick_s = 2.0;     ///< for a last tick that is still on its way when its world is gone
constexpr double kFoundAgain_s = 20.0;  ///< in which a world is found again, or is gone: as long as its lease lasts
constexpr double kLook_s = 0.5;         ///< at most between two looks, by which a stall is told
constexpr int kStartUp = 3;
constexpr int kLost = 4;

Attached without_result(int exit_code, std::string reason) {
  return {exit_code, nullptr, std::move(reason)};
}

class Watch {
 public:
  Watch(const CommonFlags& flags, const std::function<void(const nlohmann::json&)>& show)
      : flags_(flags), show_(show), signals_({SIGINT, SIGTERM}) {}

  Attached run() {
    const SwarmChoice choice = choose_swarm(flags_, signals_);
    if (choice.swarm.empty()) return without_result(choice.exit_code, choice.reason);
    CommonFlags flags = flags_;
    flags.swarm = choice.swarm;
    return follow(flags);
  }

 private:
  /// Sleeps until there is something to do, `limit_s` at most. @return whether a signal ended the watch
  bool wait(int fd, double limit_s) {
    wait_readable({fd, signals_.fd(), network_.fd()}, std::clamp(limit_s, 0.0, kInNeed_s));
    if (const auto signal = signals_.take()) {
      ended_ = without_result(128 + *signal, ended_by(*signal));
    }
    return ended_.has_value();
  }

  /// A participant of another network would be deaf in this one. @param in_need who should be heard is not
  /// @return whether it was made anew
  template <typename Port>
  bool follow_network(Port& port, bool in_need) {
    bool renewed = false;
    const auto renew = [&] {
      port.renew();
      renewed = true;
    };
    if (const auto what = network_.follow(in_need, renew, steady_now_s())) fmt::print(stderr, "{}\n", *what);
    return renewed;
  }

  Attached follow(const CommonFlags& flags) {
    bus::DdsObserverPort port(dds_config(flags, kWorldId, random_id()));
    ObservedRun run;
    std::vector<bus::ObserverInbound> arrived;
    Silence silence(steady_now_s());  // without a tick, or that the world came or went
    bool has_world = false;
    bool had_world = false;
    double gone_after_s = kLastTick_s;
    while (!run.outcome()) {
      if (port.has_world() != has_world) {
        has_world = !has_world;
        had_world = true;
        gone_after_s = kLastTick_s;
        silence.heard();
      }
      const bool gone = had_world && !has_world;
      const double limit_s = gone ? gone_after_s : run.heard_tick() ? kSilence_s : flags.startup_timeout_s;
      const double left_s = limit_s - silence.silent_s();
      if (left_s <= 0.0) return silent(flags, gone, run.heard_tick(), limit_s);
      if (wait(port.wake_fd(), std::min(left_s, kLook_s))) return *ended_;
      silence.look(steady_now_s());
      if (follow_network(port, silence.silent_s() > kInNeed_s)) {  // nobody is known to the new one yet
        has_world = false;
        gone_after_s = kFoundAgain_s;
        silence.heard();
      }
      arrived.clear();
      port.take(arrived);
      for (const bus::ObserverInbound& sample : arrived) {
        if (std::holds_alternative<wire::Tick>(sample)) silence.heard();
        run.take(sample);
      }
      if (!arrived.empty() && run.heard_tick() && !run.outcome()) show_(run.progress());
    }
    return {run.outcome()->exit_code, run.result(), run.outcome()->reason};
  }

  static Attached silent(const CommonFlags& flags, bool gone, bool heard, double limit_s) {
    if (gone)
      return without_result(kLost, fmt::format("the world of swarm {} is gone, without a last tick", flags.swarm));
    return without_result(kStartUp, heard ? fmt::format("no tick of a world for {} s", limit_s)
                                          : fmt::format("no world of swarm {} in domain {} within {} s", flags.swarm,
                                                        flags.domain, limit_s));
  }

  const CommonFlags& flags_;
  const std::function<void(const nlohmann::json&)>& show_;
  SignalWatch signals_;
  NetworkWatch network_;
  std::optional<Attached> ended_;
};

}  // namespace

Attached attach(const CommonFlags& flags, const std::function<void(const nlohmann::json&)>& show) {
  return Watch(flags, show).run();
}

}  // namespace skein
