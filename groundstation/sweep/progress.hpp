// How far a long job is, and how long it will take: on a terminal one line that is rewritten, elsewhere, if wanted, a
// line every ten seconds.
//
// Time left = elapsed / (done here) x (to do): what was done before (a resumed job) took no time now. Source: none.
// Departs from source: none. Complexity: O(1).
#pragma once

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

namespace skein {

/// "50 s", "1 min 20 s", "2 h 5 min": rounded up.
[[nodiscard]] std::string duration_text(double seconds);

/// "12 of 100 runs, 1 min 20 s left"; without a time as long as nothing was done here. @param before done before
[[nodiscard]] std::string progress_text(std::size_t done, std::size_t of, std::size_t before, double elapsed_s);

/// "interrupted: 12 of 100 runs are done; --resume FILE goes on with them". @param journal empty: there is none
[[nodiscard]] std::string interrupted_text(std::size_t done, std::size_t of, const std::string& journal);

enum class ProgressKind : std::uint8_t { None, Lines, Terminal };

class ProgressLine {
 public:
  static constexpr double kLines_s = 10.0;
  static constexpr double kTerminal_s = 0.1;

  /// @param out outlives it. @param what begins each line: "sweep"
  ProgressLine(std::ostream& out, ProgressKind kind, std::string what, double now_s)
      : out_(out), kind_(kind), what_(std::move(what)), start_s_(now_s), shown_s_(now_s) {}

  void show(std::size_t done, std::size_t of, double now_s);
  /// The same with words of the job's own. @param last whether it is shown however little time has passed
  void show(const std::string& text, bool last, double now_s);
  [[nodiscard]] double elapsed_s(double now_s) const { return now_s - start_s_; }
  /// Of those that count as done, so many were before it began.
  void set_before(std::size_t before) { before_ = before; }
  /// Ends the line that is being rewritten, if there is one.
  void end();

 private:
  std::ostream& out_;
  const ProgressKind kind_;
  const std::string what_;
  const double start_s_;
  double shown_s_;
  std::size_t before_ = 0;
  bool open_ = false;
};

}  // namespace skein
