#include "planner/rendezvous/align/level_set.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/core/math/det_math.hpp"

namespace skein::rendezvous {
namespace {

/// First step along a ray, as a part of the search range, and its growth.
constexpr double kFirstStep = 1e-4;
constexpr double kStepGrowth = 1.6;
constexpr int kBisections = 60;

ph::Controls between(const Interval& range, const ph::Controls& a, const ph::Controls& b, double t) {
  return {range.clamp(a.m0_m + t * (b.m0_m - a.m0_m)), range.clamp(a.m1_m + t * (b.m1_m - a.m1_m))};
}

/// Crossing between a and b, at which L - target has the values f_a and f_b of different sign.
template <typename Space>
std::optional<ph::Controls> crossing(const ParticipantIn<Space>& uav, const ph::Controls& a, const ph::Controls& b,
                                     double f_a, double target_m) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    const double f = uav.hermite.length_m(between(uav.range_m, a, b, middle)) - target_m;
    ((f < 0.0) == (f_a < 0.0) ? low : high) = middle;
  }
  const ph::Controls found = between(uav.range_m, a, b, 0.5 * (low + high));
  if (!same_length(uav.hermite.length_m(found), target_m)) return std::nullopt;
  return found;
}

/// How far one may go from x in direction d before the range ends.
double reach(const Interval& range, double x, double d) {
  if (d > 0.0) return (range.max - x) / d;
  return d < 0.0 ? (range.min - x) / d : HUGE_VAL;
}

template <typename Space>
std::optional<ph::Controls> on_ray(const ParticipantIn<Space>& uav, const ph::Controls& from, double angle_rad,
                                   double target_m) {
  const math::SinCos d = math::sincos(angle_rad);
  const double end = std::min(reach(uav.range_m, from.m0_m, d.cos), reach(uav.range_m, from.m1_m, d.sin));
  const auto at = [&](double t) {
    return ph::Controls{uav.range_m.clamp(from.m0_m + t * d.cos), uav.range_m.clamp(from.m1_m + t * d.sin)};
  };
  ph::Controls before = from;
  double f_before = uav.hermite.length_m(from) - target_m;
  double t = 0.0;
  for (double step = kFirstStep * uav.range_m.width(); t < end; step *= kStepGrowth) {
    t = std::min(end, t + step);
    const ph::Controls here = at(t);
    const double f = uav.hermite.length_m(here) - target_m;
    if ((f < 0.0) != (f_before < 0.0)) return crossing(uav, before, here, f_before, target_m);
    before = here;
    f_before = f;
  }
  return std::nullopt;
}

}  // namespace

bool same_length(double a_m, double b_m) {
  return std::fabs(a_m - b_m) <= kLengthTolerance * std::max(a_m, b_m);
}

template <typename Space>
std::vector<ph::Controls> on_rays(const ParticipantIn<Space>& uav, const ph::Controls& from, double target_m,
                                  std::int32_t n) {
  if (same_length(uav.hermite.length_m(from), target_m)) return {from};
  std::vector<ph::Controls> found;
  for (std::int32_t k = 0; k < n; ++k) {
    const double angle_rad = math::kTwoPi * static_cast<double>(k) / static_cast<double>(n);
    if (const auto controls = on_ray(uav, from, angle_rad, target_m)) found.push_back(*controls);
  }
  return found;
}

template <typename Space>
std::vector<ph::Controls> on_grid(const ParticipantIn<Space>& uav, double target_m, std::int32_t n) {
  const auto node = [&](std::int32_t i) {
    return uav.range_m.clamp(uav.range_m.min + uav.range_m.width() * static_cast<double>(i) / (n - 1));
  };
  std::vector<ph::Controls> found;
  std::vector<double> row_before;
  std::vector<double> row(static_cast<std::size_t>(n));
  const auto try_edge = [&](const ph::Controls& a, const ph::Controls& b, double f_a, double f_b) {
    if ((f_a < 0.0) == (f_b < 0.0)) return;
    if (const auto controls = crossing(uav, a, b, f_a, target_m)) found.push_back(*controls);
  };
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      const ph::Controls here{node(i), node(j)};
      row[at] = uav.hermite.length_m(here) - target_m;
      if (j > 0) try_edge({node(i), node(j - 1)}, here, row[at - 1], row[at]);
      if (i > 0) try_edge({node(i - 1), node(j)}, here, row_before[at], row[at]);
    }
    row_before = row;
  }
  return found;
}

template std::vector<ph::Controls> on_rays(const ParticipantIn<Planar>&, const ph::Controls&, double, std::int32_t);
template std::vector<ph::Controls> on_grid(const ParticipantIn<Planar>&, double, std::int32_t);
template std::vector<ph::Controls> on_rays(const ParticipantIn<Spatial>&, const ph::Controls&, double, std::int32_t);
template std::vector<ph::Controls> on_grid(const ParticipantIn<Spatial>&, double, std::int32_t);

}  // namespace skein::rendezvous
