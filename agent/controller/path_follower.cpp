#include "agent/controller/path_follower.hpp"

#include <algorithm>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

constexpr double kPole = 0.5;  ///< of the error dynamics: an error halves each step

}  // namespace

PathFollower::PathFollower(const VehicleSpec& spec, double step_s)
    : speed_mps_(spec.speed_mps),
      step_m_(spec.speed_mps * step_s),
      max_turn_rad_(spec.max_curvature_per_m * spec.speed_mps * step_s) {}

PathFollower::Command PathFollower::command(const rendezvous::ph::JoinedPlanarPath& path, const Pose& pose) {
  if (under_way_) travelled_m_ += step_m_;
  under_way_ = true;
  const Vec2 position = pose.position_m.head<2>();
  double q = path.parameter_at(travelled_m_);
  Vec2 along = direction_of_heading(path.heading(q));
  travelled_m_ += (position - path.position(q)).dot(along);
  const bool flown = travelled_m_ >= path.length_m();

  q = path.parameter_at(travelled_m_, q);
  const double path_heading_rad = path.heading(q);
  along = direction_of_heading(path_heading_rad);
  // beyond the end the path goes straight on, and only the offset across it is an error
  const Vec2 offset_m = position - path.position(q);
  const double left_m = along.x() * offset_m.y() - along.y() * offset_m.x();
  const double ahead_rad = path.heading(path.parameter_at(travelled_m_ + step_m_, q));
  const double heading_error_rad = math::wrap_angle(pose.heading_rad - path_heading_rad);
  const double turn_rad = math::wrap_angle(ahead_rad - path_heading_rad) -
                          (1.0 - kPole) * (1.0 - kPole) * left_m / step_m_ -
                          0.5 * (1.0 - kPole) * (3.0 + kPole) * heading_error_rad;
  const double heading_rad = pose.heading_rad + std::clamp(turn_rad, -max_turn_rad_, max_turn_rad_);
  const Vec2 direction = direction_of_heading(heading_rad);
  return {Vec3(speed_mps_ * direction.x(), speed_mps_ * direction.y(), 0.0), flown};
}

PathFollower::Command PathFollower::command(const rendezvous::ph::JoinedSpatialPath& path, const Pose& pose) {
  if (under_way_) travelled_m_ += step_m_;
  under_way_ = true;
  double q = path.parameter_at(travelled_m_);
  travelled_m_ += (pose.position_m - path.position(q)).dot(path.direction(q));
  const bool flown = travelled_m_ >= path.length_m();

  q = path.parameter_at(travelled_m_, q);
  const Vec3 along = path.direction(q);
  const Vec3 offset_m = pose.position_m - path.position(q);
  const Vec3 aside_m = offset_m - offset_m.dot(along) * along;  // beyond the end the path goes straight on
  const Vec3 ahead = path.direction(path.parameter_at(travelled_m_ + step_m_, q));
  const Vec3 moving = direction_of(pose);
  const Vec3 wanted = moving + (ahead - along) - (1.0 - kPole) * (1.0 - kPole) / step_m_ * aside_m -
                      0.5 * (1.0 - kPole) * (3.0 + kPole) * (moving - along);
  return {speed_mps_ * wanted.normalized(), flown};
}

}  // namespace skein
