#include "simworld/world/world.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"
#include "simworld/sensing/sensor.hpp"
#include "simworld/sensing/shortest_paths.hpp"

namespace skein {
namespace {

/// Turn of a step (rad) below which its plane is not defined well enough to tell a torsion.
constexpr double kLeastTurn_rad = 1e-4;

/// Angle (rad) between the planes of two turns, per way of one step.
double torsion_per_m(const Vec3& before, const Vec3& now, double length_m) {
  if (std::min(before.norm(), now.norm()) < kLeastTurn_rad) return 0.0;
  return math::atan2(before.cross(now).norm(), std::fabs(before.dot(now))) / length_m;
}

/// What can hover stands still; a vehicle that cannot circles to its left, level, as tightly as it can.
Vec3 waiting_course(const VehicleRecord& vehicle) {
  if (vehicle.spec.type != VehicleType::ConstantSpeed) return Vec3::Zero();
  return {-vehicle.state.velocity_mps.y(), vehicle.state.velocity_mps.x(), 0.0};
}

}  // namespace

std::string_view name_of(VehicleStatus status) {
  constexpr std::array<std::string_view, 11> kNames{"",       "flying",   "arrived",  "missed",      "removed",
                                                    "adrift", "hovering", "rejoined", "unreachable", "deadlock",
                                                    "landed"};
  return kNames.at(static_cast<std::size_t>(status));
}

World::World(const Mission& mission, OnAgentLoss on_agent_loss, std::vector<Obstacle> hidden,
             const Surprises& surprises)
    : step_s_(mission.step_s),
      arrival_radius_m_(mission.arrival_radius_m),
      zones_(mission.zones),
      terrain_(mission.terrain),
      hidden_(std::move(hidden)),
      transit_(mission.transit),
      seed_(mission.seed),
      on_agent_loss_(on_agent_loss),
      replans_(!mission.transit && mission.planner.replan == 1) {
  if (mission.vehicles.empty()) throw std::invalid_argument("a world needs at least one vehicle");
  if (!(step_s_ > 0.0)) throw std::invalid_argument("step_s must be positive");
  for (const VehicleSpec& spec : mission.vehicles) {
    VehicleRecord record;
    record.spec = spec;
    record.slot = slot_pose(mission, spec);
    if (transit_) record.slot = {transit_->goals_m.at(vehicles_.size()), 0.0, 0.0};
    record.state = initial_state(spec);
    record.heading_rad = spec.start.heading_rad;
    vehicles_.push_back(record);
  }
  if (transit_) {
    arrival_radius_m_ = transit_->goal_radius_m;
    if (transit_->planner.name != kStraight) truth_.emplace(grid_of(*transit_), all_obstacles(mission, hidden_));
  }
  for (const Obstacle& obstacle : hidden_) hidden_bounds_.push_back(bounds_of(obstacle));
  in_hidden_.resize(vehicles_.size() * hidden_.size());
  motions_.resize(vehicles_.size());
  touching_.resize(vehicles_.size() * vehicles_.size());
  near_.resize(vehicles_.size() * vehicles_.size());
  least_m_.resize(vehicles_.size() * vehicles_.size(), std::numeric_limits<double>::infinity());
  in_zone_.resize(vehicles_.size() * zones_.size());
  grounded_.resize(vehicles_.size());
  prepare(mission, surprises);
}

std::size_t World::index_of(AgentId id) const {
  const auto found = std::ranges::find(vehicles_, id, [](const VehicleRecord& v) { return v.spec.id; });
  if (found == vehicles_.end()) throw std::invalid_argument("no vehicle " + std::to_string(id));
  return static_cast<std::size_t>(found - vehicles_.begin());
}

const VehicleRecord& World::vehicle(AgentId id) const {
  return vehicles_[index_of(id)];
}

bool World::in_the_air(std::size_t i) const {
  return vehicles_[i].status != VehicleStatus::Removed && !vehicles_[i].landed;
}

std::size_t World::count(ContactKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(contacts_, kind, &Contact::kind));
}

