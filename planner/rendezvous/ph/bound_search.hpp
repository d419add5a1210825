// Upper bound of a function on [0, 1] by halving: a piece is halved while its bound exceeds what was reached by too
// much.
//
// A polynomial on an interval lies within the hull of its Bernstein coefficients, which de Casteljau's scheme halves;
// a piece bounds its function from them (Piece::bound), and gives the values that are reached at its ends
// (Piece::at_ends). Source: Farouki, 'Pythagorean-Hodograph Curves' (2008). Departs from source: none.
// Complexity: O(tolerance^-1/2) pieces a maximum.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace skein::rendezvous::ph {

/// Coefficients on both halves of an interval, from those on the whole.
template <typename T, std::size_t N>
void halve(const std::array<T, N>& whole, std::array<T, N>& left, std::array<T, N>& right) {
  right = whole;
  for (std::size_t i = 0; i < N; ++i) {
    left[i] = right[0];
    for (std::size_t j = 0; j + 1 < N - i; ++j) right[j] = 0.5 * (right[j] + right[j + 1]);
  }
}

/// Bernstein coefficients on [0, 1] from coefficients by powers: b_i = sum over k <= i of C(i, k) / C(n, k) a_k.
template <typename T, std::size_t N>
std::array<T, N> bernstein(std::array<T, N> powers) {
  double binomial = 1.0;
  for (std::size_t k = 1; k < N; ++k) {
    binomial *= static_cast<double>(N - k) / static_cast<double>(k);
    powers[k] /= binomial;
  }
  for (std::size_t i = 1; i < N; ++i) {
    for (std::size_t j = N - 1; j >= i; --j) powers[j] += powers[j - 1];
  }
  return powers;
}

/// What decides that a bound is good enough.
struct BoundSearch {
  double tolerance;  ///< above the largest value met, relatively
  double slack;      ///< above it, absolutely
  double reached;    ///< the largest value met so far
  double limit;      ///< beyond it the search gives up
};

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();
inline constexpr int kMaxHalvings = 40;

/// The bound over one piece; infinite once the limit is passed.
template <typename Piece>
double largest_of(const Piece& piece, BoundSearch& search, int depth = 0) {
  search.reached = std::max(search.reached, piece.at_ends());
  if (search.reached > search.limit) return kNoBound;
  const double bound = piece.bound();
  const double enough = search.reached * (1.0 + search.tolerance) + search.slack;
  if (bound <= enough || depth == kMaxHalvings) return bound;
  Piece left;
  Piece right;
  piece.split(left, right);
  const double on_right = largest_of(right, search, depth + 1);
  return std::max(largest_of(left, search, depth + 1), on_right);
}

}  // namespace skein::rendezvous::ph
