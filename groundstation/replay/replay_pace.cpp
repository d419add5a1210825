#include "groundstation/replay/replay_pace.hpp"

namespace skein::replay {

double ReplayPace::due_s(std::uint64_t log_time) {
  if (last_ && rate_ > 0.0) {
    const std::uint64_t gone = log_time - *last_;
    const double simulated_s =
        gone < kStill_ns ? static_cast<double>(gone) * round_s_ : static_cast<double>(gone) * 1e-9;
    due_s_ += simulated_s / rate_;
  }
  last_ = log_time;
  return due_s_;
}

}  // namespace skein::replay
