// The speed of a quintic PH path over its parameter, planar or spatial: arc length, and the parameter of an arc length.
//
// sigma(q) = |dr/dq| is a quartic, hence s(q) = integral of sigma is a quintic in closed form. Its inverse is found by
// Newton-Raphson, q <- q - (s(q) - s) / sigma(q), safeguarded by bisection.
// Source: papers/001, Eq. 4 and section 3.2.4. Departs from source: none. Complexity: O(1); a few steps for an inverse.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace skein::rendezvous::ph {

/// c0 + c1 q + .. + c4 q^4
[[nodiscard]] inline double quartic(const std::array<double, 5>& c, double q) {
  return c[0] + q * (c[1] + q * (c[2] + q * (c[3] + q * c[4])));
}

class SpeedProfile {
 public:
  SpeedProfile() = default;  ///< of a point
  /// @param powers coefficients of q^0 .. q^4 (m); @param length_m the integral over [0, 1], as accurate as the caller
  /// knows it
  SpeedProfile(const std::array<double, 5>& powers, double length_m);

  [[nodiscard]] double length_m() const { return length_m_; }
  [[nodiscard]] const std::array<double, 5>& powers() const { return speed_; }
  /// Of arc length, from q^1.
  [[nodiscard]] const std::array<double, 5>& arc_powers() const { return s_; }
  [[nodiscard]] double speed(double q) const { return quartic(speed_, q); }
  [[nodiscard]] double arc_length(double q) const { return q * quartic(s_, q); }

  /// The parameter at arc length s (m), s clamped to [0, length]; `guess` is where the iteration starts.
  [[nodiscard]] double parameter_at(double s_m, double guess) const;
  [[nodiscard]] double parameter_at(double s_m) const;
  /// The same for an s that lies `gap_m` beyond that of `q`, from a guess of second order.
  [[nodiscard]] double parameter_beyond(double q, double gap_m, double s_m) const;

 private:
  double length_m_ = 0.0;
  std::array<double, 5> speed_{};  ///< coefficients of q^0 .. q^4
  std::array<double, 5> s_{};      ///< coefficients of q^1 .. q^5
};

/// Points of a path at arc lengths L k / (n - 1), k = 0 .. n - 1, n at least 2, both ends included.
template <typename Path, typename Vec>
void fill_equidistant(const Path& path, std::span<Vec> points_m) {
  const std::size_t last = points_m.size() - 1;
  const double gap = path.length_m() / static_cast<double>(last);
  double q = 0.0;
  points_m[0] = path.position(0.0);
  for (std::size_t k = 1; k < last; ++k) {
    q = path.profile().parameter_beyond(q, gap, gap * static_cast<double>(k));
    points_m[k] = path.position(q);
  }
  points_m[last] = path.position(1.0);
}

}  // namespace skein::rendezvous::ph
