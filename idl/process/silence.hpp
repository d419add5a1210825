// For how long others have been silent, as far as a process can tell: while it stands still itself it hears nobody.
//
// A process that was stopped (SIGSTOP, Ctrl-Z) or starved finds its deadlines passed before what waits for it has been
// delivered. So the one that asks says each time round its loop that it looks. With t_i the times of its looks and h
// the last time that it heard somebody, a gap is a stall and the silence begins anew:
//   t_i - t_(i-1) >= kStall_s  =>  h := t_i.
// Source: none. Departs from source: none. Complexity: O(1).
#pragma once

namespace skein {

/// Between two looks of a loop that waits for hundredths of a second.
inline constexpr double kStall_s = 2.0;

class Silence {
 public:
  /// @param now_s of any monotonic clock (all below), never less than before
  explicit Silence(double now_s) : looked_s_(now_s), heard_s_(now_s) {}

  /// To be called each time round, before what has come is taken.
  void look(double now_s) {
    if (const double gap_s = now_s - looked_s_; gap_s >= kStall_s) {
      stood_still_s_ += gap_s;
      heard_s_ = resumed_s_ = now_s;
    }
    looked_s_ = now_s;
  }
  /// Somebody said something. What comes right after a stall may have been said before it ended.
  void heard() {
    heard_s_ = looked_s_;
    if (looked_s_ - resumed_s_ > kBacklog_s) stood_still_s_ = 0.0;
  }

  /// At the last look (s): since somebody was heard, the start, or the end of a stall.
  [[nodiscard]] double silent_s() const { return looked_s_ - heard_s_; }
  /// For how long this process stood still (s) since it heard somebody for certain; 0: not at all.
  [[nodiscard]] double stood_still_s() const { return stood_still_s_; }

 private:
  static constexpr double kBacklog_s = 1.0;  ///< in which all that waited has been delivered

  double looked_s_;
  double heard_s_;
  double resumed_s_ = 0.0;
  double stood_still_s_ = 0.0;
};

}  // namespace skein
