// The population of one UAV in a conventional cooperative co-evolutionary genetic algorithm (CCGA).
//
// A generation, from M individuals (m0, m1) with fitness f' = 1 / cost (Eq. 14) in their cooperative group:
//   parents    by roulette, p_j = f'_j / sum f', a pair for every two children
//   crossover  arithmetic, with probability p_c: a x + (1 - a) y and (1 - a) x + a y, a uniform in [0, 1]
//   mutation   with probability p_m each of m0 and m1 is drawn anew from the search range
//   elite      the best individual of the generation before takes the place of the worst child
// Its cooperative group, costs and representatives are those of the sub-swarm. By default its reference length is the
// longest representative's (own_reference 0): to tell own from modified fitness there is DCPSO's, not conventional.
//
// Source: papers/001, section 4.1, names the algorithm and cites [32-34] alone; operators, p_c and p_m are ours.
// Departs from source: none known. Complexity: O(M (evaluation + Np peers + M)) a generation.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/swarm/lazy_costs.hpp"

namespace skein::rendezvous {

template <typename Space>
class GeneticPopulationIn {
 public:
  using Problem = ProblemIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using PeerPath = PeerPathIn<Space>;

  /// Generation 0: random individuals (those of the sub-swarm of the same seed), judged by their own cost.
  explicit GeneticPopulationIn(const Problem& problem);

  /// The next generation; parameters as of SubSwarm::advance.
  void advance(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m);
  void advance(const Problem& problem, View<PeerPath> peers, std::optional<double> reference_length_m);

  [[nodiscard]] std::int32_t generation() const { return generation_; }
  /// The representative: best individual by modified cost (Eq. 14). In generation 0 best by own cost.
  [[nodiscard]] const Evaluation& best() const { return best_; }
  /// The best so far by own cost (Eq. 11); without points, as all here.
  [[nodiscard]] const Evaluation& own_best() const { return own_best_; }

  void add_to(StateHash& hash) const;

 private:
  void refresh(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m);
  [[nodiscard]] const ph::Controls& spin(RandomStream& stream) const;

  std::int32_t generation_ = 0;
  std::vector<Evaluation> individuals_;
  LazyCostsIn<Space> costs_;  ///< of the individuals, all found out at once
  PeerTableIn<Space> peers_;  ///< for callers that hold none
  PointTableIn<Space> elite_points_;
  std::vector<ph::Controls> children_;
  std::vector<double> wheel_;  ///< running sums of fitness
  Evaluation best_;
  Evaluation own_best_;
};

using GeneticPopulation = GeneticPopulationIn<Planar>;

}  // namespace skein::rendezvous
