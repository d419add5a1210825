#include "planner/core/math/det_math.hpp"

#include <sleef.h>

#include <cmath>

namespace skein::math {

double sin(double angle_rad) {
  return Sleef_cinz_sind1_u10purec(angle_rad);
}
double cos(double angle_rad) {
  return Sleef_cinz_cosd1_u10purec(angle_rad);
}
double tan(double angle_rad) {
  return Sleef_cinz_tand1_u10purec(angle_rad);
}
SinCos sincos(double angle_rad) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(angle_rad);
  return {both.x, both.y};
}
double asin(double x) {
  return Sleef_cinz_asind1_u10purec(x);
}
double acos(double x) {
  return Sleef_cinz_acosd1_u10purec(x);
}
double atan(double x) {
  return Sleef_cinz_atand1_u10purec(x);
}
double atan2(double y, double x) {
  return Sleef_cinz_atan2d1_u10purec(y, x);
}
double exp(double x) {
  return Sleef_cinz_expd1_u10purec(x);
}
double log(double x) {
  return Sleef_cinz_logd1_u10purec(x);
}
double pow(double base, double exponent) {
  return Sleef_cinz_powd1_u10purec(base, exponent);
}
double hypot(double x, double y) {
  return Sleef_cinz_hypotd1_u05purec(x, y);
}

double wrap_angle(double angle_rad) {
  if (angle_rad > -kPi && angle_rad <= kPi) return angle_rad;
  // ceil keeps the upper end: an angle of exactly pi stays, -pi becomes pi.
  const double wrapped = angle_rad - kTwoPi * std::ceil((angle_rad - kPi) / kTwoPi);
  if (wrapped <= -kPi) return kPi;
  return wrapped > kPi ? kPi : wrapped;
}

}  // namespace skein::math
