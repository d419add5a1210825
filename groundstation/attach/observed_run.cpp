#include "groundstation/attach/observed_run.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "idl/convert/convert.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein {
namespace {

std::string mark_of(const Tick& tick, std::size_t agents) {
  switch (tick.phase) {
    case Phase::Waiting:
      return fmt::format("waiting {}", agents);
    case Phase::Planning:
      return fmt::format("planning {}", tick.round / 10);
    case Phase::Flying:
      return fmt::format("flying {}", tick.step / 200);
    case Phase::Finished:
      break;
  }
  return "finished";
}

}  // namespace

void ObservedRun::take(const bus::ObserverInbound& sample) {
  std::visit([this](const auto& typed) { on_sample(typed); }, sample);
}

void ObservedRun::on_sample(const wire::Mission& sample) {
  Checked<Mission> checked = from_wire(sample, {});
  if (!checked.ok()) {
    ++refused_;
    return;
  }
  mission_ = std::move(checked).value();
}

void ObservedRun::on_sample(const wire::Tick& sample) {
  Checked<Tick> checked = from_wire(sample, {});
  if (!checked.ok()) {
    ++refused_;
    return;
  }
  const Tick& tick = checked.value();
  if (tick_ && tick.run == tick_->run && tick.round < tick_->round) return;  // a late copy
  if (tick_ && tick.run != tick_->run) beacons_.clear();
  tick_ = std::move(checked).value();
}

void ObservedRun::on_sample(const wire::Beacon& sample) {
  Checked<Beacon> checked = from_wire(sample, {});
  if (!checked.ok()) {
    ++refused_;
    return;
  }
  Beacon& known = beacons_[checked.value().agent];
  if (checked.value().round >= known.round) known = std::move(checked).value();
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
          {"mark", mark_of(*tick_, beacons_.size())}};
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
