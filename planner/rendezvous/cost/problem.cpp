#include "planner/rendezvous/cost/problem.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "planner/core/geometry/distance.hpp"

namespace skein::rendezvous {
namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("rendezvous: " + what);
}

/// Whether a vehicle starts and arrives level, at one altitude.
bool is_level(const VehicleSpec& vehicle, const Pose& slot) {
  return vehicle.start.climb_rad == 0.0 && slot.climb_rad == 0.0 && vehicle.start.position_m.z() == slot.position_m.z();
}

Planar::Hermite hermite_of(Planar, const std::string& name, const Pose& start, const Pose& slot) {
  require(start.climb_rad == 0.0 && slot.climb_rad == 0.0, name + " climbs; allowed: climb 0");
  require(start.position_m.z() == slot.position_m.z(), name + " starts at another altitude than its slot");
  return Planar::Hermite({start.position_m.head<2>(), start.heading_rad},
                         {slot.position_m.head<2>(), slot.heading_rad});
}

Spatial::Hermite hermite_of(Spatial, const std::string& /*name*/, const Pose& start, const Pose& slot) {
  return Spatial::Hermite(start, slot);
}

template <typename Space>
ParticipantIn<Space> participant(const Mission& mission, const VehicleSpec& vehicle) {
  const std::string name = "vehicle " + std::to_string(vehicle.id);
  const Pose slot = slot_pose(mission, vehicle);
  require(vehicle.speed_mps > 0.0 && vehicle.speed_mps == mission.vehicles.front().speed_mps,
          name + " has another speed; allowed: one positive speed for all");
  require(vehicle.max_curvature_per_m > 0.0, name + " has no positive curvature limit");
  require(vehicle.radius_m >= 0.0 && vehicle.safety_radius_m >= 0.0, name + " has a negative radius");
  require(vehicle.start.position_m != slot.position_m, name + " starts in its slot");
  const typename Space::Hermite hermite = hermite_of(Space{}, name, vehicle.start, slot);
  const Interval range{mission.planner.search_min_chords * hermite.chord_m(),
                       mission.planner.search_max_chords * hermite.chord_m()};
  return {vehicle.id, hermite, range, slot.position_m.z(), vehicle.safety_radius_m};
}

Interval heights_of(const Zone& zone) {
  return std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.radius_m; }) {
          return Interval{shape.z_min_m, shape.z_max_m};
        } else {
          return Interval{shape.min_m.z(), shape.max_m.z()};
        }
      },
      zone.shape);
}

PlanarZone planar(const Zone& zone) {
  if (const auto* cylinder = std::get_if<Cylinder>(&zone.shape)) {
    return {zone.shape, zone.no_fly, cylinder->centre_m, cylinder->radius_m, heights_of(zone)};
  }
  const Box& box = std::get<Box>(zone.shape);
  const Vec2 half = 0.5 * (box.max_m - box.min_m).head<2>();
  return {zone.shape, zone.no_fly, box.min_m.head<2>() + half, half.norm(), heights_of(zone)};
}

bool reaches(const Zone& zone, double altitude_m, double keep_out_m) {
  const Interval heights = heights_of(zone);
  return altitude_m >= heights.min - keep_out_m && altitude_m <= heights.max + keep_out_m;
}

}  // namespace

bool is_planar(const Mission& mission) {
  return !mission.terrain && std::ranges::all_of(mission.vehicles, [&](const VehicleSpec& vehicle) {
    return is_level(vehicle, slot_pose(mission, vehicle));
  });
}

template <typename Space>
ProblemIn<Space> make_problem(const Mission& mission, AgentId self, const kernel::Kernel& kernel) {
  require(mission.kind == MissionKind::Rendezvous, "the mission is of another kind");
  require(mission.length_unit_m > 0.0, "length_unit_m must be positive");
  if (const auto fault = validate(mission.planner)) throw std::invalid_argument("rendezvous: " + fault->message);
  const VehicleSpec& own = vehicle_of(mission, self);
  ProblemIn<Space> problem;
  for (const VehicleSpec& vehicle : mission.vehicles) {
    require(problem.participants.empty() || problem.participants.back().id < vehicle.id,
            "vehicles must be listed by ascending id");
    if (vehicle.id == self) problem.self = problem.participants.size();
    problem.participants.push_back(participant<Space>(mission, vehicle));
  }
  problem.keep_out_m = own.radius_m + mission.planner.clearance_margin_m;
  for (const Zone& zone : mission.zones) {
    if (Space::kSpatial || reaches(zone, problem.own().altitude_m, problem.keep_out_m))
      problem.zones.push_back(planar(zone));
  }
  problem.max_curvature_per_m = own.max_curvature_per_m * (1.0 - kCurvatureReserve);
  problem.max_torsion_per_m = own.max_torsion_per_m * (1.0 - kCurvatureReserve);
  if (mission.terrain) {
    problem.terrain = mission.terrain;
    problem.terrain_height_m = problem.keep_out_m * tilt_of(*mission.terrain);
    problem.terrain_roof_m = highest_m(*mission.terrain) + problem.terrain_height_m;
  }
  problem.length_unit_m = mission.length_unit_m;
  problem.seed = mission.seed;
  problem.options = mission.planner;
  problem.kernel = &kernel;
  return problem;
}

template <typename Space>
const ParticipantIn<Space>& participant_of(const ProblemIn<Space>& problem, AgentId id) {
  const auto found = std::ranges::lower_bound(problem.participants, id, {}, &ParticipantIn<Space>::id);
  if (found == problem.participants.end() || found->id != id) require(false, "no participant " + std::to_string(id));
  return *found;
}

template <typename Space>
double required_separation_m(const ParticipantIn<Space>& a, const ParticipantIn<Space>& b) {
  const double sum = a.safety_radius_m + b.safety_radius_m;
  if constexpr (Space::kSpatial) return sum;
  const double height = a.altitude_m - b.altitude_m;
  return std::sqrt(std::max(0.0, sum * sum - height * height));
}

double distance_m(const PlanarZone& zone, const Vec2& p) {
  return std::visit([&](const auto& shape) { return signed_distance(p, shape); }, zone.shape);
}

double distance_m(const PlanarZone& zone, const Vec2& a, const Vec2& b) {
  return std::visit([&](const auto& shape) { return signed_distance(a, b, shape); }, zone.shape);
}

double distance_m(const PlanarZone& zone, const Vec3& p) {
  return std::visit([&](const auto& shape) { return signed_distance(p, shape); }, zone.shape);
}

double distance_m(const PlanarZone& zone, const Vec3& a, const Vec3& b) {
  return std::visit([&](const auto& shape) { return signed_distance(a, b, shape); }, zone.shape);
}

template ProblemIn<Planar> make_problem(const Mission&, AgentId, const kernel::Kernel&);
template const ParticipantIn<Planar>& participant_of(const ProblemIn<Planar>&, AgentId);
template double required_separation_m(const ParticipantIn<Planar>&, const ParticipantIn<Planar>&);
template ProblemIn<Spatial> make_problem(const Mission&, AgentId, const kernel::Kernel&);
template const ParticipantIn<Spatial>& participant_of(const ProblemIn<Spatial>&, AgentId);
template double required_separation_m(const ParticipantIn<Spatial>&, const ParticipantIn<Spatial>&);

}  // namespace skein::rendezvous
