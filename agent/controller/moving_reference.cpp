#include "agent/controller/moving_reference.hpp"

namespace skein {

double MovingReference::whole_s(double length_m) const {
  const double v = reached_mps(length_m);
  return v > 0.0 ? length_m / v + v / acceleration_mps2_ : 0.0;
}

double MovingReference::travelled_m(double length_m, double t_s) const {
  if (!braking_ || t_s <= braking_->from_s) return profile_m(length_m, t_s);
  const double rest_s = braking_->speed_mps / braking_->by_mps2;
  const double t = std::min(t_s - braking_->from_s, rest_s);
  const double braked_m =
      std::min(length_m, braking_->from_m + t * (braking_->speed_mps - 0.5 * braking_->by_mps2 * t));
  if (!back_ || t_s <= back_->from_s) return braked_m;
  return std::max(0.0, braked_m - profile_m(back_->by_m, t_s - back_->from_s));
}

double MovingReference::profile_m(double length_m, double t_s) const {
  const double a = acceleration_mps2_;
  const double v = std::min(speed_mps_, std::sqrt(length_m * a));  // the speed that is reached
  const double ramp_s = v / a;
  const double whole_s = length_m / v + ramp_s;
  if (t_s >= whole_s) return length_m;
  if (t_s < ramp_s) return 0.5 * a * t_s * t_s;
  if (t_s > whole_s - ramp_s) return length_m - 0.5 * a * (whole_s - t_s) * (whole_s - t_s);
  return v * t_s - 0.5 * v * ramp_s;
}

double MovingReference::speed_mps(double length_m, double t_s) const {
  const double whole = whole_s(length_m);
  return std::max(0.0, std::min({reached_mps(length_m), acceleration_mps2_ * t_s, acceleration_mps2_ * (whole - t_s)}));
}

void MovingReference::brake(double length_m, double deceleration_mps2) {
  if (braking_) return;
  const double t_s = now_s();
  braking_ = {t_s, travelled_m(length_m, t_s), speed_mps(length_m, t_s), deceleration_mps2};
}

double MovingReference::rest_s() const {
  const double braked_s = braking_->from_s + braking_->speed_mps / braking_->by_mps2;
  return back_ ? back_->from_s + whole_s(back_->by_m) : braked_s;
}

void MovingReference::draw_back(double length_m, double to_m) {
  const double by_m = rest_m() - to_m;
  if (by_m <= 0.0) return;
  if (back_) {  // from where it has come to on its way back
    braking_ = {now_s(), travelled_m(length_m, now_s()), 0.0, braking_->by_mps2};
    back_.reset();
    return draw_back(length_m, to_m);
  }
  back_ = {std::max(now_s(), rest_s()), by_m};
}

}  // namespace skein
