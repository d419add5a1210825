#include "planner/rendezvous/ph/torsion_bound.hpp"

#include <cmath>

#include "planner/rendezvous/ph/bound_search.hpp"

namespace skein::rendezvous::ph {
namespace {

/// Winding over the whole length (rad) that counts as none.
constexpr double kLevel_rad = 1e-6;
/// Part by which a torsion may exceed a limit unnoticed.
constexpr double kOverLimit = 1e-6;

double torsion_of(double twist, double speed, double bend_squared) {
  if (twist == 0.0) return 0.0;
  return speed > 0.0 && bend_squared > 0.0 ? twist / (speed * speed * bend_squared) : kNoBound;
}

/// Bernstein coefficients of N, sigma and |b|^2 on one interval.
struct TorsionPiece {
  std::array<double, 7> twist;
  std::array<double, 5> speed;
  std::array<double, 5> bend_squared;

  [[nodiscard]] double at_ends() const {
    return std::max(torsion_of(std::fabs(twist.front()), speed.front(), bend_squared.front()),
                    torsion_of(std::fabs(twist.back()), speed.back(), bend_squared.back()));
  }
  [[nodiscard]] double bound() const {
    double largest = 0.0;
    for (const double t : twist) largest = std::max(largest, std::fabs(t));
    return torsion_of(largest, *std::ranges::min_element(speed), *std::ranges::min_element(bend_squared));
  }
  void split(TorsionPiece& left, TorsionPiece& right) const {
    halve(twist, left.twist, right.twist);
    halve(speed, left.speed, right.speed);
    halve(bend_squared, left.bend_squared, right.bend_squared);
  }
};

double bounded(const SpatialPath& path, BoundSearch search) {
  search.slack = kLevel_rad / path.length_m();
  return largest_of(
      TorsionPiece{bernstein(path.twist()), bernstein(path.speed_powers()), bernstein(path.bend_squared())}, search);
}

}  // namespace

double max_torsion_per_m(const SpatialPath& path, double tolerance) {
  return bounded(path, {tolerance, 0.0, 0.0, kNoBound});
}

bool torsion_within(const SpatialPath& path, double limit_per_m) {
  return bounded(path, {kOverLimit, 0.0, limit_per_m, limit_per_m}) < kNoBound;
}

}  // namespace skein::rendezvous::ph
