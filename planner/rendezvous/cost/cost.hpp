// The cost of one candidate path, term by term, and its modification by the other UAVs' representatives.
//
//   1 / f  = w1 L + (1 - w1) E + J_obsc + J_nofly + J_terr + J_unflyable                         (Eq. 11)
//   1 / f' = 1 / f + J_collision + J_dtime                                                       (Eq. 14)
// with a fixed penalty for each violated constraint (Eq. 11, 12, 15) and J_dtime = 100 |L - Lref|^2 for all but the
// reference UAV (Eq. 16). Zones and curvature are checked at Np points of equal parameter distance, separation at Nph
// = Np points of equal arc length, those with the same number being reached at the same time (Eq. 17).
//
// Source: papers/001, section 3.2.3 and 3.2.4. Departs from source: between neighbouring points the chord is held
// against the zones as well, so that no corner slips through the 50 points; the strict inequality of Eq. 17 is kept as
// 'not less than'. Complexity: O(Np (zones + Newton)) to evaluate, O(Np peers) to modify.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/cost/problem.hpp"

namespace skein::rendezvous {

/// Every term of Eq. 11 and 14, in the mission's length unit (energy: per unit), before weighting.
struct CostTerms {
  double length = 0.0;        ///< J_fuel
  double curve_energy = 0.0;  ///< J_curve
  double obstacle = 0.0;      ///< J_obsc
  double no_fly = 0.0;        ///< J_nofly
  double unflyable = 0.0;     ///< J_unflyable, Eq. 12, by curvature
  double twisted = 0.0;       ///< J_unflyable, Eq. 12, by torsion; counts once with unflyable
  double terrain = 0.0;       ///< J_terr
  double collision = 0.0;     ///< J_collision, Eq. 15
  double dtime = 0.0;         ///< J_dtime, Eq. 16

  bool operator==(const CostTerms&) const = default;
};

/// w1 L + (1 - w1) E: the cost of a path that violates nothing.
template <typename Space>
[[nodiscard]] double bare_cost(const ProblemIn<Space>& problem, const typename Space::Path& path);
/// 1 / f of Eq. 11: the cost of a path for itself.
[[nodiscard]] double own_cost(const CostTerms& terms, double length_weight);
/// 1 / f' of Eq. 14: the cost of a path in its cooperative group.
[[nodiscard]] double modified_cost(const CostTerms& terms, double length_weight);
/// The first constraint that a path violates, in the order of the enumeration; length counts as none.
[[nodiscard]] Constraint first_violation(const CostTerms& terms);
/// Whether a constraint is violated by a path alone, whatever the others fly: any but None and Separation.
[[nodiscard]] constexpr bool has_own_trouble(Constraint violated) {
  return violated != Constraint::None && violated != Constraint::Separation;
}

/// A candidate with everything that its cost needs.
template <typename Space>
struct EvaluationIn {
  ph::Controls controls;
  double length_m = 0.0;
  CostTerms terms;
  double own = 0.0;                           ///< own_cost
  double modified = 0.0;                      ///< modified_cost
  std::vector<typename Space::Vec> points_m;  ///< Nph equidistant points; empty where they are kept in lanes
};

/// The representative of a peer, as modification needs it.
template <typename Space>
struct PeerPathIn {
  AgentId id = 0;
  double separation_m = 0.0;                  ///< to be kept from it
  std::vector<typename Space::Vec> points_m;  ///< Nph equidistant points
};

using Evaluation = EvaluationIn<Planar>;
using PeerPath = PeerPathIn<Planar>;

/// For one candidate; many are evaluated together by cost/batch, with the same results.
/// Fills `into` for controls within the search range: terms of Eq. 11; collision and dtime 0, modified = own.
template <typename Space>
void evaluate(const ProblemIn<Space>& problem, const ph::Controls& controls, EvaluationIn<Space>& into);

/// Sets collision and dtime. `reference_length_m`: Lref, or nothing for the reference UAV itself.
template <typename Space>
void modify(const ProblemIn<Space>& problem, View<PeerPathIn<Space>> peers, std::optional<double> reference_length_m,
            EvaluationIn<Space>& evaluation);

/// The same for who knows already whether the path collides with some peer.
template <typename Space>
void set_cooperation(const ProblemIn<Space>& problem, bool collides, std::optional<double> reference_length_m,
                     EvaluationIn<Space>& evaluation);

}  // namespace skein::rendezvous
