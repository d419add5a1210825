#include "planner/rendezvous/cost/cost.hpp"

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
void check_in_space(const ProblemIn<Spatial>& problem, const ph::SpatialPath& path, double q, const Vec3& here,
                    CostTerms& terms) {
  const double penalty = problem.options.penalty;
  if (std::fabs(path.torsion(q)) > problem.max_torsion_per_m) terms.twisted = penalty;
  if (terms.terrain > 0.0 || !problem.terrain || here.z() >= problem.terrain_roof_m) return;
  if (height_above_m(*problem.terrain, here) < problem.terrain_height_m) terms.terrain = penalty;
}

/// Zones, curvature, torsion and terrain at Np points of equal parameter distance, and for zones the chords between.
template <typename Space>
void check_constraints(const ProblemIn<Space>& problem, const typename Space::Path& path, CostTerms& terms) {
  const std::int32_t last = problem.options.check_points - 1;
  const double penalty = problem.options.penalty;
  typename Space::Vec before = path.position(0.0);
  for (std::int32_t k = 0; k <= last; ++k) {
    const double q = static_cast<double>(k) / static_cast<double>(last);
    if (std::fabs(path.curvature(q)) > problem.max_curvature_per_m) terms.unflyable = penalty;
    const typename Space::Vec here = path.position(q);
    if constexpr (Space::kSpatial) check_in_space(problem, path, q, here, terms);
    for (const PlanarZone& zone : problem.zones) {
      double& term = zone.no_fly ? terms.no_fly : terms.obstacle;
      if (term == 0.0 && violates(zone, problem.keep_out_m, before, here)) term = penalty;
    }
    before = here;
  }
}

template <typename Space>
bool collides(const EvaluationIn<Space>& evaluation, const PeerPathIn<Space>& peer) {
  const auto& own = evaluation.points_m;
  const double least_squared = peer.separation_m * peer.separation_m;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if ((own[k] - peer.points_m[k]).squaredNorm() < least_squared) return true;
  }
  return false;
}

}  // namespace

template <typename Space>
double bare_cost(const ProblemIn<Space>& problem, const typename Space::Path& path) {
  const double weight = problem.options.length_weight;
  return weight * path.length_m() / problem.length_unit_m +
         (1.0 - weight) * path.elastic_energy_per_m() * problem.length_unit_m;
}

double own_cost(const CostTerms& terms, double length_weight) {
  return length_weight * terms.length + (1.0 - length_weight) * terms.curve_energy + terms.obstacle + terms.no_fly +
         std::max(terms.unflyable, terms.twisted) + terms.terrain;
}

double modified_cost(const CostTerms& terms, double length_weight) {
  return own_cost(terms, length_weight) + terms.collision + terms.dtime;
}

Constraint first_violation(const CostTerms& terms) {
  if (terms.unflyable > 0.0) return Constraint::Curvature;
  if (terms.twisted > 0.0) return Constraint::Torsion;
  if (terms.obstacle > 0.0) return Constraint::Obstacle;
  if (terms.no_fly > 0.0) return Constraint::NoFly;
  if (terms.terrain > 0.0) return Constraint::Terrain;
  return terms.collision > 0.0 ? Constraint::Separation : Constraint::None;
}

template <typename Space>
void evaluate(const ProblemIn<Space>& problem, const ph::Controls& controls, EvaluationIn<Space>& into) {
  const typename Space::Path path = problem.own().hermite.path(controls);
  into.controls = controls;
  into.length_m = path.length_m();
  into.terms = {};
  into.terms.length = path.length_m() / problem.length_unit_m;
  into.terms.curve_energy = path.elastic_energy_per_m() * problem.length_unit_m;
  check_constraints<Space>(problem, path, into.terms);
  into.own = own_cost(into.terms, problem.options.length_weight);
  into.modified = into.own;
  into.points_m.resize(static_cast<std::size_t>(problem.options.check_points));
  equidistant_points(path, into.points_m);
}

template <typename Space>
void modify(const ProblemIn<Space>& problem, View<PeerPathIn<Space>> peers, std::optional<double> reference_length_m,
            EvaluationIn<Space>& evaluation) {
  CostTerms& terms = evaluation.terms;
  terms.collision = 0.0;
  for (const PeerPathIn<Space>& peer : peers) {
    if (terms.collision == 0.0 && collides(evaluation, peer)) terms.collision = problem.options.penalty;
  }
  terms.dtime = 0.0;
  if (reference_length_m) {
    const double difference = (evaluation.length_m - *reference_length_m) / problem.length_unit_m;
    terms.dtime = problem.options.length_penalty * difference * difference;
  }
  evaluation.modified = modified_cost(terms, problem.options.length_weight);
}

template double bare_cost(const ProblemIn<Planar>&, const ph::PlanarPath&);
template double bare_cost(const ProblemIn<Spatial>&, const ph::SpatialPath&);
template void evaluate(const ProblemIn<Planar>&, const ph::Controls&, EvaluationIn<Planar>&);
template void evaluate(const ProblemIn<Spatial>&, const ph::Controls&, EvaluationIn<Spatial>&);
template void modify(const ProblemIn<Planar>&, View<PeerPathIn<Planar>>, std::optional<double>, EvaluationIn<Planar>&);
template void modify(const ProblemIn<Spatial>&, View<PeerPathIn<Spatial>>, std::optional<double>,
                     EvaluationIn<Spatial>&);

}  // namespace skein::rendezvous
