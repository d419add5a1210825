#include "tests/planner/rendezvous/layouts.hpp"

#include "planner/core/math/det_math.hpp"

namespace skein::test {
namespace {

VehicleSpec vehicle(AgentId id, double x_km, double y_km, double heading_rad, double slot_x_km, double slot_y_km) {
  VehicleSpec spec;
  spec.id = id;
  spec.start.position_m = Vec3(1000.0 * x_km, 1000.0 * y_km, 0.0);
  spec.start.heading_rad = heading_rad;
  spec.slot_offset_m = Vec3(1000.0 * slot_x_km, 1000.0 * slot_y_km, 0.0);
  spec.speed_mps = 50.0;
  spec.max_curvature_per_m = 0.002;
  spec.radius_m = 2.0;
  spec.safety_radius_m = 100.0;
  return spec;
}

}  // namespace

Zone circle_km(double x, double y, double radius) {
  Cylinder cylinder;
  cylinder.centre_m = Vec2(1000.0 * x, 1000.0 * y);
  cylinder.radius_m = 1000.0 * radius;
  return {cylinder, false};
}

Zone rectangle_km(double x_min, double x_max, double y_min, double y_max) {
  Box box;
  box.min_m.head<2>() = Vec2(1000.0 * x_min, 1000.0 * y_min);
  box.max_m.head<2>() = Vec2(1000.0 * x_max, 1000.0 * y_max);
  return {box, true};
}

Mission open_field(std::uint64_t seed) {
  Mission mission;
  mission.name = "open-field";
  mission.seed = seed;
  mission.length_unit_m = 1000.0;
  mission.step_s = 0.5;
  mission.formation.position_m = Vec3(30000.0, 15000.0, 0.0);
  mission.arrival_radius_m = 50.0;
  mission.vehicles = {vehicle(1, 2.0, -5.0, math::kPi / 6.0, 0.6, 0.0),
                      vehicle(2, -1.0, 10.0, -math::kPi / 4.0, -0.3, -0.6),
                      vehicle(3, -3.0, 20.0, -math::kPi / 5.0, -0.3, 0.6)};
  return mission;
}

Mission layout_a(std::uint64_t seed) {
  Mission mission = open_field(seed);
  mission.name = "layout-a";
  mission.zones = {circle_km(11.0, 6.0, 2.0), circle_km(6.5, 17.5, 3.0), rectangle_km(20.0, 25.0, 2.0, 6.0),
                   rectangle_km(14.0, 20.0, 18.0, 20.0)};
  return mission;
}

Mission layout_b(std::uint64_t seed) {
  Mission mission = open_field(seed);
  mission.name = "layout-b";
  mission.zones = {circle_km(12.0, 5.0, 1.5), circle_km(23.0, 5.0, 2.0), rectangle_km(9.0, 14.0, 14.0, 18.0),
                   rectangle_km(16.0, 20.0, 18.0, 20.0)};
  return mission;
}

Mission layout_clutter(std::uint64_t seed) {
  Mission mission = open_field(seed);
  mission.name = "layout-clutter";
  mission.zones = {circle_km(12.0, 13.0, 1.0),          circle_km(25.0, 10.0, 1.0),
                   circle_km(3.0, 16.0, 1.0),           circle_km(15.0, -8.0, 4.0),
                   rectangle_km(8.0, 10.0, -12.0, 3.0), rectangle_km(8.0, 10.0, 15.0, 30.0),
                   rectangle_km(15.0, 17.0, 9.0, 26.0)};
  return mission;
}

Mission open_space(std::uint64_t seed) {
  Mission mission = open_field(seed);
  mission.name = "open-space";
  mission.formation.position_m.z() = 3000.0;
  mission.formation.heading_rad = math::kPi / 9.0;
  const double heights_km[] = {2.3, 2.0, 3.3};
  const double climbs_rad[] = {math::kPi / 12.0, math::kPi / 8.0, -math::kPi / 7.0};
  for (std::size_t i = 0; i < 3; ++i) {
    mission.vehicles[i].start.position_m.z() = 1000.0 * heights_km[i];
    mission.vehicles[i].start.climb_rad = climbs_rad[i];
    mission.vehicles[i].max_torsion_per_m = 0.002;
  }
  return mission;
}

Mission layout_space(std::uint64_t seed) {
  Mission mission = open_space(seed);
  mission.name = "layout-space";
  mission.zones = {circle_km(11.0, 6.0, 2.0), circle_km(6.5, 17.5, 3.0), rectangle_km(20.0, 25.0, 2.0, 6.0),
                   rectangle_km(14.0, 20.0, 18.0, 20.0), rectangle_km(10.0, 18.0, 8.0, 12.0)};
  std::get<Cylinder>(mission.zones[0].shape).z_max_m = 4000.0;
  std::get<Cylinder>(mission.zones[1].shape).z_max_m = 2800.0;
  std::get<Box>(mission.zones[4].shape).min_m.z() = 3400.0;
  mission.terrain = Terrain{0.5, -1.15, 0.5, 3.42, 0.6, 0.327, 0.5, 0.08, 0.05, 1000.0};
  return mission;
}

Mission ring(std::uint64_t seed, int n, double start_m, double slot_m) {
  Mission mission = open_field(seed);
  const VehicleSpec model = mission.vehicles[0];
  mission.vehicles.clear();
  mission.formation.position_m.setZero();
  for (int k = 0; k < n; ++k) {
    VehicleSpec vehicle = model;
    const double at = math::kTwoPi * k / n;
    const Vec3 outward(math::cos(at), math::sin(at), 0.0);
    vehicle.id = static_cast<AgentId>(k + 1);
    vehicle.start.position_m = start_m * outward;
    vehicle.start.heading_rad = math::wrap_angle(at + math::kPi + 1.0);
    vehicle.slot_offset_m = -slot_m * outward;
    mission.vehicles.push_back(vehicle);
  }
  return mission;
}

Mission as_points(Mission mission) {
  for (VehicleSpec& spec : mission.vehicles) spec.radius_m = 0.0;
  mission.planner.clearance_margin_m = 0.0;
  return mission;
}

}  // namespace skein::test
