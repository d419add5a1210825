#include "planner/rendezvous/cost/cost.hpp"

#include <algorithm>

#include "planner/rendezvous/cost/batch.hpp"
#include "planner/rendezvous/cost/scalar_cost.hpp"

namespace skein::rendezvous {
namespace {

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
void set_cooperation(const ProblemIn<Space>& problem, bool collides, std::optional<double> reference_length_m,
                     EvaluationIn<Space>& evaluation) {
  CostTerms& terms = evaluation.terms;
  terms.collision = collides ? problem.options.penalty : 0.0;
  terms.dtime = 0.0;
  if (reference_length_m) {
    const double difference = (evaluation.length_m - *reference_length_m) / problem.length_unit_m;
    terms.dtime = problem.options.length_penalty * difference * difference;
  }
  evaluation.modified = modified_cost(terms, problem.options.length_weight);
}

template <typename Space>
void evaluate(const ProblemIn<Space>& problem, const ph::Controls& controls, EvaluationIn<Space>& into) {
  if (controls.is_joined()) return evaluate_scalar(problem, controls, into);
  into.controls = controls;
  BatchIn<Space> batch(problem, 1);
  batch.evaluate(problem, {&into, 1});
  into.points_m.resize(static_cast<std::size_t>(problem.options.check_points));
  PointTableIn<Space> points(into.points_m.size(), 1);
  constexpr std::size_t kOnly = 0;
  batch.walk(problem, {&kOnly, 1}, points);
  points.copy_to(kOnly, into.points_m);
}

template <typename Space>
void modify(const ProblemIn<Space>& problem, View<PeerPathIn<Space>> peers, std::optional<double> reference_length_m,
            EvaluationIn<Space>& evaluation) {
  const bool meets =
      std::ranges::any_of(peers, [&](const PeerPathIn<Space>& peer) { return collides(evaluation, peer); });
  set_cooperation(problem, meets, reference_length_m, evaluation);
}

template double bare_cost(const ProblemIn<Planar>&, const Planar::Path&);
template double bare_cost(const ProblemIn<Spatial>&, const Spatial::Path&);
template void set_cooperation(const ProblemIn<Planar>&, bool, std::optional<double>, EvaluationIn<Planar>&);
template void set_cooperation(const ProblemIn<Spatial>&, bool, std::optional<double>, EvaluationIn<Spatial>&);
template void evaluate(const ProblemIn<Planar>&, const ph::Controls&, EvaluationIn<Planar>&);
template void evaluate(const ProblemIn<Spatial>&, const ph::Controls&, EvaluationIn<Spatial>&);
template void modify(const ProblemIn<Planar>&, View<PeerPathIn<Planar>>, std::optional<double>, EvaluationIn<Planar>&);
template void modify(const ProblemIn<Spatial>&, View<PeerPathIn<Spatial>>, std::optional<double>,
                     EvaluationIn<Spatial>&);

}  // namespace skein::rendezvous