void World::lose_agent(AgentId id) {
  VehicleRecord& vehicle = vehicles_[index_of(id)];
  if (vehicle.status == VehicleStatus::Removed) return;  // of an agent that came back, and is lost again
  if (vehicle.landed) return;
  if (!airborne_ || on_agent_loss_ == OnAgentLoss::Remove) {
    vehicle.status = VehicleStatus::Removed;
  } else {
    vehicle.status = on_agent_loss_ == OnAgentLoss::Hover ? VehicleStatus::Hovering : VehicleStatus::Adrift;
  }
}

void World::return_agent(AgentId id) {
  VehicleRecord& vehicle = vehicles_[index_of(id)];
  const bool waits = replans_ && vehicle.status == VehicleStatus::Hovering;
  if (vehicle.status == VehicleStatus::Adrift || waits) vehicle.status = VehicleStatus::Rejoined;
}

void World::take_up(AgentId id) {
  VehicleRecord& vehicle = vehicles_[index_of(id)];
  const bool again = vehicle.status == VehicleStatus::Rejoined || vehicle.status == VehicleStatus::Missed;
  if (again) vehicle.status = VehicleStatus::Flying;
}

void World::note_given_up(AgentId id, NavStatus status) {
  VehicleRecord& vehicle = vehicles_[index_of(id)];
  const bool obeys = vehicle.status == VehicleStatus::Flying || vehicle.status == VehicleStatus::Unreachable ||
                     vehicle.status == VehicleStatus::Deadlock;
  if (!transit_ || !obeys) return;
  vehicle.status = status == NavStatus::Unreachable ? VehicleStatus::Unreachable
                   : status == NavStatus::Deadlock  ? VehicleStatus::Deadlock
                                                    : VehicleStatus::Flying;
}

void World::advance(std::uint32_t step, std::span<const VehicleCommand> commands) {
  airborne_ = true;
  auto next = commands.begin();
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    while (next != commands.end() && next->agent < vehicles_[i].spec.id) ++next;
    const bool commanded = next != commands.end() && next->agent == vehicles_[i].spec.id;
    if (commanded && next->landed) set_down(i);
    if (in_the_air(i)) move(i, step, commanded ? &*next : nullptr);
  }
  check_vehicles(step);
  check_zones(step);
  check_hidden(step);
  if (terrain_) check_terrain(step);
  movers_.advance(step);
  check_movers(step);
  check_announced(step);
  if (transit_) land();
  if (!movers_.empty()) movers_.open(step + 1, bystanders());
}

/// After the step in which it arrived, whose motion counts like any other.
void World::land() {
  for (VehicleRecord& vehicle : vehicles_) {
    if (vehicle.status != VehicleStatus::Arrived) continue;
    vehicle.landed = true;
    vehicle.state.velocity_mps = Vec3::Zero();
  }
}

void World::set_down(std::size_t i) {
  VehicleRecord& vehicle = vehicles_[i];
  const bool obeys = vehicle.status != VehicleStatus::Removed && vehicle.status != VehicleStatus::Hovering;
  if (vehicle.landed || !obeys) return;
  if (vehicle.status != VehicleStatus::Arrived) vehicle.status = VehicleStatus::Landed;
  vehicle.landed = true;
  vehicle.state.velocity_mps = Vec3::Zero();
}

