#include "planner/rendezvous/cost/cost.hpp"

#include <algorithm>

#include "planner/rendezvous/cost/batch.hpp"

namespace skein::rendezvous {
namespace {

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

void set_cooperation(const Problem& problem, bool collides, std::optional<double> reference_length_m,
                     Evaluation& evaluation) {
  CostTerms& terms = evaluation.terms;
  terms.collision = collides ? problem.options.penalty : 0.0;
  terms.dtime = 0.0;
  if (reference_length_m) {
    const double difference = (evaluation.length_m - *reference_length_m) / problem.length_unit_m;
    terms.dtime = problem.options.length_penalty * difference * difference;
  }
  evaluation.modified = modified_cost(terms, problem.options.length_weight);
}

void evaluate(const Problem& problem, const ph::Controls& controls, Evaluation& into) {
  into.controls = controls;
  Batch batch(problem, 1);
  batch.evaluate(problem, {&into, 1});
  into.points_m.resize(static_cast<std::size_t>(problem.options.check_points));
  PointTable points(into.points_m.size(), 1);
  constexpr std::size_t kOnly = 0;
  batch.walk(problem, {&kOnly, 1}, points);
  points.copy_to(kOnly, into.points_m);
}

void modify(const Problem& problem, std::span<const PeerPath> peers, std::optional<double> reference_length_m,
            Evaluation& evaluation) {
  const bool meets =
      std::ranges::any_of(peers, [&](const PeerPath& peer) { return collides(evaluation.points_m, peer); });
  set_cooperation(problem, meets, reference_length_m, evaluation);
}

}  // namespace skein::rendezvous
