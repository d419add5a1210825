#include "planner/rendezvous/cost/cost.hpp"

#include <cmath>

namespace skein::rendezvous {
namespace {

/// Whether the chord from a to b comes closer to the zone than allowed; most pairs end at the enclosing disc.
bool violates(const PlanarZone& zone, double keep_out_m, const Vec2& a, const Vec2& b) {
  const Vec2 half = 0.5 * (b - a);
  const double reach = zone.reach_m + keep_out_m + half.norm();
  if ((a + half - zone.centre_m).squaredNorm() > reach * reach) return false;
  return distance_m(zone, a, b) < keep_out_m;
}

/// Zones and curvature at Np points of equal parameter distance, and the chords between them.
void check_constraints(const Problem& problem, const ph::PlanarPath& path, CostTerms& terms) {
  const std::int32_t last = problem.options.check_points - 1;
  const double penalty = problem.options.penalty;
  Vec2 before = path.position(0.0);
  for (std::int32_t k = 0; k <= last; ++k) {
    const double q = static_cast<double>(k) / static_cast<double>(last);
    if (std::fabs(path.curvature(q)) > problem.max_curvature_per_m) terms.unflyable = penalty;
    const Vec2 here = path.position(q);
    for (const PlanarZone& zone : problem.zones) {
      double& term = zone.no_fly ? terms.no_fly : terms.obstacle;
      if (term == 0.0 && violates(zone, problem.keep_out_m, before, here)) term = penalty;
    }
    before = here;
  }
}

bool collides(std::span<const Vec2> own, const PeerPath& peer) {
  const double least_squared = peer.separation_m * peer.separation_m;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if ((own[k] - peer.points_m[k]).squaredNorm() < least_squared) return true;
  }
  return false;
}

}  // namespace

double bare_cost(const Problem& problem, const ph::PlanarPath& path) {
  const double weight = problem.options.length_weight;
  return weight * path.length_m() / problem.length_unit_m +
         (1.0 - weight) * path.elastic_energy_per_m() * problem.length_unit_m;
}

double own_cost(const CostTerms& terms, double length_weight) {
  return length_weight * terms.length + (1.0 - length_weight) * terms.curve_energy + terms.obstacle + terms.no_fly +
         terms.unflyable;
}

double modified_cost(const CostTerms& terms, double length_weight) {
  return own_cost(terms, length_weight) + terms.collision + terms.dtime;
}

Constraint first_violation(const CostTerms& terms) {
  if (terms.unflyable > 0.0) return Constraint::Curvature;
  if (terms.obstacle > 0.0) return Constraint::Obstacle;
  if (terms.no_fly > 0.0) return Constraint::NoFly;
  return terms.collision > 0.0 ? Constraint::Separation : Constraint::None;
}

void evaluate(const Problem& problem, const ph::Controls& controls, Evaluation& into) {
  const ph::PlanarPath path = problem.own().hermite.path(controls);
  into.controls = controls;
  into.length_m = path.length_m();
  into.terms = {};
  into.terms.length = path.length_m() / problem.length_unit_m;
  into.terms.curve_energy = path.elastic_energy_per_m() * problem.length_unit_m;
  check_constraints(problem, path, into.terms);
  into.own = own_cost(into.terms, problem.options.length_weight);
  into.modified = into.own;
  into.points_m.resize(static_cast<std::size_t>(problem.options.check_points));
  equidistant_points(path, into.points_m);
}

void modify(const Problem& problem, std::span<const PeerPath> peers, std::optional<double> reference_length_m,
            Evaluation& evaluation) {
  CostTerms& terms = evaluation.terms;
  terms.collision = 0.0;
  for (const PeerPath& peer : peers) {
    if (terms.collision == 0.0 && collides(evaluation.points_m, peer)) terms.collision = problem.options.penalty;
  }
  terms.dtime = 0.0;
  if (reference_length_m) {
    const double difference = (evaluation.length_m - *reference_length_m) / problem.length_unit_m;
    terms.dtime = problem.options.length_penalty * difference * difference;
  }
  evaluation.modified = modified_cost(terms, problem.options.length_weight);
}

}  // namespace skein::rendezvous
