#include "idl/convert/transit_wire.hpp"

#include "idl/convert/limits.hpp"
#include "idl/convert/option_values.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

void check_crossing(Checker& check, const wire::Crossing& transit, std::size_t vehicles) {
  check.position(transit.area_min_m(), "mission.transit.area");
  check.position(transit.area_max_m(), "mission.transit.area");
  const Vec3 width_m = plain_point(transit.area_max_m()) - plain_point(transit.area_min_m());
  check.require(width_m.minCoeff() >= 0.0, WireFaultReason::BadMission, "mission.transit.area");
  check.within(transit.goal_radius_m(), 0.0, limits::kPosition_m, "mission.transit.goal_radius_m");
  check.require(transit.goals_m().size() == vehicles, WireFaultReason::BadMission, "mission.transit.goals_m");
  if (!check.ok()) return;
  for (const wire::Point3& goal_m : transit.goals_m()) check.position(goal_m, "mission.transit.goals_m");
  check_values(check, transit.planner_values(), kTransitFields, "mission.transit.planner");
  check_values(check, transit.radio_values(), kRadioFields, "mission.transit.radio");
  check_values(check, transit.sensor_values(), kSensorFields, "mission.transit.sensor");
  const auto known = transit_defaults_of(transit.planner_name().c_str());
  check.require(known.has_value(), WireFaultReason::BadOptions, "mission.transit.planner");
}

}  // namespace

wire::Crossing wire_transit(const TransitMission& transit) {
  wire::Crossing out;
  require_bound(transit.planner.name.size(), out.planner_name().max_size, "transit.planner.name");
  require_bound(transit.goals_m.size(), wire::kMaxVehicles, "transit.goals_m");
  out.area_min_m(wire_point(transit.area.min_m));
  out.area_max_m(wire_point(transit.area.max_m));
  out.goal_radius_m(transit.goal_radius_m);
  out.planner_name(transit.planner.name);
  out.planner_values(values_of(transit.planner, kTransitFields));
  out.radio_values(values_of(transit.radio, kRadioFields));
  out.sensor_values(values_of(transit.sensor, kSensorFields));
  for (const Vec3& goal_m : transit.goals_m) out.goals_m().push_back(wire_point(goal_m));
  return out;
}

TransitMission plain_transit(const wire::Crossing& transit) {
  TransitMission out;
  out.area = {plain_point(transit.area_min_m()), plain_point(transit.area_max_m())};
  out.goal_radius_m = transit.goal_radius_m();
  out.planner = options_of(transit.planner_values(), kTransitFields);
  out.planner.name = transit.planner_name().to_string();
  out.radio = options_of(transit.radio_values(), kRadioFields);
  out.sensor = options_of(transit.sensor_values(), kSensorFields);
  for (const wire::Point3& goal_m : transit.goals_m()) out.goals_m.push_back(plain_point(goal_m));
  return out;
}

void check_transit(Checker& check, const wire::Mission& sample) {
  const bool crosses = sample.kind() == static_cast<std::uint8_t>(MissionKind::Transit);
  check.require(sample.transit().size() == (crosses ? 1U : 0U), WireFaultReason::BadMission, "mission.transit");
  if (!check.ok()) return;
  for (const wire::Crossing& transit : sample.transit()) check_crossing(check, transit, sample.vehicles().size());
}

}  // namespace skein
