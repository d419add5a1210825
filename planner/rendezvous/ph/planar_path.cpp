#include "planner/rendezvous/ph/planar_path.hpp"

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/ph/gauss_legendre.hpp"

namespace skein::rendezvous::ph {

double length_of(const Preimage& w) {
  const double middle = (2.0 * dot(w.w1, w.w1) + dot(w.w0, w.w2)) / 3.0;
  return (dot(w.w0, w.w0) + dot(w.w0, w.w1) + middle + dot(w.w1, w.w2) + dot(w.w2, w.w2)) / 5.0;
}

PlanarPath::PlanarPath(const Vec2& start_m, const Preimage& w) : start_m_(start_m), w_(w) {
  // By powers: w = a + b q + c q^2.
  const Complex a = w.w0;
  const Complex b = 2.0 * (w.w1 - w.w0);
  const Complex c = w.w0 - 2.0 * w.w1 + w.w2;
  const std::array<Complex, 5> hodograph{a * a, 2.0 * (a * b), b * b + 2.0 * (a * c), 2.0 * (b * c), c * c};
  profile_ = {{dot(a, a), 2.0 * dot(a, b), dot(b, b) + 2.0 * dot(a, c), 2.0 * dot(b, c), dot(c, c)}, length_of(w)};
  bend_ = {cross(a, b), 2.0 * cross(a, c), cross(b, c)};
  for (std::size_t k = 0; k < 5; ++k) {
    const double divisor = static_cast<double>(k + 1);
    x_[k] = hodograph[k].re / divisor;
    y_[k] = hodograph[k].im / divisor;
  }
}

Vec2 PlanarPath::position(double q) const {
  return {start_m_.x() + q * quartic(x_, q), start_m_.y() + q * quartic(y_, q)};
}

double PlanarPath::curvature(double q) const {
  const double sigma = speed(q);
  return 2.0 * (bend_[0] + q * (bend_[1] + q * bend_[2])) / (sigma * sigma);
}

double PlanarPath::heading(double q) const {
  const double p = 1.0 - q;
  const Complex w = (p * p) * w_.w0 + (2.0 * p * q) * w_.w1 + (q * q) * w_.w2;
  const Complex direction = w * w;
  return math::atan2(direction.im, direction.re);
}

double PlanarPath::elastic_energy_per_m() const {
  const auto density = [this](double q) {
    const double sigma = speed(q);
    const double bend = bend_[0] + q * (bend_[1] + q * bend_[2]);
    return bend * bend / (sigma * sigma * sigma);
  };
  return 2.0 * twice_integral(density);  // 4 from the squared curvature, 1/2 from the interval
}

void equidistant_points(const PlanarPath& path, std::span<Vec2> points_m) {
  fill_equidistant(path, points_m);
}

}  // namespace skein::rendezvous::ph
