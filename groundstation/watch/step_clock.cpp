#include "groundstation/watch/step_clock.hpp"

#include <algorithm>
#include <vector>

namespace skein::watch {
namespace {

constexpr std::size_t kKept = 65;
constexpr std::size_t kEnough = 8;
constexpr double kLately_s = 2.0;

double seconds(std::int64_t ns) {
  return static_cast<double>(ns) * 1e-9;
}

}  // namespace

void StepClock::take(const Tick& tick, std::int64_t stamp_ns) {
  if (!last_.empty() && last_.back().phase != tick.phase) last_.clear();  // another pace
  if (tick.round == 0) return;
  last_.push_back({tick.round, tick.phase, tick.time_s, stamp_ns});
  if (last_.size() > kKept) last_.pop_front();
}

std::optional<double> StepClock::period_s() const {
  std::vector<double> periods;
  for (std::size_t i = 1; i < last_.size(); ++i) {
    if (last_[i].round == last_[i - 1].round + 1) periods.push_back(seconds(last_[i].stamp_ns - last_[i - 1].stamp_ns));
  }
  if (periods.size() < kEnough) return std::nullopt;
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::ranges::nth_element(periods, middle);
  return *middle;
}

std::optional<std::int64_t> StepClock::opened_ns(std::uint32_t round) const {
  const auto found = std::ranges::find(last_, round, &Opened::round);
  if (found == last_.end()) return std::nullopt;
  return found->stamp_ns;
}

std::optional<double> StepClock::times_real_time() const {
  if (last_.size() < 2) return std::nullopt;
  const Opened& newest = last_.back();
  // by hand: the ticks are few, and the clock of a world may have been set back
  const auto oldest = std::ranges::find_if(
      last_, [&](const Opened& opened) { return seconds(newest.stamp_ns - opened.stamp_ns) <= kLately_s; });
  const Opened& from = oldest + 1 == last_.end() ? last_[last_.size() - 2] : *oldest;
  const double wall_s = seconds(newest.stamp_ns - from.stamp_ns);
  if (wall_s <= 0.0) return std::nullopt;
  return (newest.time_s - from.time_s) / wall_s;
}

}  // namespace skein::watch
