#include "planner/rendezvous/align/level_set.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/rendezvous/cost/batch.hpp"

namespace skein::rendezvous {
namespace {

/// First step along a ray, as a part of the search range, and its growth.
constexpr double kFirstStep = 1e-4;
constexpr double kStepGrowth = 1.6;
constexpr int kBisections = 60;

ph::Controls between(const Interval& range, const ph::Controls& a, const ph::Controls& b, double t) {
  return {range.clamp(a.m0_m + t * (b.m0_m - a.m0_m)), range.clamp(a.m1_m + t * (b.m1_m - a.m1_m))};
}

/// Lengths of many controls of one UAV.
template <typename Space>
class Lengths {
 public:
  Lengths(const ParticipantIn<Space>& uav, std::size_t most, const kernel::Kernel& kernel)
      : steps_(Space::steps(kernel)), ends_(Space::EndRows::Count, most), controls_(2, most), lengths_m_(1, most) {
    for (std::size_t lane = 0; lane < kernel::padded(most); ++lane) put_ends(uav.hermite, lane, ends_);
  }

  void set(std::size_t lane, const ph::Controls& m) {
    controls_.row(0)[lane] = m.m0_m;
    controls_.row(1)[lane] = m.m1_m;
  }
  /// Of lanes 0 .. count - 1, count at least 1.
  void measure(std::size_t count) {
    controls_.pad(count);
    steps_.measure(ends_.view(), controls_.row(0), controls_.row(1), count, lengths_m_.row(0));
  }
  [[nodiscard]] double length_m(std::size_t lane) const { return lengths_m_.row(0)[lane]; }

