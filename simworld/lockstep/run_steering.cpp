#include <fmt/core.h>

#include <algorithm>

#include "planner/core/geometry/terrain.hpp"
#include "planner/core/lockstep/names.hpp"
#include "simworld/lockstep/answers.hpp"
#include "simworld/lockstep/run.hpp"

namespace skein {
namespace {

bool is_commanded(AgentMode mode) {
  return mode == AgentMode::Holding || mode == AgentMode::GoingTo || mode == AgentMode::Landing;
}

Objection refused(std::string text) {
  return {OrderResult::Refused, std::move(text)};
}

bool by_cells(const Mission& mission) {
  return mission.transit && mission.transit->planner.name != kStraight;
}

/// Whether a point lies in no cell of a transit.
std::optional<Objection> beyond(const Vec3& point_m, const CellGrid& grid) {
  const Vec3 low = grid.origin_m;
  const Vec3 high = low + Vec3(grid.nx * grid.cell_m, grid.ny * grid.cell_m, grid.nz * grid.height_m);
  if ((point_m.array() >= low.array()).all() && (point_m.array() < high.array()).all()) return std::nullopt;
  return refused(fmt::format("the point is outside the area: x {} to {}, y {} to {}, z {} to {} m", low.x(), high.x(),
                             low.y(), high.y(), low.z(), high.z()));
}

/// What the orders of a kind ask that no mission allows.
std::optional<Objection> nonsense(const Order& order, const Mission& mission) {
  if (order.kind == OrderKind::Abort && order.agent != kAllAgents) return refused("abort is for the whole swarm");
  if (order.kind == OrderKind::Abort) return std::nullopt;
  if (order.kind != OrderKind::Goto) return std::nullopt;
  if (order.agent == kAllAgents) return refused("goto needs an agent: no two can be at one point");
  const double most_mps = vehicle_of(mission, order.agent).speed_mps;
  if (order.speed_mps > most_mps) {
    return refused(fmt::format("vehicle {} flies at most {} m/s", order.agent, most_mps));
  }
  if (mission.terrain && height_above_m(*mission.terrain, order.to_m) < 0.0) {
    return refused(
        fmt::format("that point is {:.1f} m under the ground", -height_above_m(*mission.terrain, order.to_m)));
  }
  if (by_cells(mission)) return beyond(order.to_m, grid_of(*mission.transit));
  return std::nullopt;
}

}  // namespace

std::optional<Objection> Run::objection(const Order& order, std::span<const Loss> lost) const {
  if (finished()) return Objection{OrderResult::Ended, "the run is over"};
  if (order.kind == OrderKind::Start) return Objection{OrderResult::Started, "the mission has started already"};
  if (order.agent != kAllAgents) {
    if (std::ranges::find(mission_.vehicles, order.agent, &VehicleSpec::id) == mission_.vehicles.end()) {
      return Objection{OrderResult::UnknownAgent, fmt::format("the mission has no vehicle {}", order.agent)};
    }
    const bool live = std::ranges::find(roster_, order.agent, &RosterEntry::agent) != roster_.end();
    if (!live || holds(lost, order.agent)) {
      return Objection{OrderResult::NotLive, fmt::format("agent {} is not live", order.agent)};
    }
    if (world_.vehicle(order.agent).landed) {
      return Objection{OrderResult::NotLive, fmt::format("vehicle {} has landed", order.agent)};
    }
    if (by_cells(mission_) && world_.vehicle(order.agent).status == VehicleStatus::Rejoined) {
      return refused(
          fmt::format("agent {} came back after a loss: in a transit by cells it flies no more", order.agent));
    }
  }
  if (auto found = nonsense(order, mission_)) return found;
  if (order.kind != OrderKind::Abort && step_ == 0) {
    return Objection{OrderResult::NotFlying, "the swarm is not in flight yet"};
  }
  return std::nullopt;
}

/// Of the round that is decided: what is left of it in a run that ends here is the abort alone.
void Run::steer(const Steered& steered) {
  orders_.clear();
  for (const Order& order : steered.orders) {
    if (finished()) break;
    if (order.kind == OrderKind::Abort) finish("aborted by command");
    orders_.push_back(order);
  }
  if (finished()) std::erase_if(orders_, [](const Order& order) { return order.kind != OrderKind::Abort; });
  for (const Order& order : orders_) order_log_.push_back({step_, round_ + 1, order, {}});
  if (finished()) return;
  for (const Injection& injection : steered.injections) {
    if (injection.kind != InjectionKind::Obstacle) continue;
    world_.inject(injection, std::max(step_, 1U));
    injection_log_.push_back({step_, round_ + 1, injection});
  }
}

void Run::note_acknowledged(const Barrier& answers) {
  for (OrderRecord& record : order_log_) {
    if (record.round != round_) continue;
    record.acknowledged.clear();
    for (const VehicleSpec& vehicle : mission_.vehicles) {
      const Answer* answer = answers.answer_of(vehicle.id);
      if (answer == nullptr || !answer->beacon) continue;
      const auto& ids = answer->beacon->acknowledged;
      if (std::ranges::find(ids, record.order.id) != ids.end()) record.acknowledged.push_back(vehicle.id);
    }
  }
}

/// Steps in which somebody flew by command leave as many more, up to twice the limit.
std::uint32_t Run::step_limit() const {
  return options_.max_steps + std::min(commanded_steps_, options_.max_steps);
}

void Run::count_commanded(const Barrier& answers) {
  commanded_.clear();
  for (const RosterEntry& entry : roster_) {
    if (is_commanded(beacon_of(answers, entry.agent).mode)) commanded_.push_back(entry.agent);
  }
  if (!commanded_.empty()) ++commanded_steps_;
}

/// Why the flight had to end, with whom it still waited for by command.
std::string Run::out_of_steps() const {
  std::string text =
      fmt::format("the flight did not end within world.max_steps = {} steps{}", options_.max_steps,
                  commanded_steps_ > 0 ? fmt::format(" and {} by command", step_ - options_.max_steps) : "");
  for (const AgentId agent : commanded_) text += fmt::format("; agent {} flies by command", agent);
  return text;
}

}  // namespace skein
