// When a recorded sample is due in a replay.
//
// A recording's log_time is simulated time in ns plus a nanosecond a round, so that of two samples
//   log_time - log_time' >= kStill_ns:  simulated time went on by that much
//   less than that, but not 0:          it stood still for that many rounds, which are paced as those of a paced run:
//                                       round_s each
// and wall time is that over the rate. The first one is due at once. At rate 0 every one is.
// Source: groundstation/record/recording.hpp. Departs from source: none. Complexity: O(1).
#pragma once

#include <cstdint>
#include <optional>

namespace skein::replay {

class ReplayPace {
 public:
  static constexpr std::uint64_t kStill_ns = 100'000;  ///< more rounds in a row than any planning has

  /// @param rate times real time, 0 or more; 0: as fast as the machine can. @param round_s over 0
  ReplayPace(double rate, double round_s) : rate_(rate), round_s_(round_s) {}

  /// Seconds of wall time after the first sample, of samples by ascending log_time.
  [[nodiscard]] double due_s(std::uint64_t log_time);

 private:
  const double rate_;
  const double round_s_;
  std::optional<std::uint64_t> last_;
  double due_s_ = 0.0;
};

}  // namespace skein::replay
