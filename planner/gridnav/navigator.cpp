#include "planner/gridnav/navigator.hpp"

#include <algorithm>
#include <stdexcept>

namespace skein::gridnav {
namespace {

constexpr std::uint32_t kRecent = 3;  ///< decisions for which an intent is still a hint
constexpr double kAtRest_m = 1e-9;

Task task_of(const Mission& mission, AgentId self) {
  if (!mission.transit) throw std::invalid_argument("the mission is no transit");
  const TransitMission& transit = *mission.transit;
  const VehicleSpec& vehicle = vehicle_of(mission, self);
  const auto index = static_cast<std::size_t>(&vehicle - mission.vehicles.data());
  if (index >= transit.goals_m.size()) throw std::invalid_argument("a vehicle has no goal");
  Task task;
  task.grid = grid_of(transit);
  task.goal_m = transit.goals_m[index];
  task.goal_radius_m = transit.goal_radius_m;
  task.radius_m = vehicle.radius_m;
  task.step_m = vehicle.speed_mps * transit.planner.decision_s;
  task.sensor_range_m = transit.sensor.range_m;
  task.options = transit.planner;
  if (!task.grid.contains(task.grid.cell_of(task.goal_m))) throw std::invalid_argument("a goal lies in no cell");
  if (!task.grid.contains(task.grid.cell_of(vehicle.start.position_m)))
    throw std::invalid_argument("a start lies in no cell");
  return task;
}

}  // namespace

Navigator::Navigator(const Mission& mission, AgentId self)
    : task_(task_of(mission, self)), body_{self, task_.radius_m, task_.step_m}, map_(task_.grid) {
  for (const VehicleSpec& vehicle : mission.vehicles)
    reaches_m_[vehicle.id] = vehicle.speed_mps * task_.options.decision_s;
  steering_ = make_steering(task_, task_.grid.cell_of(vehicle_of(mission, self).start.position_m));
}

void Navigator::learn(std::span<const CellChange> changed) {
  for (const CellChange& change : changed) {
    if (change.cell >= task_.grid.size()) throw std::invalid_argument("a changed cell is not in the grid");
    map_.set(change.cell, change.state);
    map_hash_ = StateHash(map_hash_).add(change.cell).add(change.state).value();
  }
  if (steering_->learn(map_, changed)) best_m_ = -1.0;
}

bool Navigator::fly(const NavInput& input) const {
  if (next_.decision != input.decision || (next_.from_m - input.position_m).norm() > kAtRest_m) return false;
  if ((next_.to_m - next_.from_m).norm() <= kAtRest_m) return false;
  if (!map_.motion_clear(next_.from_m, next_.to_m, body_.radius_m, Need::SeenFree)) return false;
  std::vector<double> reaches_m;
  for (const Neighbour& other : input.neighbours) {
    const auto known = reaches_m_.find(other.id);
    reaches_m.push_back(known == reaches_m_.end() ? body_.reach_m : known->second);
  }
  return may_fly(body_, next_, input.neighbours, reaches_m);
}

// Whether a neighbour's motion of this decision passes the rules, as far as this UAV knows what it heard.
bool Navigator::will_fly(const NavInput& input, const Neighbour& neighbour) const {
  const Intent& intent = *neighbour.intent;
  if ((intent.from_m - neighbour.position_m).norm() > kAtRest_m) return false;
  std::vector<Neighbour> around;
  for (const Neighbour& other : input.neighbours)
    if (other.id != neighbour.id) around.push_back(other);
  around.push_back({body_.id, input.position_m, body_.radius_m, std::nullopt});
  if (next_.decision == input.decision) around.back().intent = next_;
  const std::vector<double> reaches_m(around.size(), 0.0);
  return may_fly({neighbour.id, neighbour.radius_m, 0.0}, intent, around, reaches_m);
}

std::vector<Other> Navigator::expect(const NavInput& input) {
  std::vector<Other> others;
  for (const Neighbour& neighbour : input.neighbours) {
    Other other;
    other.id = neighbour.id;
    other.clearance_m = body_.radius_m + neighbour.radius_m + kMargin_m;
    other.now_m = other.next_m = neighbour.position_m;
    if (neighbour.intent) {
      heard_[neighbour.id] = {input.decision, *neighbour.intent};
      if (will_fly(input, neighbour)) other.next_m = neighbour.intent->to_m;
    }
    other.way_m = {other.now_m, other.next_m};
    const auto last = heard_.find(neighbour.id);
    if (last != heard_.end() && input.decision - last->second.decision <= kRecent) {
      const Intent& intent = last->second.intent;
      other.intent = intent;
      other.asks_own = intent.asks == body_.id;
      other.moves_on = neighbour.intent.has_value() && (other.next_m - other.now_m).norm() > kAtRest_m;
      for (const CellIndex cell : intent.next_cells)
        if (cell < task_.grid.size()) other.way_m.push_back(task_.grid.centre_m(task_.grid.cell_at(cell)));
    }
    others.push_back(std::move(other));
  }
  return others;
}

void Navigator::judge_progress(double to_go_m, bool yielding, std::size_t neighbours) {
  if (!steering_->complete()) return;
  if (to_go_m < 0) {
    status_ = NavStatus::Unreachable;
    best_m_ = -1.0;
    waited_ = 0;
    return;
  }
  if (status_ == NavStatus::Unreachable) status_ = NavStatus::Flying;
  if (best_m_ < 0 || to_go_m < best_m_ - 0.25 * task_.grid.cell_m) {
    best_m_ = to_go_m;
    waited_ = 0;
    rotations_ = 0;
    status_ = NavStatus::Flying;
  } else if (!yielding && ++waited_ >= task_.options.patience) {
    waited_ = 0;
    if (++rotations_ > kRotations + neighbours) status_ = NavStatus::Deadlock;
  }
}

NavDecision Navigator::decide(const NavInput& input) {
  learn(input.changed);
  NavDecision decision;
  decision.target_m = input.position_m;
  const bool arrived = (input.position_m - task_.goal_m).norm() <= task_.goal_radius_m;
  if (arrived) status_ = NavStatus::Arrived;
  const bool flies = !arrived && fly(input);
  if (flies) decision.target_m = next_.to_m;
  const std::vector<Other> others = expect(input);
  Announcement said;
  said.intent.status = status_;
  said.intent.on_behalf_of = body_.id;
  said.intent.to_m = decision.target_m;
  if (!arrived) {
    const Situation at{map_, decision.target_m, flies ? Need::NotOccupied : Need::SeenFree, others};
    Plan plan = steering_->plan(at);
    to_go_m_ = plan.to_go_m;
    decision.revisited = std::move(plan.revisited);
    judge_progress(to_go_m_, false, others.size());
    Traveller self{body_, decision.target_m, {}};
    self.own.status = status_;
    self.own.waited = rotations_;
    self.own.to_go_m = to_go_m_;
    self.own.on_behalf_of = body_.id;
    const auto detours = [&] { return steering_->detours(at); };
    said = steering_->complete() ? negotiate(map_, self, plan.options, detours, others)
                                 : announce_plainly(self, plan.options, others);
    if (said.yielding && waited_ > 0) --waited_;
  }
  decision.status = status_;
  next_ = said.intent;
  next_.decision = input.decision + 1;
  next_.from_m = decision.target_m;
  next_.next_cells = steering_->way_from(map_, next_.to_m);
  decision.next = next_;
  return decision;
}

void Navigator::add_to(StateHash& hash) const {
  hash.add(status_).add(to_go_m_).add(best_m_).add(waited_).add(rotations_).add(map_hash_);
  hash.add(next_.decision).add(next_.from_m).add(next_.to_m).add(next_.waited).add(next_.to_go_m).add(next_.status);
  hash.add(next_.asks).add(next_.on_behalf_of);
  for (const CellIndex cell : next_.next_cells) hash.add(cell);
}

}  // namespace skein::gridnav
