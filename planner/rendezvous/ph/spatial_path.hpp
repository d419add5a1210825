// A spatial quintic Pythagorean-hodograph (PH) path: position, direction, curvature, torsion and arc length in closed
// form.
//
// In quaternion form r'(q) = A(q) u A*(q) with A = A0 (1-q)^2 + 2 A1 q (1-q) + A2 q^2 and u a unit reference axis. Here
// A is a pure quaternion, that is a vector a(q) (all free angles are zero), so that
//   r' = 2 (a . u) a - |a|^2 u,   sigma = |a|^2;
// in a frame with u as its first axis r' = (a1^2 - a2^2 - a3^2, 2 a1 a2, 2 a1 a3): for a3 = 0 that is w^2 of the planar
// path with w = a1 + i a2. Let n(q) = a x a', three quadratics: n1 along u, b = (n2, n3) across it, and
// c = n2 n3' - n3 n2', a quadratic as well. From the rotation of the frame A (u, ., .) A* / sigma follow
//   curvature kappa = 2 |b| / sigma^2,
//   torsion   tau   = (c / |b|^2 - 2 n1 / sigma) / sigma = N / (sigma^2 |b|^2),  N = c sigma - 2 n1 |b|^2,
// which are Eq. 5 and Eq. 6. A path in a plane has N = 0, and torsion 0 also where it is straight.
// Elastic energy (Eq. 7) = integral of (kappa^2 + tau^2) sigma dq.
//
// Source: papers/001, Eq. 2-7; Farouki, al-Kandari, Sakkalis, Adv. Comput. Math. 17 (2002). Departs from source: none.
// Complexity: O(1) each; the parameter of an arc length as in speed_profile.hpp.
#pragma once

#include <array>
#include <span>

#include "planner/core/geometry/types.hpp"
#include "planner/rendezvous/ph/speed_profile.hpp"

namespace skein::rendezvous::ph {

/// The coefficients A0, A1, A2 (square root of metres) in a frame whose first axis is u: a path up to motion.
struct SpatialPreimage {
  Vec3 a0 = Vec3::Zero();
  Vec3 a1 = Vec3::Zero();
  Vec3 a2 = Vec3::Zero();
};

/// A right-handed orthonormal frame; `along` is u.
struct Axes {
  Vec3 along = Vec3::UnitX();
  Vec3 left = Vec3::UnitY();
  Vec3 up = Vec3::UnitZ();
};

/// Length (m) of the path of a preimage: the mean of sigma's Bernstein coefficients.
[[nodiscard]] double length_of(const SpatialPreimage& a);

class SpatialPath {
 public:
  SpatialPath() = default;  ///< a point at the origin, of length 0
  SpatialPath(const Vec3& start_m, const Axes& axes, const SpatialPreimage& a);

  [[nodiscard]] double length_m() const { return profile_.length_m(); }
  [[nodiscard]] const SpatialPreimage& preimage() const { return a_; }
  [[nodiscard]] const Axes& axes() const { return axes_; }
  [[nodiscard]] const Vec3& start_m() const { return start_m_; }

  /// By parameter q in [0, 1]: position (m), |dr/dq| (m), unit direction, arc length from the start (m), curvature
  /// (1/m, never negative), torsion (1/m, positive where the path winds like a right-handed screw).
  [[nodiscard]] Vec3 position(double q) const;
  [[nodiscard]] double speed(double q) const { return profile_.speed(q); }
  [[nodiscard]] Vec3 direction(double q) const;
  [[nodiscard]] double arc_length(double q) const { return profile_.arc_length(q); }
  [[nodiscard]] double curvature(double q) const;
  [[nodiscard]] double torsion(double q) const;

  /// Integral of squared curvature and squared torsion over arc length (1/m), by 16-point Gauss-Legendre quadrature.
  [[nodiscard]] double elastic_energy_per_m() const;

  /// The parameter at arc length s (m), s clamped to [0, length]; `guess` is where the iteration starts.
  [[nodiscard]] double parameter_at(double s_m, double guess) const { return profile_.parameter_at(s_m, guess); }
  [[nodiscard]] double parameter_at(double s_m) const { return profile_.parameter_at(s_m); }

  /// At arc length s (m), clamped to [0, length]: position (m), curvature (1/m), torsion (1/m).
  [[nodiscard]] Vec3 position_at(double s_m) const { return position(parameter_at(s_m)); }
  [[nodiscard]] double curvature_at(double s_m) const { return curvature(parameter_at(s_m)); }

  /// b, |b|^2 and N of the formulas above, and sigma, by powers of q.
  [[nodiscard]] const std::array<Vec2, 3>& bend() const { return bend_; }
  [[nodiscard]] const std::array<double, 5>& bend_squared() const { return bend_squared_; }
  [[nodiscard]] const std::array<double, 7>& twist() const { return twist_; }
  [[nodiscard]] const std::array<double, 5>& speed_powers() const { return profile_.powers(); }
  [[nodiscard]] const SpeedProfile& profile() const { return profile_; }
  /// A coordinate of the position from the start, by powers of q, from q^1.
  [[nodiscard]] const std::array<double, 5>& place_powers(std::size_t axis) const { return place_[axis]; }

 private:
  void set_bend(const Vec3& p0, const Vec3& p1, const Vec3& p2);
  [[nodiscard]] double twist(double q) const;

  Vec3 start_m_ = Vec3::Zero();
  Axes axes_;
  SpatialPreimage a_;
  SpeedProfile profile_;
  std::array<std::array<double, 5>, 3> place_{};  ///< x, y, z: coefficients of q^1 .. q^5
  std::array<Vec2, 3> bend_{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  std::array<double, 5> bend_squared_{};
  std::array<double, 7> twist_{};
};

/// Points at arc lengths L k / (n - 1), k = 0 .. n - 1, n at least 2, both ends included.
void equidistant_points(const SpatialPath& path, std::span<Vec3> points_m);

}  // namespace skein::rendezvous::ph