void World::move(std::size_t i, std::uint32_t step, const VehicleCommand* command) {
  VehicleRecord& vehicle = vehicles_[i];
  const Vec3 wanted = vehicle.status == VehicleStatus::Hovering ? waiting_course(vehicle)
                      : command != nullptr                      ? command->velocity_mps
                                                                : vehicle.state.velocity_mps;
  const VehicleStep moved = advance_vehicle(real_spec(vehicle, step), vehicle.state, wanted, step_s_);
  motions_[i] = moved.motion;
  const double squared = vehicle.state.velocity_mps.squaredNorm();
  const Vec3 turn =
      squared > 0.0 ? Vec3(vehicle.state.velocity_mps.cross(moved.after.velocity_mps) / squared) : Vec3::Zero();
  vehicle.max_torsion_per_m =
      std::max(vehicle.max_torsion_per_m, torsion_per_m(vehicle.turn, turn, moved.motion.length_m));
  vehicle.turn = turn;
  vehicle.state = moved.after;
  vehicle.flown_m += moved.motion.length_m;
  vehicle.max_curvature_per_m = std::max(vehicle.max_curvature_per_m, moved.motion.curvature_per_m);
  if (vehicle.state.velocity_mps.head<2>().squaredNorm() > 0.0)
    vehicle.heading_rad = pose_of(vehicle.state).heading_rad;
  const bool gave_up = vehicle.status == VehicleStatus::Unreachable || vehicle.status == VehicleStatus::Deadlock;
  if (vehicle.status != VehicleStatus::Flying && !gave_up) return;
  if (command != nullptr && command->off_mission) return;
  note_arrival(i, step);
  if (transit_) return;
  const double off_m = std::sqrt((vehicle.state.position_m - vehicle.slot.position_m).squaredNorm());
  if (vehicle.status == VehicleStatus::Flying && command != nullptr && command->path_flown &&
      off_m > arrival_radius_m_ + moved.motion.length_m) {
    vehicle.status = VehicleStatus::Missed;
  }
}

void World::note_arrival(std::size_t i, std::uint32_t step) {
  VehicleRecord& vehicle = vehicles_[i];
  if (vehicle.spec.type != VehicleType::ConstantSpeed) {  // arrives to hover: it need not pass through
    if ((vehicle.state.position_m - vehicle.slot.position_m).norm() > arrival_radius_m_) return;
    vehicle.status = VehicleStatus::Arrived;
    vehicle.arrival_step = step;
    vehicle.arrival_time_s = static_cast<double>(step) * step_s_;
    return;
  }
  const Vec3 along = direction_of(vehicle.slot);
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    const Vec3 from = motions_[i].points_m[p - 1] - vehicle.slot.position_m;
    const Vec3 to = motions_[i].points_m[p] - vehicle.slot.position_m;
    const double before = from.dot(along);
    const double after = to.dot(along);
    if (!(before < 0.0 && after >= 0.0)) continue;
    const double part = before / (before - after);
    if ((from + part * (to - from)).squaredNorm() > arrival_radius_m_ * arrival_radius_m_) continue;
    const double steps = static_cast<double>(step - 1) + (static_cast<double>(p - 1) + part) / (kMotionPoints - 1);
    vehicle.status = VehicleStatus::Arrived;
    vehicle.arrival_step = step;
    vehicle.arrival_time_s = steps * step_s_;
    return;
  }
}

std::vector<PairSeparation> World::separations() const {
  std::vector<PairSeparation> pairs;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    for (std::size_t j = i + 1; j < vehicles_.size(); ++j) {
      const double least_m = least_m_[i * vehicles_.size() + j];
      PairSeparation pair{vehicles_[i].spec.id, vehicles_[j].spec.id, std::nullopt};
      if (std::isfinite(least_m)) pair.least_m = least_m;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

bool World::all_ended() const {
  return std::ranges::none_of(vehicles_, [](const auto& v) { return v.status == VehicleStatus::Flying; });
}

CellWindow World::look_of(AgentId id, std::uint32_t step) const {
  const std::size_t i = index_of(id);
  const SensorOptions& sensor = transit_.value().sensor;
  if (!in_the_air(i) || !looks_at(step, step_s_, sensor.period_s)) return {};
  return look(*truth_, sensor, seed_, {id, step, vehicles_[i].state.position_m, vehicles_[i].heading_rad});
}

std::vector<std::optional<double>> World::shortest_paths_m() const {
  if (!truth_) return {};
  std::vector<Vec3> starts_m;
  for (const VehicleRecord& vehicle : vehicles_) starts_m.push_back(vehicle.spec.start.position_m);
  return skein::shortest_paths_m(*truth_, starts_m, transit_->goals_m);
}

void World::add_to(StateHash& hash) const {
  for (const VehicleRecord& vehicle : vehicles_) {
    hash.add(vehicle.spec.id).add(vehicle.status).add(vehicle.state.position_m).add(vehicle.state.velocity_mps);
    hash.add(vehicle.arrival_step);
  }
  hash.add(contacts_.size());
  movers_.add_to(hash);
}

}  // namespace skein
