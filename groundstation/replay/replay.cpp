#include "groundstation/replay/replay.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <stdexcept>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/mcap/file.hpp"
#include "groundstation/replay/replay_pace.hpp"
#include "groundstation/replay/score.hpp"
#include "idl/bus/dds_observer_port.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/signals.hpp"

namespace skein::replay {
namespace {

constexpr double kLook_s = 2.0;    ///< processes announce themselves every second
constexpr double kSettle_s = 1.0;  ///< without a new reader
constexpr double kWait_s = 0.02;
constexpr double kProgress_s = 0.1;
constexpr int kLastTicks = 3;  ///< observers read best effort: they get it again
constexpr double kLastTick_s = 0.05;
constexpr double kToSeconds = 1e-9;
constexpr std::chrono::seconds kFlush(1);
constexpr int kStartUp = 3;

/// Why nothing, or nothing more, is played.
struct Ending {
  int exit_code = 0;
  std::string reason;
};

Ending ended(int signal) {
  return {128 + signal, ended_by(signal)};
}

/// Nothing: nobody is in the swarm.
std::optional<Ending> look(const CommonFlags& flags, const bus::DdsConfig& config, const SignalWatch& signals) {
  const bus::DdsSwarmFinder finder(config);
  for (const double until_s = steady_now_s() + kLook_s; steady_now_s() < until_s;) {
    wait_readable({finder.wake_fd(), signals.fd()}, std::max(until_s - steady_now_s(), 0.0));
    if (const auto signal = signals.take()) return ended(*signal);
    if (std::ranges::binary_search(finder.swarms(), config.swarm)) {
      return Ending{kStartUp, fmt::format("swarm {} in domain {} is live: choose another one with --swarm",
                                          config.swarm, flags.domain)};
    }
  }
  return std::nullopt;
}

class Player {
 public:
  Player(const ReplayPlan& plan, const Score& score, const SignalWatch& signals, const bus::DdsConfig& config)
      : plan_(plan), score_(score), signals_(signals), port_(config, score.writers()) {}

  /// Nothing: the readers are there.
  std::optional<Ending> await_readers() {
    const double start_s = steady_now_s();
    double found_s = start_s;
    std::uint32_t known = 0;
    while (true) {
      if (auto stopped = stopped_after(kWait_s)) return stopped;
      if (const auto conflict = port_.conflict()) return Ending{kStartUp, *conflict};
      const double now_s = steady_now_s();
      const std::uint32_t readers = port_.readers();
      if (std::exchange(known, readers) != readers) found_s = now_s;
      if (port_.tick_readers() >= plan_.observers) {
        if (now_s - found_s >= kSettle_s) return std::nullopt;
      } else if (now_s - start_s >= plan_.common.startup_timeout_s) {
        return Ending{kStartUp, fmt::format("{} of {} observers within {} s", port_.tick_readers(), plan_.observers,
                                            plan_.common.startup_timeout_s)};
      }
    }
  }

  void play(Replayed& replayed) {
    if (plan_.on_begin) plan_.on_begin();
    count(port_.publish({bus::TopicId::Mission, true, kWorldId}, score_.mission()), replayed);
    ReplayPace pace(plan_.rate, score_.round_s());
    const double start_s = steady_now_s();
    score_.play(static_cast<std::uint64_t>(plan_.from_s / kToSeconds), [&](const Note& note) {
      const double due_s = start_s + pace.due_s(note.log_time);
      do {
        stopped_ = stopped_after(std::clamp(due_s - steady_now_s(), 0.0, kProgress_s));
        show(static_cast<double>(note.log_time) * kToSeconds);
      } while (!stopped_ && steady_now_s() < due_s);
      if (stopped_) return false;
      if (note.writer.topic == bus::TopicId::Tick) last_tick_.assign(note.payload.begin(), note.payload.end());
      count(port_.publish(note.writer, note.payload), replayed);
      replayed.to_s = static_cast<double>(note.log_time) * kToSeconds;
      return true;
    });
    if (stopped_) {
      replayed.exit_code = stopped_->exit_code;
      replayed.reason = stopped_->reason;
      return;
    }
    remind();
  }

 private:
  /// A signal, or nothing within the time; at once if there is no time.
  std::optional<Ending> stopped_after(double seconds) {
    if (seconds > 0.0) wait_readable({signals_.fd()}, seconds);
    const auto signal = signals_.take();
    return signal ? std::optional(ended(*signal)) : std::nullopt;
  }

  static void count(bool taken, Replayed& replayed) { ++(taken ? replayed.samples : replayed.refused); }

  void show(double time_s) {
    const double now_s = steady_now_s();
    if (!plan_.on_progress || now_s - shown_s_ < kProgress_s) return;
    shown_s_ = now_s;
    plan_.on_progress(time_s, static_cast<double>(score_.end()) * kToSeconds);
  }

  void remind() {
    for (int copy = 0; copy < kLastTicks && !last_tick_.empty() && port_.tick_readers() > 0; ++copy) {
      if (stopped_after(kLastTick_s)) return;
      (void)port_.publish({bus::TopicId::Tick, true, kWorldId}, last_tick_);
    }
    (void)port_.flush(kFlush);
  }

  const ReplayPlan& plan_;
  const Score& score_;
  const SignalWatch& signals_;
  bus::DdsReplayPort port_;
  mcap::Bytes last_tick_;
  std::optional<Ending> stopped_;
  double shown_s_ = 0.0;
};

}  // namespace

Replayed replay(const ReplayPlan& plan) {
  const mcap::MappedFile mapped(plan.file);
  const mcap::Reader file(mapped.bytes());
  file.check();
  const Score score(file);
  const double end_s = static_cast<double>(score.end()) * kToSeconds;
  if (plan.from_s > end_s) {
    throw std::runtime_error(fmt::format("--from {}: it ends at {:.3f} s of simulated time", plan.from_s, end_s));
  }
  Replayed replayed;
  replayed.missing = file.missing();
  replayed.left_out = score.left_out();
  replayed.from_s = plan.from_s;
  const SignalWatch signals({SIGINT, SIGTERM});
  bus::DdsConfig config = dds_config(plan.common, kWorldId, random_id());
  config.run = random_id();  // of nobody: a world that goes on with the recorded run is another one too
  auto ending = look(plan.common, config, signals);
  if (!ending) {
    Player player(plan, score, signals, config);
    ending = player.await_readers();
    if (!ending) player.play(replayed);
  }
  if (ending) {
    replayed.exit_code = ending->exit_code;
    replayed.reason = ending->reason;
  }
  return replayed;
}

}  // namespace skein::replay
