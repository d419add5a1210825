// A planar quintic Pythagorean-hodograph (PH) path: position, heading, curvature and arc length in closed form.
//
// In complex form r'(q) = w(q)^2 with w = w0 (1-q)^2 + 2 w1 q (1-q) + w2 q^2, q in [0, 1]. Hence the speed
// sigma = |w|^2 is a quartic, the arc length s(q) a quintic, and the length the mean of sigma's Bernstein coefficients
//   |w0|^2, Re w0 conj(w1), (2 |w1|^2 + Re w0 conj(w2)) / 3, Re w1 conj(w2), |w2|^2.
// Signed curvature kappa = 2 Im(conj(w) w') / sigma^2, positive to the left; its numerator is a quadratic. Elastic
// energy (Eq. 7, torsion 0) = integral of kappa^2 sigma dq = integral of 4 Im(conj(w) w')^2 / sigma^3 dq.
//
// Source: papers/001, Eq. 2-7; Farouki and Neff, Math. Comput. 64 (1995). Departs from source: none.
// Complexity: O(1) each; the parameter of an arc length takes a few Newton-Raphson steps, safeguarded by bisection.
#pragma once

#include <array>
#include <span>

#include "planner/core/geometry/types.hpp"
#include "planner/rendezvous/ph/complex.hpp"
#include "planner/rendezvous/ph/speed_profile.hpp"

namespace skein::rendezvous::ph {

/// The coefficients w0, w1, w2 (square root of metres): a path up to translation.
struct Preimage {
  Complex w0;
  Complex w1;
  Complex w2;

  bool operator==(const Preimage&) const = default;
};

/// Length (m) of the path of a preimage.
[[nodiscard]] double length_of(const Preimage& w);

class PlanarPath {
 public:
  PlanarPath() = default;  ///< a point at the origin, of length 0
  PlanarPath(const Vec2& start_m, const Preimage& w);

  [[nodiscard]] double length_m() const { return profile_.length_m(); }
  [[nodiscard]] const Preimage& preimage() const { return w_; }
  [[nodiscard]] const Vec2& start_m() const { return start_m_; }

  /// By parameter q in [0, 1]: position (m), |dr/dq| (m), signed curvature (1/m), arc length from the start (m).
  [[nodiscard]] Vec2 position(double q) const;
  [[nodiscard]] double speed(double q) const { return profile_.speed(q); }
  [[nodiscard]] double curvature(double q) const;
  [[nodiscard]] double heading(double q) const;
  [[nodiscard]] double arc_length(double q) const { return profile_.arc_length(q); }

  /// Integral of the squared curvature over arc length (1/m), by 16-point Gauss-Legendre quadrature.
  [[nodiscard]] double elastic_energy_per_m() const;

  /// The parameter at arc length s (m), s clamped to [0, length]; `guess` is where the iteration starts.
  [[nodiscard]] double parameter_at(double s_m, double guess) const { return profile_.parameter_at(s_m, guess); }
  [[nodiscard]] double parameter_at(double s_m) const { return profile_.parameter_at(s_m); }

  /// At arc length s (m), clamped to [0, length]: position (m), heading (rad), signed curvature (1/m, left positive).
  [[nodiscard]] Vec2 position_at(double s_m) const { return position(parameter_at(s_m)); }
  [[nodiscard]] double heading_at(double s_m) const { return heading(parameter_at(s_m)); }
  [[nodiscard]] double curvature_at(double s_m) const { return curvature(parameter_at(s_m)); }

  /// Quadratic n(q) with kappa = 2 n / sigma^2, and sigma itself, by powers of q.
  [[nodiscard]] const std::array<double, 3>& bend() const { return bend_; }
  [[nodiscard]] const std::array<double, 5>& speed_powers() const { return profile_.powers(); }
  [[nodiscard]] const SpeedProfile& profile() const { return profile_; }
  /// A coordinate of the position from the start, by powers of q, from q^1.
  [[nodiscard]] const std::array<double, 5>& place_powers(std::size_t axis) const { return axis == 0 ? x_ : y_; }

 private:
  Vec2 start_m_ = Vec2::Zero();
  Preimage w_;
  SpeedProfile profile_;
  std::array<double, 5> x_{};     ///< coefficients of q^1 .. q^5
  std::array<double, 5> y_{};     ///< coefficients of q^1 .. q^5
  std::array<double, 3> bend_{};  ///< coefficients of q^0 .. q^2
};

/// Points at arc lengths L k / (n - 1), k = 0 .. n - 1, n at least 2, both ends included.
void equidistant_points(const PlanarPath& path, std::span<Vec2> points_m);

}  // namespace skein::rendezvous::ph
