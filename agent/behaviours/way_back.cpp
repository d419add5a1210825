#include "agent/behaviours/way_back.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

constexpr double kSteepest_rad = 0.15;
constexpr double kLevelOff_steps = 10.0;  ///< in which a height that is left is made up for

/// From 0 to 2 pi.
double positive_angle(double angle_rad) {
  const double wrapped = math::wrap_angle(angle_rad);
  return wrapped < 0.0 ? wrapped + math::kTwoPi : wrapped;
}

Vec2 centre_of(const Pose& pose, double side, double radius_m) {
  const Vec2 along = direction_of_heading(pose.heading_rad);
  return pose.position_m.head<2>() + side * radius_m * Vec2(-along.y(), along.x());
}

}  // namespace

WayBack::WayBack(const VehicleSpec& spec, double step_s, double radius_m, const Pose& from, const Pose& to)
    : speed_mps_(spec.speed_mps),
      step_m_(spec.speed_mps * step_s),
      radius_m_(radius_m),
      from_rad_(from.heading_rad),
      to_height_m_(to.position_m.z()) {
  double least_m = 0.0;
  for (const double side : {1.0, -1.0}) {
    const Vec2 between_m = centre_of(to, side, radius_m) - centre_of(from, side, radius_m);
    const double straight_m = between_m.norm();
    const double heading_rad = straight_m > 0.0 ? heading_of(between_m) : from.heading_rad;
    const double first_m = radius_m * positive_angle(side * (heading_rad - from.heading_rad));
    const double last_m = radius_m * positive_angle(side * (to.heading_rad - heading_rad));
    if (side < 0.0 && first_m + straight_m + last_m >= least_m) continue;
    side_ = side;
    straight_rad_ = heading_rad;
    first_m_ = first_m;
    straight_m_ = straight_m;
    last_m_ = last_m;
    least_m = length_m();
  }
}

double WayBack::heading_at(double way_m) const {
  if (way_m <= first_m_) return from_rad_ + side_ * way_m / radius_m_;
  const double turning_m = std::clamp(way_m - first_m_ - straight_m_, 0.0, last_m_);
  return straight_rad_ + side_ * turning_m / radius_m_;
}

Vec3 WayBack::command_mps(double height_m) {
  done_m_ += step_m_;
  const Vec2 level = direction_of_heading(heading_at(done_m_));
  const double climb_rad =
      std::clamp((to_height_m_ - height_m) / (kLevelOff_steps * step_m_), -kSteepest_rad, kSteepest_rad);
  const math::SinCos climb = math::sincos(climb_rad);
  return speed_mps_ * Vec3(climb.cos * level.x(), climb.cos * level.y(), climb.sin);
}

}  // namespace skein
