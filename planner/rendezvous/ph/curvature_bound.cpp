#include "planner/rendezvous/ph/curvature_bound.hpp"

#include <cmath>

#include "planner/rendezvous/ph/bound_search.hpp"

namespace skein::rendezvous::ph {
namespace {

/// Turning over the whole length (rad) that counts as none, so that a straight path needs no halving.
constexpr double kStraight_rad = 1e-6;
/// Part by which a curvature may exceed a limit unnoticed.
constexpr double kOverLimit = 1e-6;

double size_of(double bend) {
  return std::fabs(bend);
}
double size_of(const Vec2& bend) {
  return bend.norm();
}

double curvature_of(double bend, double speed) {
  return speed > 0.0 ? 2.0 * bend / (speed * speed) : kNoBound;
}

/// Bernstein coefficients of bend and speed on one interval.
template <typename Bend>
struct CurvaturePiece {
  std::array<Bend, 3> bend;
  std::array<double, 5> speed;

  [[nodiscard]] double at_ends() const {
    return std::max(curvature_of(size_of(bend.front()), speed.front()),
                    curvature_of(size_of(bend.back()), speed.back()));
  }
  [[nodiscard]] double bound() const {
    double largest = 0.0;
    for (const Bend& b : bend) largest = std::max(largest, size_of(b));
    return curvature_of(largest, *std::ranges::min_element(speed));
  }
  void split(CurvaturePiece& left, CurvaturePiece& right) const {
    halve(bend, left.bend, right.bend);
    halve(speed, left.speed, right.speed);
  }
};

template <typename Path>
double bounded(const Path& path, BoundSearch search) {
  using Bend = typename std::decay_t<decltype(path.bend())>::value_type;
  search.slack = kStraight_rad / path.length_m();
  return largest_of(CurvaturePiece<Bend>{bernstein(path.bend()), bernstein(path.speed_powers())}, search);
}

}  // namespace

double max_curvature_per_m(const PlanarPath& path, double tolerance) {
  return bounded(path, {tolerance, 0.0, 0.0, kNoBound});
}

double max_curvature_per_m(const SpatialPath& path, double tolerance) {
  return bounded(path, {tolerance, 0.0, 0.0, kNoBound});
}

bool curvature_within(const PlanarPath& path, double limit_per_m) {
  return bounded(path, {kOverLimit, 0.0, limit_per_m, limit_per_m}) < kNoBound;
}

bool curvature_within(const SpatialPath& path, double limit_per_m) {
  return bounded(path, {kOverLimit, 0.0, limit_per_m, limit_per_m}) < kNoBound;
}

}  // namespace skein::rendezvous::ph
