#include "agent/controller/orca.hpp"
namespace skein {
Vec3 orca_velocity(const ControllerOptions&, const VehicleSpec&, double, const Scene&, const Vec3& wish_mps) {
  return wish_mps;
}
}  // namespace skein
