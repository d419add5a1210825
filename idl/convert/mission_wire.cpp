#include <array>
#include <utility>

#include "idl/convert/area_wire.hpp"
#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/option_values.hpp"
#include "idl/convert/parts.hpp"
#include "idl/convert/transit_wire.hpp"

namespace skein {
namespace {

wire::Vehicle wire_vehicle(const VehicleSpec& spec) {
  wire::Vehicle out;
  out.agent(spec.id);
  out.start(wire_pose(spec.start));
  out.slot_offset_m(wire_point(spec.slot_offset_m));
  out.kind(static_cast<std::uint8_t>(spec.type));
  out.speed_mps(spec.speed_mps);
  out.max_curvature_per_m(spec.max_curvature_per_m);
  out.radius_m(spec.radius_m);
  out.safety_radius_m(spec.safety_radius_m);
  out.max_torsion_per_m(spec.max_torsion_per_m);
  out.max_acceleration_mps2(spec.max_acceleration_mps2);
  return out;
}

VehicleSpec plain_vehicle(const wire::Vehicle& vehicle) {
  VehicleSpec out;
  out.id = vehicle.agent();
  out.start = plain_pose(vehicle.start());
  out.slot_offset_m = plain_point(vehicle.slot_offset_m());
  out.type = static_cast<VehicleType>(vehicle.kind());
  out.speed_mps = vehicle.speed_mps();
  out.max_curvature_per_m = vehicle.max_curvature_per_m();
  out.radius_m = vehicle.radius_m();
  out.safety_radius_m = vehicle.safety_radius_m();
  out.max_torsion_per_m = vehicle.max_torsion_per_m();
  out.max_acceleration_mps2 = vehicle.max_acceleration_mps2();
  return out;
}

void check_vehicle(Checker& check, const wire::Vehicle& vehicle) {
  check.agent(vehicle.agent(), "mission.vehicles.agent");
  check.pose(vehicle.start(), "mission.vehicles.start");
  check.position(vehicle.slot_offset_m(), "mission.vehicles.slot_offset_m");
  check.enumerator(vehicle.kind(), VehicleType::ConstantSpeed, VehicleType::Holonomic, "mission.vehicles.kind");
  check.within(vehicle.speed_mps(), 0.0, limits::kSpeed_mps, "mission.vehicles.speed_mps");
  check.within(vehicle.max_curvature_per_m(), 0.0, limits::kCurvature_per_m, "mission.vehicles.max_curvature_per_m");
  check.within(vehicle.radius_m(), 0.0, limits::kPosition_m, "mission.vehicles.radius_m");
  check.within(vehicle.safety_radius_m(), 0.0, limits::kPosition_m, "mission.vehicles.safety_radius_m");
  check.within(vehicle.max_torsion_per_m(), 0.0, limits::kCurvature_per_m, "mission.vehicles.max_torsion_per_m");
  const bool hovers = vehicle.kind() == static_cast<std::uint8_t>(VehicleType::Multirotor);
  check.within(vehicle.max_acceleration_mps2(), hovers ? limits::kLeastAcceleration_mps2 : 0.0,
               hovers ? limits::kAcceleration_mps2 : 0.0, "mission.vehicles.max_acceleration_mps2");
}

/// The constants of a terrain, on both sides alike.
constexpr std::array kConstants{&Terrain::a, &Terrain::b, &Terrain::c, &Terrain::d, &Terrain::e,
                                &Terrain::f, &Terrain::g, &Terrain::h, &Terrain::l};

std::array<double, kConstants.size()> constants_of(const wire::Ground& ground) {
  return {ground.a(), ground.b(), ground.c(), ground.d(), ground.e(), ground.f(), ground.g(), ground.h(), ground.l()};
}

wire::Ground wire_terrain(const Terrain& terrain) {
  wire::Ground out;
  out.a(terrain.a);
  out.b(terrain.b);
  out.c(terrain.c);
  out.d(terrain.d);
  out.e(terrain.e);
  out.f(terrain.f);
  out.g(terrain.g);
  out.h(terrain.h);
  out.l(terrain.l);
  return out;
}

Terrain plain_terrain(const wire::Ground& ground, double unit_m) {
  Terrain out;
  const auto constants = constants_of(ground);
  for (std::size_t i = 0; i < kConstants.size(); ++i) out.*kConstants[i] = constants[i];
  out.unit_m = unit_m;
  return out;
}

void check_options(Checker& check, const RendezvousOptions& options) {
  for (const RendezvousField& field : kRendezvousFields) {
    if (const auto* real = std::get_if<double RendezvousOptions::*>(&field.member)) {
      check.within(options.**real, -limits::kCost, limits::kCost, "mission.planner");
    }
  }
  check.require(!check.ok() || !validate(options).has_value(), WireFaultReason::BadOptions, "mission.planner");
}

void check_controller(Checker& check, const wire::Mission& sample) {
  check_values(check, sample.controller_values(), kControllerFields, "mission.controller");
  ControllerOptions named;
  named.name = sample.controller_name().to_string();
  check.require(!validate(named).has_value(), WireFaultReason::BadOptions, "mission.controller");
}

void check_announced(Checker& check, const wire::Mission& sample) {
  check.size_at_most(sample.announced().size(), wire::kMaxAnnounced, "mission.announced");
  if (!check.ok()) return;
  for (const wire::Announced& announced : sample.announced()) {
    check_area(check, announced.place(), "mission.announced");
    for (const double time_s : {announced.from_s(), announced.to_s(), announced.early_s(), announced.clear_s()}) {
      check.within(time_s, 0.0, limits::kTime_s, "mission.announced");
    }
    check.require(announced.from_s() <= announced.to_s(), WireFaultReason::BadMission, "mission.announced.to_s");
  }
}

void check_scalars(Checker& check, const wire::Mission& sample) {
  check.sender(sample.head(), kWorldId, "mission.head.sender");
  check.run(sample.head().run(), "mission.head.run");
  check.text(sample.name().c_str(), "mission.name");
  check.enumerator(sample.kind(), MissionKind::Rendezvous, MissionKind::Transit, "mission.kind");
  check.within(sample.length_unit_m(), limits::kUnitMin_m, limits::kUnitMax_m, "mission.length_unit_m");
  check.within(sample.step_s(), 0.0, limits::kStep_s, "mission.step_s");
  check.require(sample.step_s() > 0.0, WireFaultReason::OutOfRange, "mission.step_s");
  check.pose(sample.formation(), "mission.formation");
  check.within(sample.arrival_radius_m(), 0.0, limits::kPosition_m, "mission.arrival_radius_m");
  check.size_at_most(sample.vehicles().size(), wire::kMaxVehicles, "mission.vehicles");
  check.size_at_most(sample.zones().size(), wire::kMaxZones, "mission.zones");
  check.size_at_most(sample.terrain().size(), 1, "mission.terrain");
  for (const wire::Ground& ground : sample.terrain()) {
    for (const double constant : constants_of(ground)) {
      check.within(constant, -limits::kTerrain, limits::kTerrain, "mission.terrain");
    }
  }
  check.require(!sample.vehicles().empty(), WireFaultReason::BadMission, "mission.vehicles");
}

}  // namespace

wire::Mission to_wire(const Mission& mission, const Stamp& stamp) {
  require_bound(mission.name.size(), wire::kMaxName, "mission.name");
  require_bound(mission.vehicles.size(), wire::kMaxVehicles, "mission.vehicles");
  require_bound(mission.zones.size(), wire::kMaxZones, "mission.zones");
  require_bound(mission.announced.size(), wire::kMaxAnnounced, "mission.announced");
  wire::Mission out;
  out.head(wire_head(stamp.run, stamp.stamp_ns, kWorldId, 0));
  out.name(mission.name);
  out.kind(static_cast<std::uint8_t>(mission.kind));
  out.seed(mission.seed);
  out.length_unit_m(mission.length_unit_m);
  out.step_s(mission.step_s);
  out.formation(wire_pose(mission.formation));
  out.arrival_radius_m(mission.arrival_radius_m);
  for (const VehicleSpec& vehicle : mission.vehicles) out.vehicles().push_back(wire_vehicle(vehicle));
  for (const Zone& zone : mission.zones) out.zones().push_back(wire_area(zone));
  if (mission.terrain) out.terrain().push_back(wire_terrain(*mission.terrain));
  out.planner(wire_options(mission.planner));
  if (mission.transit) out.transit().push_back(wire_transit(*mission.transit));
  out.controller_name(mission.controller.name);
  out.controller_values(values_of(mission.controller, kControllerFields));
  for (const Announcement& announced : mission.announced) out.announced().push_back(wire_announced(announced));
  return out;
}

Checked<Mission> from_wire(const wire::Mission& sample, const WireContext& context) {
  const WireContext own{.run = context.run, .known = {}, .roster = {}, .particle_size = 0};
  Checker check(own);
  check_scalars(check, sample);
  if (!check.ok()) return check.fault();
  std::uint32_t before = 0;
  for (const wire::Vehicle& vehicle : sample.vehicles()) {
    check_vehicle(check, vehicle);
    check.require(vehicle.agent() > before, WireFaultReason::BadOrder, "mission.vehicles");
    before = vehicle.agent();
  }
  for (const wire::Area& area : sample.zones()) check_area(check, area, "mission.zones");
  check_transit(check, sample);
  check_controller(check, sample);
  check_announced(check, sample);

  Mission out;
  out.planner = plain_options(sample.planner());
  check_options(check, out.planner);
  if (!check.ok()) return check.fault();
  for (const wire::Crossing& transit : sample.transit()) out.transit = plain_transit(transit);
  out.name = sample.name().to_string();
  out.kind = static_cast<MissionKind>(sample.kind());
  out.seed = sample.seed();
  out.length_unit_m = sample.length_unit_m();
  out.step_s = sample.step_s();
  out.formation = plain_pose(sample.formation());
  out.arrival_radius_m = sample.arrival_radius_m();
  for (const wire::Vehicle& vehicle : sample.vehicles()) out.vehicles.push_back(plain_vehicle(vehicle));
  for (const wire::Area& area : sample.zones()) out.zones.push_back(plain_zone(area));
  out.controller = options_of(sample.controller_values(), kControllerFields);
  out.controller.name = sample.controller_name().to_string();
  for (const wire::Announced& announced : sample.announced()) out.announced.push_back(plain_announced(announced));
  for (const wire::Ground& ground : sample.terrain()) out.terrain = plain_terrain(ground, out.length_unit_m);
  return out;
}

}  // namespace skein
