#include "agent/controller/velocity_controller.hpp"

#include "agent/controller/apf.hpp"
#include "agent/controller/orca.hpp"

namespace skein {

Steering VelocityController::command(const Scene& scene, const Vec3& wish_mps) const {
  if (spec_.type == VehicleType::ConstantSpeed) return {wish_mps, false, false, false};
  Vec3 wanted_mps = wish_mps;
  bool repelled = false;
  if (options_.name == "orca") {
    wanted_mps = orca_velocity(options_, spec_, step_s_, scene, wish_mps);
    repelled = wanted_mps != wish_mps;
  } else {
    const Vec3 push_mps = apf_push(options_, spec_, scene, wish_mps);
    repelled = !push_mps.isZero(0.0);
    if (repelled) wanted_mps = clipped(wish_mps + push_mps, spec_.speed_mps);
  }
  Steering steering{wanted_mps, false, false, false};
  if (options_.filter > 0.0) steering = filter_.pass(scene, wanted_mps);
  steering.repelled = repelled;
  return steering;
}

}  // namespace skein
