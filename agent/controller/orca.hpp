#pragma once
#include "agent/controller/scene.hpp"
namespace skein {
[[nodiscard]] Vec3 orca_velocity(const ControllerOptions& options, const VehicleSpec& spec, double step_s,
                                 const Scene& scene, const Vec3& wish_mps);
}
