#include "simworld/movers/appearance.hpp"

#include "planner/core/geometry/braking.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {

double least_appearance_m(const VehicleSpec& spec, double speed_mps, double obstacle_speed_mps, double step_s) {
  if (spec.type == VehicleType::Multirotor) {
    const Brakes brakes{spec.max_acceleration_mps2, step_s};
    return stopping_distance_m(brakes, speed_mps) + obstacle_speed_mps * stopping_time_s(brakes, speed_mps);
  }
  double way_m = speed_mps * step_s;
  double time_s = step_s;
  if (spec.type == VehicleType::Holonomic) {
    time_s += step_s;
  } else {
    const double radius_m = 1.0 / spec.max_curvature_per_m;
    way_m += 2.0 * radius_m;
    time_s += math::kPi * radius_m / spec.speed_mps;
  }
  return way_m + obstacle_speed_mps * time_s;
}

}  // namespace skein
