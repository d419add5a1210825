// Complex numbers written out in real arithmetic, so that no object of ours calls the C library's complex functions.
//
// Source: elementary. Departs from source: none. Complexity: O(1).
#pragma once

#include <cmath>

namespace skein::rendezvous::ph {

struct Complex {
  double re = 0.0;
  double im = 0.0;

  bool operator==(const Complex&) const = default;
};

[[nodiscard]] constexpr Complex operator+(Complex a, Complex b) {
  return {a.re + b.re, a.im + b.im};
}
[[nodiscard]] constexpr Complex operator-(Complex a, Complex b) {
  return {a.re - b.re, a.im - b.im};
}
[[nodiscard]] constexpr Complex operator-(Complex a) {
  return {-a.re, -a.im};
}
[[nodiscard]] constexpr Complex operator*(double k, Complex a) {
  return {k * a.re, k * a.im};
}
[[nodiscard]] constexpr Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
/// Re(conj(a) b): the scalar product.
[[nodiscard]] constexpr double dot(Complex a, Complex b) {
  return a.re * b.re + a.im * b.im;
}
/// Im(conj(a) b): the cross product.
[[nodiscard]] constexpr double cross(Complex a, Complex b) {
  return a.re * b.im - a.im * b.re;
}

/// Principal square root: real part not negative; of a negative real number the root on the side of im's sign.
[[nodiscard]] inline Complex square_root(Complex z) {
  const double modulus = std::sqrt(z.re * z.re + z.im * z.im);
  if (modulus == 0.0) return {};
  const double larger = std::sqrt(0.5 * (modulus + std::fabs(z.re)));
  const double smaller = 0.5 * std::fabs(z.im) / larger;
  const double sign = z.im < 0.0 ? -1.0 : 1.0;
  return z.re >= 0.0 ? Complex{larger, sign * smaller} : Complex{smaller, sign * larger};
}

}  // namespace skein::rendezvous::ph
