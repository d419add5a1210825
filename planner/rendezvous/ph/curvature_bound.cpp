#include "planner/rendezvous/ph/curvature_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace skein::rendezvous::ph {
namespace {

/// Turning over the whole length (rad) that counts as none, so that a straight path needs no halving.
constexpr double kStraight_rad = 1e-6;
constexpr int kMaxDepth = 40;
/// Part by which a curvature may exceed a limit unnoticed.
constexpr double kOverLimit = 1e-6;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Bernstein coefficients of bend and speed on one interval.
struct Piece {
  std::array<double, 3> bend;
  std::array<double, 5> speed;
};

double curvature_of(double bend, double speed) {
  return speed > 0.0 ? 2.0 * std::fabs(bend) / (speed * speed) : kInfinite;
}

double value_at_ends(const Piece& piece) {
  return std::max(curvature_of(piece.bend.front(), piece.speed.front()),
                  curvature_of(piece.bend.back(), piece.speed.back()));
}

double bound_of(const Piece& piece) {
  double bend = 0.0;
  for (const double b : piece.bend) bend = std::max(bend, std::fabs(b));
  return curvature_of(bend, *std::ranges::min_element(piece.speed));
}

template <std::size_t N>
void halve(const std::array<double, N>& whole, std::array<double, N>& left, std::array<double, N>& right) {
  right = whole;
  for (std::size_t i = 0; i < N; ++i) {
    left[i] = right[0];
    for (std::size_t j = 0; j + 1 < N - i; ++j) right[j] = 0.5 * (right[j] + right[j + 1]);
  }
}

/// Bernstein coefficients on [0, 1] from coefficients by powers: b_i = sum over k <= i of C(i, k) / C(n, k) a_k.
template <std::size_t N>
std::array<double, N> bernstein(std::array<double, N> powers) {
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
struct Search {
  double tolerance;      ///< above the largest curvature met, relatively
  double slack_per_m;    ///< above it, absolutely
  double reached_per_m;  ///< the largest curvature met so far
  double limit_per_m;    ///< beyond it the search gives up
};

/// The bound over one piece.
double largest(const Piece& piece, Search& search, int depth) {
  search.reached_per_m = std::max(search.reached_per_m, value_at_ends(piece));
  if (search.reached_per_m > search.limit_per_m) return kInfinite;
  const double bound = bound_of(piece);
  const double enough = search.reached_per_m * (1.0 + search.tolerance) + search.slack_per_m;
  if (bound <= enough || depth == kMaxDepth) return bound;
  Piece left;
  Piece right;
  halve(piece.bend, left.bend, right.bend);
  halve(piece.speed, left.speed, right.speed);
  return std::max(largest(left, search, depth + 1), largest(right, search, depth + 1));
}

}  // namespace

double max_curvature_per_m(const PlanarPath& path, double tolerance) {
  Search search{tolerance, kStraight_rad / path.length_m(), 0.0, kInfinite};
  return largest({bernstein(path.bend()), bernstein(path.speed_powers())}, search, 0);
}

bool curvature_within(const PlanarPath& path, double limit_per_m) {
  Search search{kOverLimit, kStraight_rad / path.length_m(), limit_per_m, limit_per_m};
  return largest({bernstein(path.bend()), bernstein(path.speed_powers())}, search, 0) < kInfinite;
}

}  // namespace skein::rendezvous::ph
