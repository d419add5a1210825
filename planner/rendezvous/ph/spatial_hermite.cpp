#include "planner/rendezvous/ph/spatial_hermite.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "planner/core/geometry/frames.hpp"
#include "planner/rendezvous/ph/vector_square.hpp"

namespace skein::rendezvous::ph {
namespace {

/// A chord whose horizontal part is shorter than this part of it counts as vertical.
constexpr double kVertical = 1e-9;

/// First axis along the chord, second level (north for a vertical chord).
Axes axes_of(const Vec3& chord, double length_m) {
  const Vec3 along = chord / length_m;
  const double level = std::sqrt(along.x() * along.x() + along.y() * along.y());
  const Vec3 left = level > kVertical ? Vec3(-along.y() / level, along.x() / level, 0.0) : Vec3(Vec3::UnitY());
  const Vec3 up = along.cross(left).normalized();
  return {along, up.cross(along), up};
}

}  // namespace

SpatialHermite::SpatialHermite(const Pose& start, const Pose& end)
    : start_m_(start.position_m), chord_m_((end.position_m - start.position_m).norm()) {
  if (!(chord_m_ > 0.0)) throw std::invalid_argument("a path needs a start and an end at different places");
  axes_ = axes_of(end.position_m - start.position_m, chord_m_);
  const auto in_frame = [this](const Vec3& v) { return Vec3(v.dot(axes_.along), v.dot(axes_.left), v.dot(axes_.up)); };
  const Vec3 t0 = in_frame(direction_of(start)).normalized();
  const Vec3 t1 = in_frame(direction_of(end)).normalized();
  forward_ = t0[0] >= 0.0 && t1[0] >= 0.0;
  half_start_ = root(t0);
  half_end_ = root(t1);
}

SpatialPreimage SpatialHermite::solution(const Vec3& a0, const Vec3& a2, double root_sign) const {
  const Vec3 both = 2.0 * (a0[0] * a2 + a2[0] * a0) - 2.0 * a0.dot(a2) * Vec3::UnitX();  // A0 u A2* + A2 u A0*
  const Vec3 d = Vec3(120.0 * chord_m_, 0.0, 0.0) - 15.0 * (square(a0) + square(a2)) + 5.0 * both;
  return {a0, 0.25 * (root_sign * root(d) - 3.0 * (a0 + a2)), a2};
}

SpatialPreimage SpatialHermite::in_chord_frame(const Controls& m) const {
  const Vec3 a0 = std::sqrt(m.m0_m) * half_start_;
  const Vec3 a2 = std::sqrt(m.m1_m) * half_end_;
  SpatialPreimage best = solution(a0, a2, 1.0);
  if (forward_) return best;
  double least = SpatialPath(Vec3::Zero(), {}, best).elastic_energy_per_m();
  for (const SpatialPreimage& other : {solution(a0, a2, -1.0), solution(a0, -a2, 1.0), solution(a0, -a2, -1.0)}) {
    const double energy = SpatialPath(Vec3::Zero(), {}, other).elastic_energy_per_m();
    if (energy < least) {
      least = energy;
      best = other;
    }
  }
  return best;
}

SpatialPath SpatialHermite::path(const Controls& m) const {
  return {start_m_, axes_, in_chord_frame(m)};
}

double SpatialHermite::length_m(const Controls& m) const {
  return length_of(in_chord_frame(m));
}

}  // namespace skein::rendezvous::ph
