#include "groundstation/record/attached.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <limits>

#include "groundstation/attach/choose_swarm.hpp"
#include "groundstation/record/bus_recorder.hpp"
#include "groundstation/record/recording_file.hpp"
#include "idl/process/dds_config.hpp"
#include "idl/process/network_watch.hpp"
#include "idl/process/poll.hpp"
#include "idl/process/silence.hpp"

namespace skein {
namespace {

constexpr double kTake_s = 0.02;     ///< between two looks: a swarm may bring thousands of samples a second
constexpr double kFlush_s = 1.0;     ///< of the run are lost at most when this process is killed
constexpr double kSilence_s = 30.0;  ///< without a sample, as agents take it
constexpr double kLast_s = 0.5;      ///< for what is still on its way when the last tick has come
constexpr double kGone_s = 2.0;      ///< the same when the world is gone
constexpr double kFound_s = 5.0;  ///< in which a world is found again that was forgotten while this process stood still
constexpr double kNever_s = std::numeric_limits<double>::infinity();
constexpr int kUsage = 2;
constexpr int kStartUp = 3;
constexpr int kLost = 4;

struct Ending {
  int exit_code = 0;
  std::string reason;
};

/// Whether the world is there, was there, or went.
struct Presence {
  bool had_world = false;
  double gone_s = kNever_s;

  /// @return whether it is gone for good
  bool lost(bool has_world, double now_s, double grace_s) {
    had_world = had_world || has_world;
    const bool gone = had_world && !has_world;
    gone_s = gone ? std::min(gone_s, now_s) : double{kNever_s};
    return now_s - gone_s >= grace_s;
  }
};

/// Its world is gone, and no last tick came: whose fault that is depends on who stood still.
Ending gone(const Silence& silence) {
  if (silence.stood_still_s() <= 0.0) return {kLost, "the world is gone, without a last tick"};
  return {kStartUp,
          fmt::format("this process stood still for {:.1f} s, and the world is gone since: the end of the run "
                      "was not heard",
                      silence.stood_still_s())};
}

Ending follow(const CommonFlags& flags, const SignalWatch& signals, NetworkWatch& network, bus::DdsRecorderPort& port,
              BusRecorder& recorder, RecordingFile& file) {
  double flushed_s = steady_now_s();
  Silence silence(flushed_s);
  Silence unanswered(flushed_s);  // by a tick, since the start
  double last_s = kNever_s;       // when the last tick came, or the world went
  Presence world;
  const auto renew = [&] {
    port.renew();
    world = {};  // nobody is known to the new one, nor gone
  };
  while (true) {
    wait_readable({signals.fd()}, kTake_s);
    const double now_s = steady_now_s();
    silence.look(now_s);
    unanswered.look(now_s);
    if (recorder.take() > 0) silence.heard();
    if (const auto signal = signals.take()) return {128 + *signal, ended_by(*signal)};
    if (!file.failure().empty()) return {kUsage, file.failure()};
    if (now_s - flushed_s >= kFlush_s) {
      file.flush();
      flushed_s = now_s;
    }
    if (recorder.rounds().finished()) last_s = std::min(last_s, now_s);
    if (now_s - last_s >= kLast_s) return {0, "the run ended"};
    if (const auto what = network.follow(silence.silent_s() > kInNeed_s, renew, now_s))
      fmt::print(stderr, "{}\n", *what);
    const double grace_s = silence.stood_still_s() > 0.0 ? kFound_s : kGone_s;
    if (world.lost(port.has_world(), now_s, grace_s)) return gone(silence);
    if (!recorder.heard_tick() && unanswered.silent_s() >= flags.startup_timeout_s) {
      return {kStartUp, fmt::format("no world of swarm {} in domain {} within {} s", flags.swarm, flags.domain,
                                    flags.startup_timeout_s)};
    }
    if (recorder.heard_tick() && silence.silent_s() >= kSilence_s) {
      return {kStartUp, fmt::format("no sample for {} s", kSilence_s)};
    }
  }
}

}  // namespace

Recorded record_attached(const RecordPlan& plan) {
  Recorded recorded;
  const SignalWatch signals({SIGINT, SIGTERM});
  const SwarmChoice choice = choose_swarm(plan.common, signals);
  if (choice.swarm.empty()) {
    recorded.exit_code = choice.exit_code;
    recorded.reason = choice.reason;
    return recorded;
  }
  CommonFlags flags = plan.common;
  flags.swarm = choice.swarm;
  RecordingFile file(plan.file, {"attached", flags.swarm, plan.scenario, false});
  NetworkWatch network;
  bus::DdsRecorderPort port(dds_config(flags, kWorldId, random_id()), {false, plan.inbox});
  BusRecorder recorder(port, [&](const TakenSample& sample) { file.add(sample); });
  Ending ending = follow(flags, signals, network, port, recorder, file);
  recorded.gaps = recorder.gaps();
  recorded.gaps.conclude(recorder.ends());
  file.finish(recorded.gaps.texts());
  if (!file.failure().empty()) ending = {kUsage, file.failure()};
  recorded.exit_code = ending.exit_code;
  recorded.reason = ending.reason;
  recorded.samples = file.samples();
  recorded.has_file = file.begun();
  return recorded;
}

}  // namespace skein