 private:
  const kernel::Steps& steps_;
  kernel::LaneTable ends_;
  kernel::LaneTable controls_;
  kernel::LaneTable lengths_m_;
};

/// Two controls between which L - target changes its sign, and its value at the first.
struct Bracket {
  ph::Controls a;
  ph::Controls b;
  double f_a;
};

/// The crossings within brackets, in their order, without those that are jumps.
template <typename Space>
std::vector<ph::Controls> crossings(const ParticipantIn<Space>& uav, const std::vector<Bracket>& brackets,
                                    double target_m, const kernel::Kernel& kernel) {
  std::vector<ph::Controls> found;
  if (brackets.empty()) return found;
  const std::size_t count = brackets.size();
  Lengths<Space> lengths(uav, count, kernel);
  std::vector<Interval> part(count, Interval{0.0, 1.0});
  const auto middle = [&](std::size_t i) { return 0.5 * (part[i].min + part[i].max); };
  const auto measure_middles = [&] {
    for (std::size_t i = 0; i < count; ++i) {
      lengths.set(i, between(uav.range_m, brackets[i].a, brackets[i].b, middle(i)));
    }
    lengths.measure(count);
  };
  for (int step = 0; step < kBisections; ++step) {
    measure_middles();
    for (std::size_t i = 0; i < count; ++i) {
      const bool as_at_a = (lengths.length_m(i) - target_m < 0.0) == (brackets[i].f_a < 0.0);
      (as_at_a ? part[i].min : part[i].max) = middle(i);
    }
  }
  measure_middles();
  for (std::size_t i = 0; i < count; ++i) {
    if (!same_length(lengths.length_m(i), target_m)) continue;
    found.push_back(between(uav.range_m, brackets[i].a, brackets[i].b, middle(i)));
  }
  return found;
}

/// How far one may go from x in direction d before the range ends.
double reach(const Interval& range, double x, double d) {
  if (d > 0.0) return (range.max - x) / d;
  return d < 0.0 ? (range.min - x) / d : HUGE_VAL;
}

/// One of many rays that leave the same controls.
struct Ray {
  math::SinCos d;
  double end;  ///< where it leaves the range
  double t = 0.0;
  Bracket last{};  ///< the two places looked at last
  bool crosses = false;
};

/// Steps along each ray until L - target changes its sign or the range ends.
template <typename Space>
void march(const ParticipantIn<Space>& uav, const ph::Controls& from, double target_m, std::vector<Ray>& rays,
           const kernel::Kernel& kernel) {
  Lengths<Space> lengths(uav, rays.size(), kernel);
  std::vector<Ray*> open;
  for (Ray& ray : rays) {
    if (ray.t < ray.end) open.push_back(&ray);
  }
  for (double step = kFirstStep * uav.range_m.width(); !open.empty(); step *= kStepGrowth) {
    for (std::size_t i = 0; i < open.size(); ++i) {
      Ray& ray = *open[i];
      ray.t = std::min(ray.end, ray.t + step);
      ray.last.b = {uav.range_m.clamp(from.m0_m + ray.t * ray.d.cos), uav.range_m.clamp(from.m1_m + ray.t * ray.d.sin)};
      lengths.set(i, ray.last.b);
    }
    lengths.measure(open.size());
    for (std::size_t i = 0; i < open.size(); ++i) {
      Ray& ray = *open[i];
      const double f = lengths.length_m(i) - target_m;
      ray.crosses = (f < 0.0) != (ray.last.f_a < 0.0);
      if (!ray.crosses) ray.last = {ray.last.b, {}, f};
    }
    std::erase_if(open, [](const Ray* ray) { return ray->crosses || ray->t >= ray->end; });
  }
}

}  // namespace

bool same_length(double a_m, double b_m) {
  return std::fabs(a_m - b_m) <= kLengthTolerance * std::max(a_m, b_m);
}

template <typename Space>
std::vector<ph::Controls> on_rays(const ParticipantIn<Space>& uav, const ph::Controls& from, double target_m,
                                  std::int32_t n, const kernel::Kernel& kernel) {
  const double length_m = uav.hermite.length_m(from);
  const double f_from = length_m - target_m;
  if (same_length(length_m, target_m)) return {from};
  std::vector<Ray> rays;
  for (std::int32_t k = 0; k < n; ++k) {
    const math::SinCos d = math::sincos(math::kTwoPi * static_cast<double>(k) / static_cast<double>(n));
    const double end = std::min(reach(uav.range_m, from.m0_m, d.cos), reach(uav.range_m, from.m1_m, d.sin));
    rays.push_back({d, end, 0.0, {from, {}, f_from}, false});
  }
  march(uav, from, target_m, rays, kernel);
  std::vector<Bracket> brackets;
  for (const Ray& ray : rays) {
    if (ray.crosses) brackets.push_back(ray.last);
  }
  return crossings(uav, brackets, target_m, kernel);
}

template <typename Space>
std::vector<ph::Controls> on_grid(const ParticipantIn<Space>& uav, double target_m, std::int32_t n,
                                  const kernel::Kernel& kernel) {
  const auto node = [&](std::size_t i) {
    return uav.range_m.clamp(uav.range_m.min + uav.range_m.width() * static_cast<double>(i) / (n - 1));
  };
  const auto nodes = static_cast<std::size_t>(n);
  Lengths<Space> lengths(uav, nodes, kernel);
  std::vector<double> row_before(nodes);
  std::vector<double> row(nodes);
  std::vector<Bracket> brackets;
  const auto try_edge = [&](const ph::Controls& a, const ph::Controls& b, double f_a, double f_b) {
    if ((f_a < 0.0) != (f_b < 0.0)) brackets.push_back({a, b, f_a});
  };
  for (std::size_t i = 0; i < nodes; ++i) {
    for (std::size_t j = 0; j < nodes; ++j) lengths.set(j, {node(i), node(j)});
    lengths.measure(nodes);
    for (std::size_t j = 0; j < nodes; ++j) {
      const ph::Controls here{node(i), node(j)};
      row[j] = lengths.length_m(j) - target_m;
      if (j > 0) try_edge({node(i), node(j - 1)}, here, row[j - 1], row[j]);
      if (i > 0) try_edge({node(i - 1), node(j)}, here, row_before[j], row[j]);
    }
    row_before = row;
  }
  return crossings(uav, brackets, target_m, kernel);
}

template std::vector<ph::Controls> on_rays(const ParticipantIn<Planar>&, const ph::Controls&, double, std::int32_t,
                                           const kernel::Kernel&);
template std::vector<ph::Controls> on_grid(const ParticipantIn<Planar>&, double, std::int32_t, const kernel::Kernel&);
template std::vector<ph::Controls> on_rays(const ParticipantIn<Spatial>&, const ph::Controls&, double, std::int32_t,
                                           const kernel::Kernel&);
template std::vector<ph::Controls> on_grid(const ParticipantIn<Spatial>&, double, std::int32_t, const kernel::Kernel&);

}  // namespace skein::rendezvous
