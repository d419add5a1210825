// When the next tick may go out: at once, or paced to a multiple of real time.
//
// Paced, a flight step takes step_s / factor of wall time and a planning round round_s / factor. A tick that all have
// answered before its time is up waits for the rest; one that is answered later is late, counts, and stretches: the
// next one's time begins then. Pace changes no result. Source: none. Departs from source: none. Complexity: O(1).
#pragma once

#include <cstdint>

#include "planner/core/lockstep/samples.hpp"

namespace skein {

struct Pace {
  double factor = 0.0;   ///< times real time; 0: as fast as the machine can
  double round_s = 0.1;  ///< what a planning round stands for
};

class Pacer {
 public:
  Pacer(const Pace& pace, double step_s) : pace_(pace), step_s_(step_s) {}

  /// A tick of a phase goes out at `now_s`, in seconds of any steady clock.
  /// @param rounds_in_step of a flight step, which share its time
  void opened(Phase phase, double now_s, std::uint32_t rounds_in_step = 1);
  /// All answers to it are here: whether the next one may go out.
  [[nodiscard]] bool may_open(double now_s);
  /// When it may, if it may not yet.
  [[nodiscard]] double due_s() const { return due_s_; }
  /// Ticks that were answered too late.
  [[nodiscard]] std::uint32_t late() const { return late_; }
  /// Adds those of a world whose run this one goes on with.
  void count_late(std::uint32_t ticks) { late_ += ticks; }

 private:
  Pace pace_;
  double step_s_;
  double due_s_ = 0.0;
  bool answered_ = false;
  bool in_time_ = false;
  std::uint32_t late_ = 0;
};

}  // namespace skein
