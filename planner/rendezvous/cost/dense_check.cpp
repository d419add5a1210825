#include "planner/rendezvous/cost/dense_check.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/rendezvous/cost/batch.hpp"

namespace skein::rendezvous {
namespace {

/// How far, relatively, the curvature that the sag is made from may lie above the path's own.
constexpr double kBoundTolerance = 0.05;

template <typename Space>
double gap_m(const DensePathIn<Space>& dense) {
  return dense.path.length_m() / static_cast<double>(dense.points_m.size() - 1);
}

/// How many samples may be skipped while a distance shrinks by at most `rate` a sample and `spare` is left.
std::size_t skipped(double spare, double rate, std::size_t count) {
  if (!(spare > rate)) return 0;
  return static_cast<std::size_t>(std::min(spare / rate - 1.0, static_cast<double>(count)));
}

template <typename Space>
bool clear_of(const PlanarZone& zone, double least_m, const DensePathIn<Space>& dense) {
  const double gap = gap_m(dense);
  for (std::size_t k = 0; k + 1 < dense.points_m.size();) {
    const double distance = distance_m(zone, dense.points_m[k], dense.points_m[k + 1]);
    if (distance < least_m + dense.sag_m) return false;
    k += 1 + skipped(distance - least_m - dense.sag_m, gap, dense.points_m.size());
  }
  return true;
}

bool clear_of(const Terrain& terrain, double least_m, const DensePathIn<Spatial>& dense) {
  const double tilt = tilt_of(terrain);
  const double least = least_m + dense.sag_m * tilt;
  for (std::size_t k = 0; k + 1 < dense.points_m.size();) {
    const double height = least_height_above_m(terrain, dense.points_m[k], dense.points_m[k + 1]);
    if (height < least) return false;
    k += 1 + skipped(height - least, gap_m(dense) * tilt, dense.points_m.size());
  }
  return true;
}

bool flyable(const ProblemIn<Planar>& problem, const Planar::Path& path, Constraint& fails) {
  fails = Constraint::Curvature;
  return ph::curvature_within(path, problem.max_curvature_per_m);
}

bool flyable(const ProblemIn<Spatial>& problem, const Spatial::Path& path, Constraint& fails) {
  fails = Constraint::Curvature;
  if (!ph::curvature_within(path, problem.max_curvature_per_m)) return false;
  fails = Constraint::Torsion;
  return ph::torsion_within(path, problem.max_torsion_per_m);
}

}  // namespace

template <typename Space>
DensePathIn<Space> sample_densely(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  DensePathIn<Space> dense{path,
                           std::vector<typename Space::Vec>(static_cast<std::size_t>(problem.options.dense_points)),
                           ph::max_curvature_per_m(path, kBoundTolerance), 0.0};
  walk_in_parts<Space>(*problem.kernel, path, dense.points_m);
  dense.sag_m = dense.curvature_bound_per_m * gap_m(dense) * gap_m(dense) / 8.0;
  return dense;
}

template <typename Space>
Constraint check_alone(const ProblemIn<Space>& problem, const DensePathIn<Space>& dense) {
  if (Constraint fails{}; !flyable(problem, dense.path, fails)) return fails;
  for (const bool no_fly : {false, true}) {
    for (const PlanarZone& zone : problem.zones) {
      if (zone.no_fly == no_fly && !clear_of(zone, problem.keep_out_m, dense)) {
        return no_fly ? Constraint::NoFly : Constraint::Obstacle;
      }
    }
  }
  if constexpr (Space::kSpatial) {
    if (problem.terrain && !clear_of(*problem.terrain, problem.terrain_height_m, dense)) return Constraint::Terrain;
  }
  return Constraint::None;
}

template <typename Space>
Constraint check_alone(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  const Constraint refuted = refute<Space>(problem, path);
  return refuted != Constraint::None ? refuted : check_alone(problem, sample_densely<Space>(problem, path));
}

template <typename Space>
Constraint refute(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  if (Constraint fails{}; !flyable(problem, path, fails)) return fails;
  const std::int32_t last = (problem.options.check_points - 1) * static_cast<std::int32_t>(path.pieces().size());
  Constraint found = Constraint::None;
  for (std::int32_t k = 0; k <= last; ++k) {
    const typename Space::Vec here = path.position(static_cast<double>(k) / static_cast<double>(last));
    if constexpr (Space::kSpatial) {
      const bool low = problem.terrain && height_above_m(*problem.terrain, here) < problem.terrain_height_m;
      if (low && found == Constraint::None) found = Constraint::Terrain;
    }
    for (const PlanarZone& zone : problem.zones) {
      if (distance_m(zone, here) >= problem.keep_out_m) continue;
      if (!zone.no_fly) return Constraint::Obstacle;
      found = Constraint::NoFly;
    }
  }
  return found;
}

template <typename Space>
bool keeps_apart(const DensePathIn<Space>& a, const DensePathIn<Space>& b, double separation_m) {
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

template DensePathIn<Planar> sample_densely(const ProblemIn<Planar>&, const Planar::Path&);
template Constraint check_alone(const ProblemIn<Planar>&, const DensePathIn<Planar>&);
template Constraint check_alone(const ProblemIn<Planar>&, const Planar::Path&);
template Constraint refute(const ProblemIn<Planar>&, const Planar::Path&);
template bool keeps_apart(const DensePathIn<Planar>&, const DensePathIn<Planar>&, double);
template DensePathIn<Spatial> sample_densely(const ProblemIn<Spatial>&, const Spatial::Path&);
template Constraint check_alone(const ProblemIn<Spatial>&, const DensePathIn<Spatial>&);
template Constraint check_alone(const ProblemIn<Spatial>&, const Spatial::Path&);
template Constraint refute(const ProblemIn<Spatial>&, const Spatial::Path&);
template bool keeps_apart(const DensePathIn<Spatial>&, const DensePathIn<Spatial>&, double);

}  // namespace skein::rendezvous
