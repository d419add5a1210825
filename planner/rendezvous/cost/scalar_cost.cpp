#include "planner/rendezvous/cost/scalar_cost.hpp"

#include <algorithm>
#include <cmath>

namespace skein::rendezvous {
namespace {

/// Whether the chord from a to b comes closer to the zone than allowed; most pairs end at the enclosing disc.
template <typename Vec>
bool violates(const PlanarZone& zone, double keep_out_m, const Vec& a, const Vec& b) {
  if constexpr (Vec::RowsAtCompileTime == 3) {
    if (std::min(a.z(), b.z()) >= zone.heights_m.max + keep_out_m) return false;
    if (std::max(a.z(), b.z()) <= zone.heights_m.min - keep_out_m) return false;
  }
  const Vec2 half = 0.5 * (b - a).template head<2>();
  const double reach = zone.reach_m + keep_out_m + half.norm();
  if ((a.template head<2>() + half - zone.centre_m).squaredNorm() > reach * reach) return false;
  return distance_m(zone, a, b) < keep_out_m;
}

/// What only space has: torsion and terrain at one point.
void check_in_space(const ProblemIn<Spatial>& problem, const ph::SpatialPath& piece, double q, const Vec3& here,
                    CostTerms& terms) {
  const double penalty = problem.options.penalty;
  if (std::fabs(piece.torsion(q)) > problem.max_torsion_per_m) terms.twisted = penalty;
  if (terms.terrain > 0.0 || !problem.terrain || here.z() >= problem.terrain_roof_m) return;
  if (height_above_m(*problem.terrain, here) < problem.terrain_height_m) terms.terrain = penalty;
}

/// Zones, curvature, torsion and terrain at Np points of a piece, of equal parameter distance, and for zones the chords
/// between.
template <typename Space>
void check_constraints(const ProblemIn<Space>& problem, const typename Space::Piece& piece, CostTerms& terms) {
  const std::int32_t last = problem.options.check_points - 1;
  const double penalty = problem.options.penalty;
  typename Space::Vec before = piece.position(0.0);
  for (std::int32_t k = 0; k <= last; ++k) {
    const double q = static_cast<double>(k) / static_cast<double>(last);
    if (std::fabs(piece.curvature(q)) > problem.max_curvature_per_m) terms.unflyable = penalty;
    const typename Space::Vec here = piece.position(q);
    if constexpr (Space::kSpatial) check_in_space(problem, piece, q, here, terms);
    for (const PlanarZone& zone : problem.zones) {
      double& term = zone.no_fly ? terms.no_fly : terms.obstacle;
      if (term == 0.0 && violates(zone, problem.keep_out_m, before, here)) term = penalty;
    }
    before = here;
  }
}

}  // namespace

template <typename Space>
void evaluate_scalar(const ProblemIn<Space>& problem, const ph::Controls& controls, EvaluationIn<Space>& into) {
  const typename Space::Path path = problem.own().hermite.path(controls);
  into.controls = controls;
  into.length_m = path.length_m();
  into.terms = {};
  into.terms.length = path.length_m() / problem.length_unit_m;
  into.terms.curve_energy = path.elastic_energy_per_m() * problem.length_unit_m;
  for (const typename Space::Piece& piece : path.pieces()) check_constraints<Space>(problem, piece, into.terms);
  into.own = own_cost(into.terms, problem.options.length_weight);
  into.modified = into.own;
  into.points_m.resize(static_cast<std::size_t>(problem.options.check_points));
  equidistant_points(path, into.points_m);
}

template void evaluate_scalar(const ProblemIn<Planar>&, const ph::Controls&, EvaluationIn<Planar>&);
template void evaluate_scalar(const ProblemIn<Spatial>&, const ph::Controls&, EvaluationIn<Spatial>&);

}  // namespace skein::rendezvous
