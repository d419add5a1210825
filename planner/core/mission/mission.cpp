#include "planner/core/mission/mission.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "planner/core/math/det_math.hpp"

namespace skein {

std::vector<AgentId> ids_of(const Mission& mission) {
  std::vector<AgentId> ids;
  for (const VehicleSpec& vehicle : mission.vehicles) ids.push_back(vehicle.id);
  return ids;
}

const VehicleSpec& vehicle_of(const Mission& mission, AgentId id) {
  const auto found = std::ranges::find(mission.vehicles, id, &VehicleSpec::id);
  if (found == mission.vehicles.end()) {
    throw std::invalid_argument("the mission has no vehicle " + std::to_string(id));
  }
  return *found;
}

std::uint32_t steps_per_decision(const Mission& mission) {
  const double steps = std::floor(mission.transit->planner.decision_s / mission.step_s + 0.5);
  return steps < 1.0 ? 1 : static_cast<std::uint32_t>(steps);
}

Pose slot_pose(const Mission& mission, const VehicleSpec& vehicle) {
  const double c = math::cos(mission.formation.heading_rad);
  const double s = math::sin(mission.formation.heading_rad);
  const Vec3& offset = vehicle.slot_offset_m;
  Pose pose = mission.formation;
  pose.position_m += Vec3(c * offset.x() - s * offset.y(), s * offset.x() + c * offset.y(), offset.z());
  return pose;
}

namespace {

void add_shape(StateHash& hash, const std::variant<Cylinder, Box>& shape) {
  hash.add(shape.index());
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    hash.add(cylinder->centre_m).add(cylinder->radius_m).add(cylinder->z_min_m).add(cylinder->z_max_m);
  } else {
    const auto& box = std::get<Box>(shape);
    hash.add(box.min_m).add(box.max_m);
  }
}

void add_zone(StateHash& hash, const Zone& zone) {
  hash.add(zone.no_fly);
  add_shape(hash, zone.shape);
}

/// What planar missions of constant-speed vehicles leave out enters the hash only when it is there.
void add_space(StateHash& hash, const Mission& mission) {
  for (const VehicleSpec& v : mission.vehicles) {
    if (v.max_torsion_per_m != kUnlimitedTorsion_per_m) hash.add(v.id).add(v.max_torsion_per_m);
    if (v.type == VehicleType::Multirotor) hash.add(v.id).add(v.max_acceleration_mps2);
  }
  if (!mission.terrain) return;
  const Terrain& t = *mission.terrain;
  for (const double constant : {t.a, t.b, t.c, t.d, t.e, t.f, t.g, t.h, t.l, t.unit_m}) hash.add(constant);
}

void add_options(StateHash& hash, const RendezvousOptions& options) {
  const auto value_of = [](const RendezvousOptions& of, const RendezvousField& field) {
    return std::visit([&](auto member) { return static_cast<double>(of.*member); }, field.member);
  };
  hash.add(std::string_view(options.name));
  for (std::size_t i = 0; i < kRendezvousFields.size(); ++i) {
    const double value = value_of(options, kRendezvousFields[i]);
    if (i < kAlwaysHashedFields) {
      hash.add(value);
    } else if (value != value_of(RendezvousOptions{}, kRendezvousFields[i])) {
      hash.add(kRendezvousFields[i].key).add(value);
    }
  }
}

template <typename Options, std::size_t N>
void add_fields(StateHash& hash, const Options& options, const std::array<OptionField<Options>, N>& fields) {
  for (const OptionField<Options>& field : fields) hash.add(field.key).add(options.*field.member);
}

void add_transit(StateHash& hash, const TransitMission& transit) {
  hash.add(transit.area.min_m).add(transit.area.max_m).add(transit.goal_radius_m).add(transit.goals_m.size());
  for (const Vec3& goal_m : transit.goals_m) hash.add(goal_m);
  hash.add(std::string_view(transit.planner.name));
  add_fields(hash, transit.planner, kTransitFields);
  add_fields(hash, transit.radio, kRadioFields);
  add_fields(hash, transit.sensor, kSensorFields);
}

/// Missions in which nothing is sensed or announced keep the hashes that they had before there was such a thing.
void add_surprises(StateHash& hash, const Mission& mission) {
  if (mission.controller != ControllerOptions{}) {
    hash.add(std::string_view(mission.controller.name));
    add_fields(hash, mission.controller, kControllerFields);
  }
  for (const Announcement& zone : mission.announced) {
    add_shape(hash, zone.shape);
    hash.add(zone.from_s).add(zone.to_s).add(zone.early_s).add(zone.clear_s);
  }
}

}  // namespace

std::uint64_t mission_hash(const Mission& mission) {
  StateHash hash;
  hash.add(std::string_view(mission.name)).add(mission.kind).add(mission.seed).add(mission.length_unit_m);
  hash.add(mission.step_s).add(mission.formation).add(mission.arrival_radius_m).add(mission.vehicles.size());
  for (const VehicleSpec& v : mission.vehicles) {
    hash.add(v.id).add(v.start).add(v.slot_offset_m).add(v.type).add(v.speed_mps).add(v.max_curvature_per_m);
    hash.add(v.radius_m).add(v.safety_radius_m);
  }
  hash.add(mission.zones.size());
  for (const Zone& zone : mission.zones) add_zone(hash, zone);
  add_options(hash, mission.planner);
  add_space(hash, mission);
  if (mission.transit) add_transit(hash, *mission.transit);
  add_surprises(hash, mission);
  return hash.value();
}

}  // namespace skein
