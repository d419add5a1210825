// Gauss-Legendre quadrature with 16 points: exact for polynomials up to degree 31.
//
// Source: Abramowitz and Stegun, Table 25.4. Departs from source: none. Complexity: 16 calls.
#pragma once

#include <array>
#include <cstddef>

namespace skein::rendezvous::ph {

/// Nodes and weights on [-1, 1]: the positive half.
inline constexpr std::array<double, 8> kGaussNodes{0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863,
                                                   0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                                                   0.9445750230732325761, 0.9894009349916499326};
inline constexpr std::array<double, 8> kGaussWeights{
    0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382, 0.1495959888165767321,
    0.1246289712555338720, 0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949};

/// Twice the integral of a function over [0, 1].
template <typename Function>
double twice_integral(const Function& f) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
    sum += kGaussWeights[i] * (f(0.5 - 0.5 * kGaussNodes[i]) + f(0.5 + 0.5 * kGaussNodes[i]));
  }
  return sum;
}

}  // namespace skein::rendezvous::ph
