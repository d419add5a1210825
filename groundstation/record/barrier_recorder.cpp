#include "groundstation/record/barrier_recorder.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <utility>

#include "idl/process/dds_config.hpp"
#include "idl/process/poll.hpp"

namespace skein {
namespace {

constexpr double kAgain_s = 0.1;  ///< to a world that was started again, or that drops whom the recorder lacks
constexpr double kFlush_s = 1.0;  ///< of the run are lost at most when this process is killed
constexpr double kRest_s = 0.2;   ///< without a sample after which nothing more is on its way
constexpr std::size_t kInbox = std::size_t{1} << 20;

}  // namespace

BarrierRecorder::BarrierRecorder(const CommonFlags& flags, const std::string& path, const Scenario& scenario,
                                 bool fail_fast)
    : file_(path, {"barrier", flags.swarm, &scenario, fail_fast}),
      port_(dds_config(flags, kWorldId, random_id()), {true, kInbox}),
      recorder_(port_, [this](const TakenSample& sample) { file_.add(sample); }),
      heard_s_(steady_now_s()),
      flushed_s_(heard_s_) {}

void BarrierRecorder::take() {
  const double now_s = steady_now_s();
  if (recorder_.take() > 0) heard_s_ = now_s;
  const auto renew = [this] { port_.renew(); };
  if (const auto what = network_.follow(now_s - heard_s_ > kInNeed_s, renew, now_s)) fmt::print(stderr, "{}\n", *what);
  if (now_s - flushed_s_ < kFlush_s) return;
  file_.flush();
  flushed_s_ = now_s;
}

std::optional<nlohmann::json> BarrierRecorder::serve() {
  take();
  const RoundBook& rounds = recorder_.rounds();
  if (!failure().empty()) {
    if (std::exchange(failure_told_, true)) return std::nullopt;
    return nlohmann::json{{"unrecorded", failure()}};
  }
  if (rounds.round() == 0) return std::nullopt;
  const std::vector<AgentId> lacking = rounds.lacking();
  const double now_s = steady_now_s();
  const bool news = lacking.empty() && !(told_whole_ && told_round_ == rounds.round());
  if (!news && now_s - told_s_ < kAgain_s) return std::nullopt;
  told_round_ = rounds.round();
  told_whole_ = lacking.empty();
  told_s_ = now_s;
  return nlohmann::json{{"recorded", told_round_}, {"lacking", lacking}};
}

void BarrierRecorder::finish(const nlohmann::ordered_json& report) {
  for (std::size_t before = SIZE_MAX; before != file_.samples() && failure().empty();) {
    before = file_.samples();
    wait_readable({port_.wake_fd()}, kRest_s);
    take();
  }
  file_.finish(recorder_.gaps().texts(), report);
}

}  // namespace skein
