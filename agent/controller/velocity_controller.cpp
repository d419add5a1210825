#include "agent/controller/velocity_controller.hpp"

#include <algorithm>

#include "agent/controller/apf.hpp"
#include "agent/controller/evasion.hpp"
#include "agent/controller/orca.hpp"

namespace skein {

Steering VelocityController::command(const Scene& scene, const Vec3& wish_mps) const {
  if (spec_.type == VehicleType::ConstantSpeed) return {wish_mps, false, false, false};
  const Vec3 wanted_mps = options_.name == "orca" ? orca_velocity(options_, spec_, step_s_, scene, wish_mps)
                                                  : apf_velocity(options_, spec_, scene, wish_mps);
  Steering steering{wanted_mps, false, false, false};
  if (options_.filter > 0.0) steering = filter_.pass(scene, wanted_mps);
  steering.repelled = wanted_mps != wish_mps && wanted_mps != clipped(wish_mps, wary_speed_mps(options_, spec_));
  return steering;
}

double VelocityController::top_speed_mps() const {
  if (spec_.type == VehicleType::ConstantSpeed || options_.sensor_range_m <= 0.0) return spec_.speed_mps;
  double top_mps = spec_.speed_mps;
  if (options_.filter > 0.0) top_mps = std::min(top_mps, filter_.speed_cap_mps());
  if (options_.name == "apf") top_mps = std::min(top_mps, wary_speed_mps(options_, spec_));
  return top_mps;
}

}  // namespace skein
