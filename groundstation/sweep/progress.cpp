#include "groundstation/sweep/progress.hpp"

#include <fmt/core.h>

#include <cmath>

namespace skein {

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_text(std::size_t done, std::size_t of, std::size_t before, double elapsed_s) {
  std::string text = fmt::format("{} of {} runs", done, of);
  if (done <= before || done == of) return text;
  const double left_s = elapsed_s / static_cast<double>(done - before) * static_cast<double>(of - done);
  return fmt::format("{}, {} left", text, duration_text(left_s));
}

std::string interrupted_text(std::size_t done, std::size_t of, const std::string& journal) {
  return fmt::format("interrupted: {} of {} runs are done; {}", done, of,
                     journal.empty() ? "to be able to go on with them a job needs --resume FILE from its start"
                                     : fmt::format("the same command with --resume {} goes on with them", journal));
}

void ProgressLine::show(std::size_t done, std::size_t of, double now_s) {
  show(progress_text(done, of, before_, elapsed_s(now_s)), done == of, now_s);
}

void ProgressLine::show(const std::string& text, bool last, double now_s) {
  if (kind_ == ProgressKind::None) return;
  const bool terminal = kind_ == ProgressKind::Terminal;
  if (!last && now_s - shown_s_ < (terminal ? kTerminal_s : kLines_s)) return;
  shown_s_ = now_s;
  const std::string line = what_ + ": " + text;
  out_ << (terminal ? "\r\x1b[K" + line : line + "\n") << std::flush;
  open_ = terminal;
}

void ProgressLine::end() {
  if (open_) out_ << "\n" << std::flush;
  open_ = false;
}

}  // namespace skein
