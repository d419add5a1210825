#include "agent/behaviours/circle.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

constexpr std::uint32_t kFewest = 3;  ///< steps of a circle: of a vehicle that turns by more a step

}  // namespace

Circle::Circle(const VehicleSpec& spec, double step_s, const Pose& from, double side)
    : speed_mps_(spec.speed_mps),
      step_m_(spec.speed_mps * step_s),
      from_m_(from.position_m),
      along_(direction_of(from)) {
  const Vec2 level = direction_of_heading(from.heading_rad);
  aside_ = side * Vec3(-level.y(), level.x(), 0.0);
  const double turn_rad = spec.max_curvature_per_m * step_m_;
  steps_ = std::max(kFewest, static_cast<std::uint32_t>(std::ceil(math::kTwoPi / turn_rad)));
}

Vec3 Circle::command_mps() {
  done_ = (done_ + 1) % steps_;
  const math::SinCos turned = math::sincos(math::kTwoPi * done_ / steps_);
  return speed_mps_ * (turned.cos * along_ + turned.sin * aside_);
}

double Circle::radius_m() const {
  return step_m_ * steps_ / math::kTwoPi;
}

Vec3 Circle::place_m(std::uint32_t k) const {
  const math::SinCos turned = math::sincos(math::kTwoPi * k / steps_);
  return from_m_ + radius_m() * (turned.sin * along_ + (1.0 - turned.cos) * aside_);
}

}  // namespace skein
