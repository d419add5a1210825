#include "groundstation/monitor/monitor.hpp"

#include <fmt/core.h>
#include <sys/select.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/monitor/screen.hpp"
#include "groundstation/monitor/terminal.hpp"
#include "groundstation/watch/observer.hpp"
#include "idl/process/poll.hpp"

namespace skein::monitor {
namespace {

constexpr double kFrame_s = 0.2;
constexpr double kQuiet_s = 3.0;  ///< without a tick, after which the screen says so
constexpr int kEmptyReads = 50;   ///< of a terminal that says it has keys: it is gone

class Session {
 public:
  Session(watch::Observer& observer, const SignalWatch& signals, const MonitorOptions& options)
      : observer_(observer), signals_(signals), options_(options) {
    surroundings_.swarm = observer.swarm();
    surroundings_.symbols = options.ascii ? Symbols::Ascii : terminal_.symbols();
  }

  MonitorEnd run() {
    while (true) {
      observer_.take();
      if (steady_now_s() >= next_frame_s_) draw();
      if (const auto ending = observer_.ended(); ending && !(options_.keep && view_.outcome)) {
        return {ending->exit_code, ending->reason};
      }
      wait_readable({STDIN_FILENO, signals_.fd()}, watch::kTake_s);
      if (const auto end = take_signals()) return *end;
      if (const auto end = take_keys()) return *end;
    }
  }

 private:
  void draw() {
    next_frame_s_ = steady_now_s() + kFrame_s;
    view_ = observer_.view();
    surroundings_.notice =
        observer_.silence_s() > kQuiet_s ? fmt::format("no tick for {:.0f} s; q leaves", observer_.silence_s()) : "";
    terminal_.show(draw_screen(view_, choices_, surroundings_, terminal_.width(), terminal_.height()));
  }

  std::optional<MonitorEnd> take_signals() {
    while (const std::optional<int> signal = signals_.take()) {
      if (*signal != SIGWINCH) return MonitorEnd{128 + *signal, ended_by(*signal)};
      terminal_.resize();
      next_frame_s_ = 0.0;
    }
    return std::nullopt;
  }

  std::optional<MonitorEnd> take_keys() {
    bool any = false;
    while (const std::optional<Key> key = terminal_.key()) {
      any = true;
      choices_ = after_key(choices_, *key, view_);
      next_frame_s_ = 0.0;
    }
    if (choices_.quit) return MonitorEnd{view_.outcome ? view_.outcome->exit_code : 0, ""};
    // one that was closed without a signal is readable for ever, and never has a key
    empty_reads_ = any || !is_readable() ? 0 : empty_reads_ + 1;
    if (empty_reads_ > kEmptyReads) return MonitorEnd{128 + SIGHUP, "the terminal is gone"};
    return std::nullopt;
  }

  static bool is_readable() {
    fd_set set;
    FD_ZERO(&set);
    FD_SET(STDIN_FILENO, &set);
    timeval now{};
    return select(STDIN_FILENO + 1, &set, nullptr, nullptr, &now) > 0;
  }

  watch::Observer& observer_;
  const SignalWatch& signals_;
  const MonitorOptions options_;
  Terminal terminal_;
  Surroundings surroundings_;
  Choices choices_;
  watch::SwarmView view_;
  double next_frame_s_ = 0.0;
  int empty_reads_ = 0;
};

}  // namespace

MonitorEnd monitor(const CommonFlags& flags, const MonitorOptions& options) {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    return {2, "standard input and output are no terminal; `skein status --watch` needs none"};
  }
  const SignalWatch signals({SIGINT, SIGTERM, SIGHUP, SIGWINCH});
  const SwarmChoice choice = choose_swarm(flags, signals);
  if (choice.swarm.empty()) return {choice.exit_code, choice.reason};
  CommonFlags chosen = flags;
  chosen.swarm = choice.swarm;
  watch::Observer observer(chosen);
  return Session(observer, signals, options).run();
}

}  // namespace skein::monitor
