#include "groundstation/watch/observer.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>

#include "idl/process/dds_config.hpp"
#include "idl/process/poll.hpp"

namespace skein::watch {
namespace {

constexpr double kSilence_s = 30.0;  ///< without a tick of any phase, as agents take it
constexpr int kNice = 5;
constexpr int kStartUp = 3;
constexpr int kLost = 4;

/// Before DDS starts its threads, which inherit it; an observer that may not is one with priority.
const CommonFlags& stepping_back(const CommonFlags& flags) {
  const int now = getpriority(PRIO_PROCESS, 0);
  [[maybe_unused]] const int refused = setpriority(PRIO_PROCESS, 0, std::max(now, kNice));
  return flags;
}

}  // namespace

Observer::Observer(const CommonFlags& flags)
    : flags_(stepping_back(flags)),
      port_(dds_config(flags_, kWorldId, random_id()), bus::Observed::Shared),
      silence_(steady_now_s()) {}

void Observer::take() {
  arrived_.clear();
  const double now_s = steady_now_s();
  silence_.look(now_s);
  (void)network_.follow(
      silence_s() > kInNeed_s, [this] { port_.renew(); }, now_s);  // what is shown goes on, or does not
  port_.take(arrived_);
  for (const bus::ObserverInbound& sample : arrived_) {
    if (std::holds_alternative<wire::Tick>(sample)) silence_.heard();
    watch_.take(sample, now_s);
  }
  if (!first_s_ && watch_.heard_tick()) first_s_ = now_s;
}

SwarmView Observer::view() {
  return watch_.view(steady_now_s(), port_.endpoints());
}

double Observer::silence_s() const {
  return silence_.silent_s();
}

std::optional<double> Observer::observed_s() const {
  if (!first_s_) return std::nullopt;
  return steady_now_s() - *first_s_;
}

std::optional<Ending> Observer::ended() const {
  if (const std::optional<Outcome> outcome = watch_.outcome()) return Ending{outcome->exit_code, outcome->reason};
  if (const auto conflict = port_.conflict()) return Ending{kStartUp, *conflict};
  if (!watch_.heard_tick() && silence_s() > flags_.startup_timeout_s) {
    return Ending{kStartUp, fmt::format("no world of swarm {} in domain {} within {} s", flags_.swarm, flags_.domain,
                                        flags_.startup_timeout_s)};
  }
  if (silence_s() > kSilence_s) {
    if (const double stood_still_s = silence_.stood_still_s(); stood_still_s > 0.0) {
      return Ending{kLost, fmt::format("the world of swarm {} is not heard since this process stood still for {:.1f} s",
                                       flags_.swarm, stood_still_s)};
    }
    return Ending{kLost, fmt::format("the world of swarm {} has been silent for {} s", flags_.swarm, kSilence_s)};
  }
  return std::nullopt;
}

}  // namespace skein::watch
