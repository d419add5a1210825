#include "agent/controller/velocity_controller.hpp"

namespace skein {

Steering VelocityController::command(const Scene& /*scene*/, const Vec3& wish_mps) const {
  return {wish_mps, false, false, false};
}

}  // namespace skein
