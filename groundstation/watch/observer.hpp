// A swarm under observation over DDS: port and knowledge together, and how long its world was silent.
//
// Samples are taken when the owner asks, not when they come: a swarm that runs as fast as it can brings thousands a
// second, and an observer must not take the machine's time. The process lowers its own priority for the same reason.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundstation/watch/swarm_watch.hpp"
#include "idl/process/common_flags.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/silence.hpp"

namespace skein::watch {

/// Why there is nothing more to observe.
struct Ending {
  int exit_code = 0;  ///< the run's own; 3 no world in time, or one of another version; 4 its world fell silent
  std::string reason;
};

class Observer {
 public:
  /// @param flags with the swarm's name @throws std::runtime_error if DDS cannot be had
  explicit Observer(const CommonFlags& flags);

  /// Takes what has come.
  void take();
  [[nodiscard]] SwarmView view();
  [[nodiscard]] const SwarmWatch& watch() const { return watch_; }
  [[nodiscard]] const std::string& swarm() const { return flags_.swarm; }
  /// Whether the run has ended, or there is none: no tick within the start-up timeout, or for 30 s after one; or none
  /// that can be read.
  [[nodiscard]] std::optional<Ending> ended() const;
  /// Since the last tick, the start, or the end of a stall of this process (s); as of the last take().
  [[nodiscard]] double silence_s() const;
  /// Since the first tick; nothing before it.
  [[nodiscard]] std::optional<double> observed_s() const;
  /// Samples that came faster than they were taken.
  [[nodiscard]] std::uint64_t lost() const { return port_.lost(); }

 private:
  CommonFlags flags_;
  NetworkWatch network_;
  bus::DdsObserverPort port_;
  SwarmWatch watch_;
  std::vector<bus::ObserverInbound> arrived_;
  Silence silence_;
  std::optional<double> first_s_;
};

/// How often an observer takes what has come.
inline constexpr double kTake_s = 0.05;

}  // namespace skein::watch
