#include "planner/rendezvous/align/joined_level_set.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/align/level_set.hpp"
#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

/// First step along a ray, as a part of the ranges, and its growth.
constexpr double kFirstStep = 1e-4;
constexpr double kStepGrowth = 1.6;
constexpr int kBisections = 60;

/// From `from`, t times `direction`, whose values are in the units of the coordinates.
template <typename Space>
struct Ray {
  const ParticipantIn<Space>& uav;
  ph::Controls from;
  ph::Controls direction;
  double end;  ///< t where the first coordinate leaves its range

  [[nodiscard]] ph::Controls at(double t) const {
    ph::Controls here = from;
    for (std::size_t i = 0; i < here.size(); ++i) here[i] = from[i] + t * direction[i];
    return clamped(uav, here);
  }
  [[nodiscard]] double excess_m(double t, double target_m) const { return uav.hermite.length_m(at(t)) - target_m; }
};

template <typename Space>
Ray<Space> ray_of(const ProblemIn<Space>& problem, const ph::Controls& from, std::size_t number) {
  const ParticipantIn<Space>& uav = problem.own();
  Ray<Space> ray{uav, from, from, HUGE_VAL};
  const std::size_t size = from.size();
  RandomStream stream(problem.seed, uav.id, Purpose::JoinedRay, number);
  double squares = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    const double along_axis = number % size == i ? (number < size ? 1.0 : -1.0) : 0.0;
    ray.direction[i] = number < 2 * size ? along_axis : stream.normal();
    squares += ray.direction[i] * ray.direction[i];
  }
  for (std::size_t i = 0; i < size; ++i) {
    const Interval range = range_of(uav, i);
    double& d = ray.direction[i];
    d *= range.width() / std::sqrt(squares);
    if (d > 0.0) ray.end = std::min(ray.end, (range.max - from[i]) / d);
    if (d < 0.0) ray.end = std::min(ray.end, (range.min - from[i]) / d);
  }
  return ray;
}

/// The crossing between t = low and high, at which L - target has different signs.
template <typename Space>
std::optional<ph::Controls> crossing(const Ray<Space>& ray, double low, double high, bool below, double target_m) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    ((ray.excess_m(middle, target_m) < 0.0) == below ? low : high) = middle;
  }
  const ph::Controls found = ray.at(0.5 * (low + high));
  if (!same_length(ray.uav.hermite.length_m(found), target_m)) return std::nullopt;
  return found;
}

template <typename Space>
std::optional<ph::Controls> first_crossing(const Ray<Space>& ray, bool below, double target_m) {
  double before = 0.0;
  for (double step = kFirstStep; before < ray.end; step *= kStepGrowth) {
    const double here = std::min(ray.end, before + step);
    if ((ray.excess_m(here, target_m) < 0.0) != below) return crossing(ray, before, here, below, target_m);
    before = here;
  }
  return std::nullopt;
}

}  // namespace

template <typename Space>
std::vector<ph::Controls> on_joined_rays(const ProblemIn<Space>& problem, const ph::Controls& from, double target_m,
                                         std::size_t first, std::size_t n) {
  const double length_m = problem.own().hermite.length_m(from);
  if (same_length(length_m, target_m)) return {from};
  std::vector<ph::Controls> found;
  for (std::size_t number = first; number < first + n; ++number) {
    const Ray<Space> ray = ray_of(problem, from, number);
    if (const auto controls = first_crossing(ray, length_m < target_m, target_m)) found.push_back(*controls);
  }
  return found;
}

template std::vector<ph::Controls> on_joined_rays(const ProblemIn<Planar>&, const ph::Controls&, double, std::size_t,
                                                  std::size_t);
template std::vector<ph::Controls> on_joined_rays(const ProblemIn<Spatial>&, const ph::Controls&, double, std::size_t,
                                                  std::size_t);

}  // namespace skein::rendezvous
