#include "planner/gridnav/navigator.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

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
    : task_(task_of(mission, self)),
      body_{self, task_.radius_m, task_.step_m},
      map_(task_.grid),
      guide_(task_, task_.grid.cell_of(vehicle_of(mission, self).start.position_m)) {
  for (const VehicleSpec& vehicle : mission.vehicles)
    reaches_m_[vehicle.id] = vehicle.speed_mps * task_.options.decision_s;
}

void Navigator::learn(std::span<const CellChange> changed) {
  for (const CellChange& change : changed) {
    if (change.cell >= task_.grid.size()) throw std::invalid_argument("a changed cell is not in the grid");
    map_.set(change.cell, change.state);
    map_hash_ = StateHash(map_hash_).add(change.cell).add(change.state).value();
  }
  const bool on_errand = errand_ && errand_->learn(map_, changed);
  if (guide_.learn(map_, changed) || on_errand) best_m_ = -1.0;
}

void Navigator::begin(std::optional<Errand> errand) {
  errand_ = std::move(errand);
  status_ = NavStatus::Flying;
  best_m_ = -1.0;
  waited_ = rotations_ = 0;
}

void Navigator::hold() {
  begin(Errand());
}

void Navigator::go_to(const Vec3& point_m, double speed_mps) {
  Task task = task_;
  task.step_m = std::min(task.step_m, speed_mps * task.options.decision_s);
  begin(Errand(task, point_m));
}

void Navigator::resume() {
  begin(std::nullopt);
}

std::optional<ErrandState> Navigator::errand() const {
  return errand_ ? std::optional(errand_->state()) : std::nullopt;
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
    note_held(neighbour);
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

/// Held is who said so last, and has not moved since.
void Navigator::note_held(const Neighbour& neighbour) {
  const auto last = heard_.find(neighbour.id);
  const bool held = last != heard_.end() && last->second.intent.status == NavStatus::Held &&
                    (last->second.intent.from_m - neighbour.position_m).norm() <= kAtRest_m;
  held_.erase(neighbour.id);
  if (held) held_[neighbour.id] = {neighbour.position_m, body_.radius_m + neighbour.radius_m + kMargin_m};
}

/// But those in which its own body is: there it must get past in any case.
std::vector<CellIndex> Navigator::held_cells(const Vec3& own_m) const {
  const CellGrid& grid = task_.grid;
  std::set<CellIndex> cells;
  for (const auto& [id, standing] : held_) {
    const Vec3 reach_m = Vec3::Constant(standing.apart_m);
    const Cell low = grid.cell_of(standing.at_m - reach_m);
    const Cell high = grid.cell_of(standing.at_m + reach_m);
    for (std::int32_t k = low.k; k <= high.k; ++k)
      for (std::int32_t j = low.j; j <= high.j; ++j)
        for (std::int32_t i = low.i; i <= high.i; ++i) {
          const Cell cell{i, j, k};
          const bool in = cell == grid.cell_of(standing.at_m);
          const bool near = (grid.centre_m(cell) - standing.at_m).norm() < standing.apart_m;
          if (grid.contains(cell) && (in || near)) cells.insert(grid.index_of(cell));
        }
  }
  std::erase_if(cells, [&](CellIndex cell) {
    const Box box = grid.box_of(grid.cell_at(cell));
    return (own_m - own_m.cwiseMax(box.min_m).cwiseMin(box.max_m)).norm() <= body_.radius_m;
  });
  return {cells.begin(), cells.end()};
}

void Navigator::judge_progress(double to_go_m, bool yielding, std::size_t neighbours) {
  if (!steering().complete()) return;
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

/// What it says of the next motion, from where this one ends.
Announcement Navigator::travel(NavDecision& decision, bool flies, const NavInput& input,
                               std::span<const Other> others) {
  const Situation at{map_, decision.target_m, flies ? Need::NotOccupied : Need::SeenFree, others};
  const std::vector<CellIndex> held = held_cells(at.start_m);
  Guide::Around around = errand_ ? errand_->plan(at, held) : guide_.plan(at, held);
  if (around.changed) best_m_ = -1.0;
  if (around.through) {
    std::erase_if(held_, [&](const auto& entry) {
      return std::ranges::find(input.neighbours, entry.first, &Neighbour::id) == input.neighbours.end();
    });
  }
  to_go_m_ = around.plan.to_go_m;
  decision.revisited = std::move(around.plan.revisited);
  judge_progress(to_go_m_, false, others.size());
  Traveller self{body_, decision.target_m, {}};
  self.own.status = status_;
  self.own.waited = rotations_;
  self.own.to_go_m = to_go_m_;
  self.own.on_behalf_of = body_.id;
  const auto detours = [&] { return steering().detours(at); };
  Announcement said = steering().complete() ? negotiate(map_, self, around.plan.options, detours, others)
                                            : announce_plainly(self, around.plan.options, others);
  const bool slow = flies && errand_ && errand_->step_m() < task_.step_m;
  if ((said.yielding || around.through || slow) && waited_ > 0) --waited_;
  return said;
}

NavDecision Navigator::decide(const NavInput& input) {
  learn(input.changed);
  if (errand_ && status_ == NavStatus::Deadlock) errand_->give_up();
  if (errand_) errand_->look_around(map_, input.position_m);
  NavDecision decision;
  decision.target_m = input.position_m;
  const bool stays = errand_ && errand_->stays();
  const bool arrived = !errand_ && (input.position_m - task_.goal_m).norm() <= task_.goal_radius_m;
  if (arrived) status_ = NavStatus::Arrived;
  if (stays) status_ = NavStatus::Held;
  const bool flies = !arrived && !stays && fly(input);
  if (flies) decision.target_m = next_.to_m;
  const std::vector<Other> others = expect(input);
  Announcement said;
  said.intent.status = status_;
  said.intent.on_behalf_of = body_.id;
  said.intent.to_m = decision.target_m;
  if (!arrived && !stays) said = travel(decision, flies, input, others);
  decision.status = status_;
  next_ = said.intent;
  next_.decision = input.decision + 1;
  next_.from_m = decision.target_m;
  if (stays) {
    next_.next_cells.fill(task_.grid.index_of(task_.grid.cell_of(next_.to_m)));
  } else {
    next_.next_cells = steering().way_from(map_, next_.to_m);
  }
  decision.next = next_;
  return decision;
}

void Navigator::add_to(StateHash& hash) const {
  hash.add(status_).add(to_go_m_).add(best_m_).add(waited_).add(rotations_).add(map_hash_);
  hash.add(next_.decision).add(next_.from_m).add(next_.to_m).add(next_.waited).add(next_.to_go_m).add(next_.status);
  hash.add(next_.asks).add(next_.on_behalf_of);
  for (const CellIndex cell : next_.next_cells) hash.add(cell);
  for (const auto& [id, standing] : held_) hash.add(id).add(standing.at_m);
  if (errand_) errand_->add_to(hash);
}

}  // namespace skein::gridnav
