// The preimage of a path of n joined quintic PH segments: a spline whose square is the derivative of the path.
//
// The preimage w(q), q in [0, 1], is the clamped uniform quadratic B-spline with coefficients c_0 .. c_{n+1}, complex
// numbers in the plane, vectors (pure quaternions) in space. It is C1, so the path, the integral of w^2, is C2: its
// curvature is continuous with no further condition. Piece i has the Bernstein coefficients
//   (c_i + c_{i+1}) / 2 (the first c_0),  c_{i+1},  (c_{i+1} + c_{i+2}) / 2 (the last c_{n+1}).
// With the Gram matrix G of the B-splines the path ends at D if sum G_ij c_i c_j = D. Given all coefficients but c_k
// that is one quadratic: with s = sum over j != k of G_kj c_j and rest = sum over i, j != k of G_ij c_i c_j,
//   c_k = -s / G_kk +- sqrt((s / G_kk)^2 - (rest - D) / G_kk),
// for n = 1 the formula of hermite.hpp. In space the product is the bilinear form of vector_square.hpp, the root its
// root.
//
// Source: papers/001, Remark 4, asks for joined PH curves; Farouki, 'Pythagorean-Hodograph Curves' (2008), for PH
// splines. Departs from source: a B-spline preimage instead of a system of equations for C2 data. Complexity: O(n^2).
#pragma once

#include <array>
#include <cstddef>

#include "planner/rendezvous/ph/complex.hpp"
#include "planner/rendezvous/ph/controls.hpp"
#include "planner/rendezvous/ph/vector_square.hpp"

namespace skein::rendezvous::ph {

/// c_0 .. c_{n+1}; those beyond are not used.
template <typename T>
using SplineCoefficients = std::array<T, kMaxSegments + 2>;

[[nodiscard]] inline Complex product(Complex a, Complex b) {
  return a * b;
}
[[nodiscard]] inline Complex root(Complex z) {
  return square_root(z);
}

/// The coefficient that the chord determines: one in the middle.
[[nodiscard]] constexpr std::size_t closing_coefficient(std::size_t segments) {
  return (segments + 1) / 2;
}

/// Bernstein coefficients of piece i.
template <typename T>
[[nodiscard]] std::array<T, 3> piece_of(const SplineCoefficients<T>& c, std::size_t segments, std::size_t i) {
  const T first = i == 0 ? c[0] : T(0.5 * (c[i] + c[i + 1]));
  const T last = i + 1 == segments ? c[segments + 1] : T(0.5 * (c[i + 1] + c[i + 2]));
  return {first, c[i + 1], last};
}

/// Coefficient j of a spline of `n` pieces that follows one of `segments` pieces: the blossom of the old pieces at the
/// two knots of the new coefficient, which is exact for segments = 1.
template <typename T>
[[nodiscard]] T followed(const SplineCoefficients<T>& c, std::size_t segments, std::size_t n, std::size_t j) {
  const double parts = static_cast<double>(segments);
  const double from = static_cast<double>(j == 0 ? 0 : j - 1) / static_cast<double>(n);
  const double to = static_cast<double>(j > n ? n : j) / static_cast<double>(n);
  const double at = 0.5 * (from + to) * parts;
  const std::size_t i = at < parts ? static_cast<std::size_t>(at) : segments - 1;
  const double a = from * parts - static_cast<double>(i);
  const double b = to * parts - static_cast<double>(i);
  const std::array<T, 3> w = piece_of(c, segments, i);
  return ((1.0 - a) * (1.0 - b)) * w[0] + ((1.0 - a) * b + a * (1.0 - b)) * w[1] + (a * b) * w[2];
}

/// G of n segments: integrals over [0, 1] of products of two B-splines.
[[nodiscard]] constexpr SplineCoefficients<SplineCoefficients<double>> gram_matrix(std::size_t segments) {
  // of the quadratic Bernstein polynomials
  constexpr double kBernstein[3][3] = {
      {1.0 / 5.0, 1.0 / 10.0, 1.0 / 30.0}, {1.0 / 10.0, 2.0 / 15.0, 1.0 / 10.0}, {1.0 / 30.0, 1.0 / 10.0, 1.0 / 5.0}};
  SplineCoefficients<SplineCoefficients<double>> gram{};
  for (std::size_t i = 0; i < segments; ++i) {
    const double first = i == 0 ? 1.0 : 0.5;
    const double last = i + 1 == segments ? 1.0 : 0.5;
    // row r: what the Bernstein coefficient r takes from c_i, c_{i+1}, c_{i+2}
    const double from[3][3] = {{first, 1.0 - first, 0.0}, {0.0, 1.0, 0.0}, {0.0, 1.0 - last, last}};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t r = 0; r < 9; ++r) {
          gram[i + a][i + b] +=
              from[r / 3][a] * kBernstein[r / 3][r % 3] * from[r % 3][b] / static_cast<double>(segments);
        }
      }
    }
  }
  return gram;
}

/// The coefficients with the closing one set so that the path ends at `end` from its start; `sign` of the root: 1, -1.
template <typename T>
[[nodiscard]] SplineCoefficients<T> closed(SplineCoefficients<T> c, std::size_t segments, const T& end, double sign) {
  static constexpr std::array<SplineCoefficients<SplineCoefficients<double>>, kMaxSegments> kGram{
      gram_matrix(1), gram_matrix(2), gram_matrix(3), gram_matrix(4)};
  const auto& gram = kGram[segments - 1];
  const std::size_t k = closing_coefficient(segments);
  const double own = gram[k][k];
  T s = 0.0 * c[0];
  T excess = -1.0 * end;  // rest - D
  for (std::size_t i = 0; i < segments + 2; ++i) {
    if (i == k) continue;
    s = s + gram[k][i] * c[i];
    for (std::size_t j = 0; j < segments + 2; ++j) {
      if (j != k) excess = excess + gram[i][j] * product(c[i], c[j]);
    }
  }
  s = (1.0 / own) * s;
  const T radicand = product(s, s) - (1.0 / own) * excess;
  c[k] = sign * root(radicand) - s;
  return c;
}

}  // namespace skein::rendezvous::ph
