#include "planner/rendezvous/ph/speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace skein::rendezvous::ph {
namespace {

/// Iterations end when the arc length is right to this part of the whole; the last step then squares the error.
constexpr double kArcTolerance = 1e-9;
constexpr int kMaxIterations = 60;

}  // namespace

SpeedProfile::SpeedProfile(const std::array<double, 5>& powers, double length_m) : length_m_(length_m), speed_(powers) {
  for (std::size_t k = 0; k < 5; ++k) s_[k] = speed_[k] / static_cast<double>(k + 1);
}

double SpeedProfile::parameter_at(double s_m, double guess) const {
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

double SpeedProfile::parameter_at(double s_m) const {
  return length_m_ > 0.0 ? parameter_at(s_m, s_m / length_m_) : 0.0;
}

double SpeedProfile::parameter_beyond(double q, double gap_m, double s_m) const {
  // dq = h (1 - sigma' h / (2 sigma)) with h = gap / sigma, the second-order expansion.
  const double here = speed(q);
  const double h = gap_m / here;
  const double slope = speed_[1] + q * (2.0 * speed_[2] + q * (3.0 * speed_[3] + q * 4.0 * speed_[4]));
  const double step = h * (1.0 - 0.5 * slope * h / here);
  return parameter_at(s_m, q + (step > 0.0 ? step : h));
}

}  // namespace skein::rendezvous::ph
