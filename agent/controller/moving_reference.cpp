#include "agent/controller/moving_reference.hpp"

namespace skein {

double MovingReference::travelled_m(double length_m, double t_s) const {
  const double a = acceleration_mps2_;
  const double v = std::min(speed_mps_, std::sqrt(length_m * a));  // the speed that is reached
  const double ramp_s = v / a;
  const double whole_s = length_m / v + ramp_s;
  if (t_s >= whole_s) return length_m;
  if (t_s < ramp_s) return 0.5 * a * t_s * t_s;
  if (t_s > whole_s - ramp_s) return length_m - 0.5 * a * (whole_s - t_s) * (whole_s - t_s);
  return v * t_s - 0.5 * v * ramp_s;
}

}  // namespace skein
