#include <algorithm>
#include <stdexcept>

#include "planner/core/geometry/closest_approach.hpp"
#include "simworld/collision/clearance.hpp"
#include "simworld/world/world.hpp"

namespace skein {
namespace {

/// Least distance (m) between the centres of a vehicle and of a mover, which moves in a straight line.
double least_distance_m(const Motion& motion, const MoverRecord& mover) {
  double least_m = std::numeric_limits<double>::infinity();
  const Vec3 way_m = mover.position_m - mover.before_m;
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    const double parts = static_cast<double>(kMotionPoints - 1);
    const Vec3 from_m = mover.before_m + (static_cast<double>(p - 1) / parts) * way_m;
    const Vec3 to_m = mover.before_m + (static_cast<double>(p) / parts) * way_m;
    const Vec3& a = motion.points_m[p - 1];
    const Vec3& b = motion.points_m[p];
    const double distance_m = mover.spec.column ? closest_approach(Vec2(a.head<2>()), Vec2(b.head<2>()),
                                                                   Vec2(from_m.head<2>()), Vec2(to_m.head<2>()))
                                                      .distance_m
                                                : closest_approach(a, b, from_m, to_m).distance_m;
    least_m = std::min(least_m, distance_m);
  }
  return least_m;
}

}  // namespace

void World::prepare(const Mission& mission, const Surprises& surprises) {
  slow_ = surprises.slow;
  announced_ = mission.announced;
  std::vector<Mover> movers = surprises.movers;
  for (std::size_t i = 0; i < announced_.size(); ++i) {
    const Traffic traffic = i < surprises.traffic.size() ? surprises.traffic[i] : Traffic{};
    occupations_.push_back(occupation_of(announced_[i], traffic, seed_, i));
    if (!traffic.aircraft) continue;
    movers.push_back(mover_of(*traffic.aircraft, occupations_.back(), "announced." + std::to_string(i + 1)));
  }
  in_closed_.resize(vehicles_.size() * announced_.size());
  if (movers.empty()) return;
  std::vector<Vec3> goals_m;
  double clearance_m = 0.0;
  for (const VehicleRecord& vehicle : vehicles_) {
    goals_m.push_back(vehicle.slot.position_m);
    clearance_m = std::max(clearance_m, 2.0 * vehicle.spec.safety_radius_m);
  }
  movers_ = Movers(std::move(movers), std::move(goals_m), clearance_m, seed_, step_s_);
  in_mover_.resize(vehicles_.size() * movers_.all().size());
  rammed_.resize(in_mover_.size());
  movers_.open(1, bystanders());
}

void World::inject(const Injection& obstacle, std::uint32_t step) {
  Mover mover;
  mover.name = "injected." + std::to_string(++injected_);
  mover.position_m = obstacle.position_m;
  mover.radius_m = obstacle.radius_m;
  mover.column = obstacle.column;
  if (obstacle.velocity_mps != Vec3::Zero()) mover.motion = LineMotion{obstacle.velocity_mps};
  const std::size_t before = movers_.all().size();
  movers_.add(std::move(mover), step, step_s_);
  for (std::vector<bool>* touching : {&in_mover_, &rammed_}) {  // vehicle x mover, one column more
    std::vector<bool> wider(vehicles_.size() * (before + 1));
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      for (std::size_t m = 0; m < before; ++m) wider[i * (before + 1) + m] = (*touching)[i * before + m];
    }
    *touching = std::move(wider);
  }
}

std::vector<Bystander> World::bystanders() const {
  std::vector<Bystander> all;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    const VehicleRecord& vehicle = vehicles_[i];
    all.push_back({vehicle.spec, vehicle.state.position_m, vehicle.state.velocity_mps, in_the_air(i)});
  }
  return all;
}

VehicleSpec World::real_spec(const VehicleRecord& vehicle, std::uint32_t step) const {
  VehicleSpec spec = vehicle.spec;
  const double time_s = step_s_ * static_cast<double>(step - 1);
  for (const SlowVehicle& slow : slow_) {
    if (slow.id == spec.id && time_s >= slow.from_s) spec.speed_mps = slow.factor * vehicle.spec.speed_mps;
  }
  return spec;
}

bool World::obeys(AgentId id) const {
  const std::size_t i = index_of(id);
  return in_the_air(i) && vehicles_[i].status != VehicleStatus::Hovering;
}

std::vector<Track> World::tracks_of(AgentId id, double range_m) const {
  const std::size_t i = index_of(id);
  std::vector<Track> tracks;
  if (!in_the_air(i)) return tracks;
  for (const MoverRecord& mover : movers_.all()) {
    const Mover& spec = mover.spec;
    if (!mover.present) continue;
    const double centre_m = distance_m(vehicles_[i].state.position_m, mover.position_m, spec.column);
    if (centre_m - spec.radius_m > range_m) continue;
    const bool fixed = std::holds_alternative<StillMotion>(spec.motion);
    tracks.push_back({mover.id, mover.position_m, mover.velocity_mps, spec.radius_m, spec.column, fixed});
  }
  return tracks;
}

std::vector<ZoneState> World::zone_states(std::uint32_t step) const {
  std::vector<ZoneState> states;
  for (std::size_t z = 0; z < announced_.size(); ++z) {
    states.push_back(state_in(announced_[z], occupations_[z], step, step_s_));
  }
  return states;
}

void World::check_movers(std::uint32_t step) {
  const std::vector<MoverRecord>& movers = movers_.all();
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    for (std::size_t m = 0; m < movers.size(); ++m) {
      const std::size_t key = i * movers.size() + m;
      if (!in_the_air(i) || !movers[m].present) {
        in_mover_[key] = rammed_[key] = false;
        continue;
      }
      const double apart_m = least_distance_m(motions_[i], movers[m]);
      const double body_m = apart_m - vehicles_[i].spec.radius_m - movers[m].spec.radius_m;
      min_clearance_m_ = std::min(min_clearance_m_.value_or(body_m), body_m);
      const bool at_rest = motions_[i].length_m <= kAtRest_m;
      note(body_m <= 0.0, at_rest ? rammed_ : in_mover_, key,
           {at_rest ? ContactKind::Rammed : ContactKind::Mover, step, vehicles_[i].spec.id,
            static_cast<std::uint32_t>(m), apart_m});
    }
  }
}

void World::check_announced(std::uint32_t step) {
  const std::vector<ZoneState> states = zone_states(step);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (!in_the_air(i)) continue;
    for (std::size_t z = 0; z < announced_.size(); ++z) {
      const double apart_m = clearance_m(motions_[i], Zone{announced_[z].shape, true});
      const bool inside = is_closed(states[z]) && apart_m - vehicles_[i].spec.radius_m <= 0.0;
      note(inside, in_closed_, i * announced_.size() + z,
           {ContactKind::ZoneEntry, step, vehicles_[i].spec.id, static_cast<std::uint32_t>(z), apart_m});
    }
  }
}

}  // namespace skein
