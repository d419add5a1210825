#include "planner/rendezvous/cost/dense_check.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/rendezvous/cost/batch.hpp"
#include "planner/rendezvous/ph/curvature_bound.hpp"

namespace skein::rendezvous {
namespace {

/// How far, relatively, the curvature that the sag is made from may lie above the path's own.
constexpr double kBoundTolerance = 0.05;

double gap_m(const DensePath& dense) {
  return dense.path.length_m() / static_cast<double>(dense.points_m.size() - 1);
}

/// How many samples may be skipped while a distance shrinks by at most `rate` a sample and `spare` is left.
std::size_t skipped(double spare, double rate, std::size_t count) {
  if (!(spare > rate)) return 0;
  return static_cast<std::size_t>(std::min(spare / rate - 1.0, static_cast<double>(count)));
}

bool clear_of(const PlanarZone& zone, double least_m, const DensePath& dense) {
  const double gap = gap_m(dense);
  for (std::size_t k = 0; k + 1 < dense.points_m.size();) {
    const double distance = distance_m(zone, dense.points_m[k], dense.points_m[k + 1]);
    if (distance < least_m + dense.sag_m) return false;
    k += 1 + skipped(distance - least_m - dense.sag_m, gap, dense.points_m.size());
  }
  return true;
}

}  // namespace

DensePath sample_densely(const Problem& problem, const ph::PlanarPath& path) {
  DensePath dense{path, std::vector<Vec2>(static_cast<std::size_t>(problem.options.dense_points)),
                  ph::max_curvature_per_m(path, kBoundTolerance), 0.0};
  walk_in_parts(*problem.kernel, path, dense.points_m);
  dense.sag_m = dense.curvature_bound_per_m * gap_m(dense) * gap_m(dense) / 8.0;
  return dense;
}

Constraint check_alone(const Problem& problem, const DensePath& dense) {
  if (!ph::curvature_within(dense.path, problem.max_curvature_per_m)) return Constraint::Curvature;
  for (const bool no_fly : {false, true}) {
    for (const PlanarZone& zone : problem.zones) {
      if (zone.no_fly == no_fly && !clear_of(zone, problem.keep_out_m, dense)) {
        return no_fly ? Constraint::NoFly : Constraint::Obstacle;
      }
    }
  }
  return Constraint::None;
}

Constraint check_alone(const Problem& problem, const ph::PlanarPath& path) {
  const Constraint refuted = refute(problem, path);
  return refuted != Constraint::None ? refuted : check_alone(problem, sample_densely(problem, path));
}

Constraint refute(const Problem& problem, const ph::PlanarPath& path) {
  if (!ph::curvature_within(path, problem.max_curvature_per_m)) return Constraint::Curvature;
  const std::int32_t last = problem.options.check_points - 1;
  Constraint found = Constraint::None;
  for (std::int32_t k = 0; k <= last; ++k) {
    const Vec2 here = path.position(static_cast<double>(k) / static_cast<double>(last));
    for (const PlanarZone& zone : problem.zones) {
      if (distance_m(zone, here) >= problem.keep_out_m) continue;
      if (!zone.no_fly) return Constraint::Obstacle;
      found = Constraint::NoFly;
    }
  }
  return found;
}

bool keeps_apart(const DensePath& a, const DensePath& b, double separation_m) {
  if (separation_m <= 0.0) return true;
  const double least = separation_m + (a.sag_m + b.sag_m);
  const double rate = gap_m(a) + gap_m(b);
  for (std::size_t k = 0; k + 1 < a.points_m.size();) {
    const double distance =
        closest_approach(a.points_m[k], a.points_m[k + 1], b.points_m[k], b.points_m[k + 1]).distance_m;
    if (distance < least) return false;
    k += 1 + skipped(distance - least, rate, a.points_m.size());
  }
  return true;
}

}  // namespace skein::rendezvous
