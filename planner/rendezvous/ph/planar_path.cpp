#include "planner/rendezvous/ph/planar_path.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"

namespace skein::rendezvous::ph {
namespace {

/// Nodes and weights of Gauss-Legendre quadrature, 16 points, on [-1, 1]: the positive half.
constexpr std::array<double, 8> kNodes{0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863,
                                       0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                                       0.9445750230732325761, 0.9894009349916499326};
constexpr std::array<double, 8> kWeights{0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382,
                                         0.1495959888165767321, 0.1246289712555338720, 0.0951585116824927848,
                                         0.0622535239386478929, 0.0271524594117540949};

/// Iterations end when the arc length is right to this part of the whole; the last step then squares the error.
constexpr double kArcTolerance = 1e-9;
constexpr int kMaxIterations = 60;

double quartic(const std::array<double, 5>& c, double q) {
  return c[0] + q * (c[1] + q * (c[2] + q * (c[3] + q * c[4])));
}

}  // namespace

double length_of(const Preimage& w) {
  const double middle = (2.0 * dot(w.w1, w.w1) + dot(w.w0, w.w2)) / 3.0;
  return (dot(w.w0, w.w0) + dot(w.w0, w.w1) + middle + dot(w.w1, w.w2) + dot(w.w2, w.w2)) / 5.0;
}

PlanarPath::PlanarPath(const Vec2& start_m, const Preimage& w) : start_m_(start_m), w_(w), length_m_(length_of(w)) {
  // By powers: w = a + b q + c q^2.
  const Complex a = w.w0;
  const Complex b = 2.0 * (w.w1 - w.w0);
  const Complex c = w.w0 - 2.0 * w.w1 + w.w2;
  const std::array<Complex, 5> hodograph{a * a, 2.0 * (a * b), b * b + 2.0 * (a * c), 2.0 * (b * c), c * c};
  speed_ = {dot(a, a), 2.0 * dot(a, b), dot(b, b) + 2.0 * dot(a, c), 2.0 * dot(b, c), dot(c, c)};
  bend_ = {cross(a, b), 2.0 * cross(a, c), cross(b, c)};
  for (std::size_t k = 0; k < 5; ++k) {
    const double divisor = static_cast<double>(k + 1);
    x_[k] = hodograph[k].re / divisor;
    y_[k] = hodograph[k].im / divisor;
    s_[k] = speed_[k] / divisor;
  }
}

Vec2 PlanarPath::position(double q) const {
  return {start_m_.x() + q * quartic(x_, q), start_m_.y() + q * quartic(y_, q)};
}

double PlanarPath::speed(double q) const {
  return quartic(speed_, q);
}

double PlanarPath::arc_length(double q) const {
  return q * quartic(s_, q);
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
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (density(0.5 - 0.5 * kNodes[i]) + density(0.5 + 0.5 * kNodes[i]));
  }
  return 2.0 * sum;  // 4 from the squared curvature, 1/2 from the interval
}

double PlanarPath::parameter_at(double s_m, double guess) const {
  if (!(s_m > 0.0)) return 0.0;
  if (s_m >= length_m_) return 1.0;
  double low = 0.0;
  double high = 1.0;
  double q = std::clamp(guess, 0.0, 1.0);
  for (int i = 0; i < kMaxIterations; ++i) {
    const double excess = arc_length(q) - s_m;
    (excess > 0.0 ? high : low) = q;
    const double step = excess / speed(q);
    const double next = q - step;
    const bool inside = next >= low && next <= high;  // false also when the speed is 0
    if (std::fabs(excess) <= kArcTolerance * length_m_) return inside ? next : q;
    q = inside ? next : 0.5 * (low + high);
  }
  return q;
}

double PlanarPath::parameter_at(double s_m) const {
  return length_m_ > 0.0 ? parameter_at(s_m, s_m / length_m_) : 0.0;
}

void equidistant_points(const PlanarPath& path, std::span<Vec2> points_m) {
  const std::size_t last = points_m.size() - 1;
  const double gap = path.length_m() / static_cast<double>(last);
  const std::array<double, 5>& sigma = path.speed_powers();
  double q = 0.0;
  points_m[0] = path.position(0.0);
  for (std::size_t k = 1; k < last; ++k) {
    // From the point before: dq = h (1 - sigma' h / (2 sigma)) with h = gap / sigma, the second-order expansion.
    const double speed = path.speed(q);
    const double h = gap / speed;
    const double slope = sigma[1] + q * (2.0 * sigma[2] + q * (3.0 * sigma[3] + q * 4.0 * sigma[4]));
    const double step = h * (1.0 - 0.5 * slope * h / speed);
    const double guess = q + (step > 0.0 ? step : h);
    q = path.parameter_at(gap * static_cast<double>(k), guess);
    points_m[k] = path.position(q);
  }
  points_m[last] = path.position(1.0);
}

}  // namespace skein::rendezvous::ph
