// How fast a run goes, by the world's own stamps: an observer's clock and delays do not enter.
//
//   period = median over the last 64 pairs of consecutive rounds of stamp(k + 1) - stamp(k)
//   times real time = (time(b) - time(a)) / (stamp(b) - stamp(a)) over the ticks a .. b of the last two seconds
// Source: none needed. Departs from source: none. Complexity: O(64 log 64) a question, O(1) a tick.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "planner/core/lockstep/samples.hpp"

namespace skein::watch {

class StepClock {
 public:
  /// A tick, not heard before, and the world's stamp on it.
  void take(const Tick& tick, std::int64_t stamp_ns);
  /// The usual time (s) from round to round; nothing before eight of them were heard.
  [[nodiscard]] std::optional<double> period_s() const;
  /// When the world opened a round, if it is one of the last 64 heard.
  [[nodiscard]] std::optional<std::int64_t> opened_ns(std::uint32_t round) const;
  /// Nothing before there were two ticks, or if their stamps are equal.
  [[nodiscard]] std::optional<double> times_real_time() const;

 private:
  struct Opened {
    std::uint32_t round;
    Phase phase;
    double time_s;
    std::int64_t stamp_ns;
  };
  std::deque<Opened> last_;
};

}  // namespace skein::watch
