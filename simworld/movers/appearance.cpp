#include "simworld/movers/appearance.hpp"

#include <cmath>

#include "planner/core/math/det_math.hpp"

namespace skein {

double least_appearance_m(const VehicleSpec& spec, double speed_mps, double obstacle_speed_mps, double step_s) {
  double way_m = speed_mps * step_s;
  double time_s = step_s;
  if (spec.type == VehicleType::Multirotor) {
    // in whole steps braking takes up to a dt^2 / 8 more than v^2 / 2a
    way_m += speed_mps * speed_mps / (2.0 * spec.max_acceleration_mps2);
    way_m += spec.max_acceleration_mps2 * step_s * step_s / 8.0;
    time_s += step_s * std::ceil(speed_mps / (spec.max_acceleration_mps2 * step_s));
  } else if (spec.type == VehicleType::Holonomic) {
    time_s += step_s;
  } else {
    const double radius_m = 1.0 / spec.max_curvature_per_m;
    way_m += 2.0 * radius_m;
    time_s += math::kPi * radius_m / spec.speed_mps;
  }
  return way_m + obstacle_speed_mps * time_s;
}

}  // namespace skein
