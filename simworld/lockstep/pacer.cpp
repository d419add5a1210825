#include "simworld/lockstep/pacer.hpp"

namespace skein {

void Pacer::opened(Phase phase, double now_s, std::uint32_t rounds_in_step) {
  if (pace_.factor <= 0.0) return;
  const double period_s = (phase == Phase::Planning ? pace_.round_s : step_s_ / rounds_in_step) / pace_.factor;
  due_s_ = (in_time_ ? due_s_ : now_s) + period_s;
  answered_ = false;
}

bool Pacer::may_open(double now_s) {
  if (pace_.factor <= 0.0) return true;
  if (!answered_) {
    answered_ = true;
    in_time_ = now_s <= due_s_;
    if (!in_time_) ++late_;
  }
  return now_s >= due_s_;
}

}  // namespace skein
