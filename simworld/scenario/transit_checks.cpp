#include "simworld/scenario/transit_checks.hpp"

#include <fmt/core.h>

#include <cmath>

#include "planner/core/geometry/distance.hpp"
#include "simworld/sensing/truth_grid.hpp"

namespace skein::scenario {
namespace {

std::string text_of(const Vec3& p) {
  return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
}

void check_free(const TruthGrid& truth, std::string_view what, const VehicleSpec& vehicle, const Vec3& at_m,
                const Place& place) {
  const Cell cell = truth.grid().cell_of(at_m);
  if (!truth.grid().contains(cell)) {
    throw ReadFault(place, fmt::format("the {} of vehicle {} is outside the cells of the area; allowed: a point inside",
                                       what, vehicle.id));
  }
  if (!truth.occupied(cell)) return;
  throw ReadFault(place,
                  fmt::format("the {} of vehicle {} is in an occupied cell, that about {}; allowed: a point of a "
                              "free cell",
                              what, vehicle.id, text_of(at_m)));
}

/// Nobody starts within the safety radii of another.
void check_apart(const Mission& mission, const Places& places) {
  const bool cells = mission.transit->planner.name != kStraight;
  for (std::size_t j = 0; j < mission.vehicles.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const VehicleSpec& a = mission.vehicles[i];
      const VehicleSpec& b = mission.vehicles[j];
      const double apart_m = (a.start.position_m - b.start.position_m).norm();
      const double least_m = a.safety_radius_m + b.safety_radius_m;
      if (apart_m >= least_m && apart_m > 0.0) continue;
      const Place& place = places.starts[i].set_key.empty() ? places.starts[j] : places.starts[i];
      throw ReadFault(
          place, fmt::format("{} {} and {} start {}{} m apart; allowed: {}at least {} m, their safety radii together",
                             cells ? "the centres of the cells in which vehicles" : "vehicles", a.id, b.id,
                             cells ? "are " : "", apart_m, cells ? "different cells, " : "", least_m));
    }
  }
}

double distance_to(const Zone& zone, const Vec3& point_m) {
  return std::visit([&](const auto& shape) { return signed_distance(point_m, shape); }, zone.shape);
}

void check_room(const Mission& mission, std::string_view what, const VehicleSpec& vehicle, const Vec3& at_m,
                const Place& place) {
  const Box& area = mission.transit->area;
  const bool inside = (at_m.array() >= area.min_m.array()).all() && (at_m.array() <= area.max_m.array()).all();
  if (!inside) {
    throw ReadFault(place, fmt::format("the {} of vehicle {}, {}, is outside the area; allowed: a point inside", what,
                                       vehicle.id, text_of(at_m)));
  }
  for (const Zone& zone : mission.zones) {
    if (distance_to(zone, at_m) > vehicle.radius_m) continue;
    throw ReadFault(place, fmt::format("the {} of vehicle {} is in an obstacle or no-fly zone; allowed: more than {} m "
                                       "from it, its radius",
                                       what, vehicle.id, vehicle.radius_m));
  }
}

void check_way(const Mission& mission, std::size_t i, const Places& places) {
  const VehicleSpec& vehicle = mission.vehicles[i];
  const double apart_m = (vehicle.start.position_m - mission.transit->goals_m[i]).norm();
  if (apart_m > mission.transit->goal_radius_m) return;
  throw ReadFault(places.starts[i],
                  fmt::format("vehicle {} starts {} m from its goal; allowed: more than goal_radius_m, {} m",
                              vehicle.id, apart_m, mission.transit->goal_radius_m));
}

/// Without cells: in the area, apart, and clear of what is known.
void check_straight(const Mission& mission, const Places& places) {
  check_apart(mission, places);
  for (std::size_t i = 0; i < mission.vehicles.size(); ++i) {
    const VehicleSpec& vehicle = mission.vehicles[i];
    check_room(mission, "start", vehicle, vehicle.start.position_m, places.starts[i]);
    check_room(mission, "goal", vehicle, mission.transit->goals_m[i], places.slots[i]);
    check_way(mission, i, places);
  }
}

void check_options(const Mission& mission, const Places& places) {
  const TransitOptions& options = mission.transit->planner;
  const double body_m = 2.0 * mission.vehicles.front().radius_m;
  if (options.cell_m < body_m || options.cell_height_m < body_m) {
    throw ReadFault(places.cells,
                    fmt::format("a cell of {} m by {} m is smaller than a vehicle; allowed: at least {} m",
                                options.cell_m, options.cell_height_m, body_m));
  }
  const double steps = options.decision_s / mission.step_s;
  const double whole = std::floor(steps + 0.5);
  if (whole >= 1.0 && std::fabs(steps - whole) <= 1e-9 * whole) return;
  throw ReadFault(places.decision, fmt::format("planner.decision_s is {} s; allowed: a whole number of steps of {} s",
                                               options.decision_s, mission.step_s));
}

}  // namespace

void check_transit(const Scenario& scenario, const Places& places) {
  const Mission& mission = scenario.mission;
  if (mission.transit->planner.name == kStraight) return check_straight(mission, places);
  check_options(mission, places);
  check_apart(mission, places);
  const TruthGrid truth(grid_of(*mission.transit), all_obstacles(mission, scenario.world.hidden));
  for (std::size_t i = 0; i < mission.vehicles.size(); ++i) {
    const VehicleSpec& vehicle = mission.vehicles[i];
    const Vec3& goal_m = mission.transit->goals_m[i];
    check_free(truth, "start", vehicle, vehicle.start.position_m, places.starts[i]);
    check_free(truth, "goal", vehicle, goal_m, places.slots[i]);
    check_way(mission, i, places);
  }
}

}  // namespace skein::scenario
