#include "planner/rendezvous/ph/spatial_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "planner/rendezvous/ph/gauss_legendre.hpp"
#include "planner/rendezvous/ph/vector_square.hpp"

namespace skein::rendezvous::ph {
namespace {

/// Part of its terms below which the numerator of the torsion is rounding alone: the path lies in a plane.
constexpr double kPlane = 1e-12;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

double length_of(const SpatialPreimage& a) {
  const double middle = (2.0 * a.a1.squaredNorm() + a.a0.dot(a.a2)) / 3.0;
  return (a.a0.squaredNorm() + a.a0.dot(a.a1) + middle + a.a1.dot(a.a2) + a.a2.squaredNorm()) / 5.0;
}

SpatialPath::SpatialPath(const Vec3& start_m, const Axes& axes, const SpatialPreimage& a)
    : start_m_(start_m), axes_(axes), a_(a) {
  // By powers: a = p0 + p1 q + p2 q^2.
  const Vec3 p0 = a.a0;
  const Vec3 p1 = 2.0 * (a.a1 - a.a0);
  const Vec3 p2 = a.a0 - 2.0 * a.a1 + a.a2;
  const std::array<Vec3, 5> hodograph{product(p0, p0), 2.0 * product(p0, p1), product(p1, p1) + 2.0 * product(p0, p2),
                                      2.0 * product(p1, p2), product(p2, p2)};
  profile_ = {{p0.dot(p0), 2.0 * p0.dot(p1), p1.dot(p1) + 2.0 * p0.dot(p2), 2.0 * p1.dot(p2), p2.dot(p2)},
              length_of(a)};
  for (std::size_t k = 0; k < 5; ++k) {
    const Vec3& h = hodograph[k];
    const Vec3 world = (h[0] * axes.along + h[1] * axes.left + h[2] * axes.up) / static_cast<double>(k + 1);
    for (std::size_t i = 0; i < 3; ++i) place_[i][k] = world[static_cast<Eigen::Index>(i)];
  }
  set_bend(p0, p1, p2);
}

void SpatialPath::set_bend(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const std::array<Vec3, 3> n{p0.cross(p1), 2.0 * p0.cross(p2), p1.cross(p2)};
  for (std::size_t k = 0; k < 3; ++k) bend_[k] = n[k].tail<2>();
  const std::array<double, 3> turn{cross(bend_[0], bend_[1]), 2.0 * cross(bend_[0], bend_[2]),
                                   cross(bend_[1], bend_[2])};
  double largest_bend = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) bend_squared_[i + j] += bend_[i].dot(bend_[j]);
    largest_bend = std::max(largest_bend, bend_[i].squaredNorm());
  }
  double largest = 0.0;
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      twist_[i + j] += turn[i] * profile_.powers()[j] - 2.0 * n[i][0] * bend_squared_[j];
    }
  }
  for (const double t : twist_) largest = std::max(largest, std::fabs(t));
  const double size = std::max({a_.a0.squaredNorm(), a_.a1.squaredNorm(), a_.a2.squaredNorm()});
  if (largest <= kPlane * size * size * std::sqrt(largest_bend)) twist_.fill(0.0);
}

Vec3 SpatialPath::position(double q) const {
  return {start_m_.x() + q * quartic(place_[0], q), start_m_.y() + q * quartic(place_[1], q),
          start_m_.z() + q * quartic(place_[2], q)};
}

Vec3 SpatialPath::direction(double q) const {
  const double p = 1.0 - q;
  const Vec3 a = (p * p) * a_.a0 + (2.0 * p * q) * a_.a1 + (q * q) * a_.a2;
  const Vec3 h = product(a, a);
  return (h[0] * axes_.along + h[1] * axes_.left + h[2] * axes_.up).normalized();
}

double SpatialPath::curvature(double q) const {
  const double sigma = speed(q);
  return 2.0 * (bend_[0] + q * (bend_[1] + q * bend_[2])).norm() / (sigma * sigma);
}

double SpatialPath::twist(double q) const {
  double value = 0.0;
  for (std::size_t k = twist_.size(); k-- > 0;) value = twist_[k] + q * value;
  return value;
}

double SpatialPath::torsion(double q) const {
  const double t = twist(q);
  if (t == 0.0) return 0.0;
  const double sigma = speed(q);
  return t / (sigma * sigma * (bend_[0] + q * (bend_[1] + q * bend_[2])).squaredNorm());
}

double SpatialPath::elastic_energy_per_m() const {
  const auto density = [this](double q) {
    const double sigma = speed(q);
    const double squared = (bend_[0] + q * (bend_[1] + q * bend_[2])).squaredNorm();
    const double t = twist(q);
    const double torsion = t == 0.0 ? 0.0 : 0.5 * t / squared;
    return (squared + torsion * torsion) / (sigma * sigma * sigma);
  };
  return 2.0 * twice_integral(density);  // 4 from the squared curvature, 1/2 from the interval
}

void equidistant_points(const SpatialPath& path, std::span<Vec3> points_m) {
  fill_equidistant(path, points_m);
}

}  // namespace skein::rendezvous::ph
