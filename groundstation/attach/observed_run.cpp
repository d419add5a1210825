#include "groundstation/attach/observed_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "idl/convert/convert.hpp"
#include "planner/core/lockstep/names.hpp"
#include "simworld/process/progress.hpp"

namespace skein {

void ObservedRun::take(const bus::ObserverInbound& sample) {
  std::visit([this](const auto& typed) { on_sample(typed); }, sample);
}

template <typename Plain, typename Wire>
std::optional<Plain> ObservedRun::read(const Wire& sample) {
  Checked<Plain> checked = from_wire(sample, {});
  if (checked.ok()) return std::move(checked).value();
  ++refused_;
  return std::nullopt;
}

void ObservedRun::on_sample(const wire::Mission& sample) {
  if (std::optional<Mission> mission = read<Mission>(sample)) mission_ = std::move(mission);
}

void ObservedRun::on_sample(const wire::Tick& sample) {
  std::optional<Tick> tick = read<Tick>(sample);
  if (!tick) return;
  if (tick_ && tick->run == tick_->run && tick->round < tick_->round) return;  // a late copy
  if (tick_ && tick->run != tick_->run) beacons_.clear();
  tick_ = std::move(tick);
}

void ObservedRun::on_sample(const wire::Beacon& sample) {
  std::optional<Beacon> beacon = read<Beacon>(sample);
  if (!beacon || beacon->agent == kWorldId) return;  // who asks for an id is nobody yet
  Beacon& known = beacons_[beacon->agent];
  if (beacon->round >= known.round) known = *std::move(beacon);
}

nlohmann::json ObservedRun::progress() const {
  std::uint32_t generation = 0;
  double longest_m = 0.0;
  std::size_t arrived = 0;
  for (const auto& [agent, beacon] : beacons_) {
    generation = std::max(generation, beacon.generation);
    longest_m = std::max(longest_m, beacon.planned_length_m);
    if (beacon.mode == AgentMode::Arrived) ++arrived;
  }
  const std::size_t vehicles = mission_ ? mission_->vehicles.size() : beacons_.size();
  return {{"phase", name_of(tick_->phase)},
          {"introduced", beacons_.size()},
          {"agents", vehicles},
          {"round", tick_->round},
          {"generation", generation},
          {"longest_m", longest_m},
          {"step", tick_->step},
          {"time_s", tick_->time_s},
          {"arrived", arrived},
          {"live", tick_->roster.size()},
          {"mark", progress_mark(tick_->phase, beacons_.size(), tick_->round, tick_->step)}};
}

nlohmann::ordered_json ObservedRun::result() const {
  return {{"success", tick_->outcome->exit_code == 0},
          {"exit_code", tick_->outcome->exit_code},
          {"reason", tick_->outcome->reason},
          {"state_hash", fmt::format("{:016x}", tick_->world_hash)},
          {"step", tick_->step},
          {"time_s", tick_->time_s},
          {"scenario", mission_ ? nlohmann::ordered_json(mission_->name) : nullptr},
          {"seed", mission_ ? nlohmann::ordered_json(mission_->seed) : nullptr}};
}

}  // namespace skein
