// Elementary functions that return the same bits on every machine.
//
// The C library picks variants of sin, exp and their kin by the processor it finds, and those differ in the last bit.
// These wrap SLEEF's pure C functions (error bound 1 ulp), which use + - * / alone. Square root, floor, ceil, trunc
// and fabs are exact by IEEE 754 and may be taken from <cmath>.
// Source: SLEEF 3.5.1, Sleef_cinz_*d1_u10purec. Departs from source: none. Complexity: O(1).
#pragma once

#include <numbers>

namespace skein::math {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

struct SinCos {
  double sin;
  double cos;
};

[[nodiscard]] double sin(double angle_rad);
[[nodiscard]] double cos(double angle_rad);
[[nodiscard]] double tan(double angle_rad);
[[nodiscard]] SinCos sincos(double angle_rad);
[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);
[[nodiscard]] double atan(double x);
/// Angle of the point (x, y), in [-pi, pi].
[[nodiscard]] double atan2(double y, double x);
[[nodiscard]] double exp(double x);
[[nodiscard]] double log(double x);
[[nodiscard]] double pow(double base, double exponent);
[[nodiscard]] double hypot(double x, double y);

/// The same direction in (-pi, pi]; for |angle| far above pi the error grows as |angle| times 1e-16.
[[nodiscard]] double wrap_angle(double angle_rad);

}  // namespace skein::math
