#include "simworld/vehicles/constant_speed.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

/// Unit vector at `angle_rad` from unit `from` in the plane of `from` and the unit vector `across`, its perpendicular.
Vec3 turned(const Vec3& from, const Vec3& across, double angle_rad) {
  return math::cos(angle_rad) * from + math::sin(angle_rad) * across;
}

}  // namespace

VehicleState initial_state(const VehicleSpec& spec) {
  const double speed_mps = spec.type == VehicleType::ConstantSpeed ? spec.speed_mps : 0.0;
  return {spec.start.position_m, speed_mps * direction_of(spec.start)};
}

Pose pose_of(const VehicleState& state) {
  const Vec3& v = state.velocity_mps;
  const double level = std::sqrt(v.x() * v.x() + v.y() * v.y());
  return {state.position_m, math::atan2(v.y(), v.x()), math::atan2(v.z(), level)};
}

VehicleStep advance_constant_speed(const VehicleSpec& spec, const VehicleState& state,
                                   const Vec3& commanded_velocity_mps, double dt_s) {
  const double length_m = spec.speed_mps * dt_s;
  const Vec3 from = state.velocity_mps / std::sqrt(state.velocity_mps.squaredNorm());
  Vec3 across = commanded_velocity_mps - commanded_velocity_mps.dot(from) * from;
  const double sideways = std::sqrt(across.squaredNorm());
  const double wanted_rad = math::atan2(sideways, commanded_velocity_mps.dot(from));
  const double angle_rad =
      sideways > 1e-12 * spec.speed_mps ? std::min(wanted_rad, spec.max_curvature_per_m * length_m) : 0.0;

  VehicleStep step;
  step.motion.curvature_per_m = angle_rad / length_m;
  step.motion.length_m = length_m;
  if (angle_rad > 0.0) across /= sideways;
  for (std::size_t i = 0; i < kMotionPoints; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(kMotionPoints - 1);
    const double half_rad = 0.5 * part * angle_rad;
    const double chord_m = part * length_m * (half_rad > 1e-8 ? math::sin(half_rad) / half_rad : 1.0);
    step.motion.points_m[i] = state.position_m + chord_m * (angle_rad > 0.0 ? turned(from, across, half_rad) : from);
  }
  step.after.position_m = step.motion.points_m.back();
  step.after.velocity_mps = spec.speed_mps * (angle_rad > 0.0 ? turned(from, across, angle_rad) : from);
  return step;
}

}  // namespace skein
