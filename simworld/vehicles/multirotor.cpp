#include "simworld/vehicles/multirotor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "planner/core/geometry/clipped.hpp"

namespace skein {
namespace {

/// Speed below which the curvature of a motion says nothing.
constexpr double kStanding_mps = 1e-6;

}  // namespace

VehicleStep advance_multirotor(const VehicleSpec& spec, const VehicleState& state, const Vec3& commanded_velocity_mps,
                               double dt_s) {
  const Vec3& before = state.velocity_mps;
  const Vec3 wanted = clipped(commanded_velocity_mps, spec.speed_mps);
  const Vec3 change = clipped(wanted - before, spec.max_acceleration_mps2 * dt_s);
  VehicleStep step;
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(kMotionPoints - 1);
    step.motion.points_m[i] = state.position_m + part * dt_s * (before + 0.5 * part * change);
    if (i > 0) step.motion.length_m += (step.motion.points_m[i] - step.motion.points_m[i - 1]).norm();
  }
  step.after.position_m = step.motion.points_m.back();
  step.after.velocity_mps = before + change;
  const Vec3 middle = before + 0.5 * change;
  const double speed = middle.norm();
  if (speed > kStanding_mps) step.motion.curvature_per_m = middle.cross(change).norm() / (dt_s * speed * speed * speed);
  return step;
}

VehicleStep advance_holonomic(const VehicleSpec& spec, const VehicleState& state, const Vec3& commanded_velocity_mps,
                              double dt_s) {
  const Vec3 velocity_mps = clipped(commanded_velocity_mps, spec.speed_mps);
  VehicleStep step;
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(kMotionPoints - 1);
    step.motion.points_m[i] = state.position_m + part * dt_s * velocity_mps;
  }
  step.motion.length_m = velocity_mps.norm() * dt_s;
  step.after = {step.motion.points_m.back(), velocity_mps};
  return step;
}

VehicleStep advance_vehicle(const VehicleSpec& spec, const VehicleState& state, const Vec3& commanded_velocity_mps,
                            double dt_s) {
  switch (spec.type) {
    case VehicleType::Multirotor:
      return advance_multirotor(spec, state, commanded_velocity_mps, dt_s);
    case VehicleType::Holonomic:
      return advance_holonomic(spec, state, commanded_velocity_mps, dt_s);
    default:
      return advance_constant_speed(spec, state, commanded_velocity_mps, dt_s);
  }
}

}  // namespace skein
