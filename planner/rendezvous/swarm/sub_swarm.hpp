// The sub-swarm of one UAV: particles (m0, m1) that move by PSO and are judged in their cooperative group (DCPSO).
//
//   v <- omega(t) v + c1 r1 (pbest - x) + c2 r2 (gbest - x),  x <- x + v,  both clamped              (Eq. 8, 9)
//   omega(t) = omega_start - (omega_start - omega_end) (t / T)^2                                      (Eq. 10)
// A generation: refresh the stored costs with the representatives of the generation before, move, evaluate, let the
// best particle of the generation before take the place of the worst, update personal and group bests.
//
// Source: papers/001, sections 3.1 and 3.2. Departs from source (docs/families/rendezvous.md says why): costs stored
// with personal and group bests are refreshed every generation, since the penalties of Eq. 15 and 16 depend on the
// others (option refresh_costs 0 leaves them as they were stored); each particle is re-initialised with a small
// probability; the best by own cost (Eq. 11) is kept apart, for the reference length. Modified costs are found out on
// demand (swarm/lazy_costs), all in lanes.
// Complexity: O(M (evaluation + Np peers)) a generation; nothing allocates after the first with as many peers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/swarm/lazy_costs.hpp"

namespace skein::rendezvous {

template <typename Space>
class SubSwarmIn {
 public:
  using Problem = ProblemIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using PeerPath = PeerPathIn<Space>;
  using PointTable = PointTableIn<Space>;

  /// Generation 0: random particles, judged by their own cost.
  explicit SubSwarmIn(const Problem& problem) : SubSwarmIn(problem, default_of(*problem.kernel)) {}
  /// Without option refresh_costs everything is found out at once: later its peers would be gone.
  SubSwarmIn(const Problem& problem, Evaluate when);

  /// The next generation. `peers`: the representatives of the generation before. `reference_length_m`: the length that
  /// Eq. 16 pulls to, or nothing while this UAV is the reference itself.
  void advance(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m);
  void advance(const Problem& problem, View<PeerPath> peers, std::optional<double> reference_length_m);

  [[nodiscard]] std::int32_t generation() const { return generation_; }
  /// The representative: best by modified cost (Eq. 14). In generation 0 best by own cost.
  [[nodiscard]] const Evaluation& best() const { return best_; }
  /// The best so far by own cost (Eq. 11); without points.
  [[nodiscard]] const Evaluation& own_best() const { return own_best_; }

  void add_to(StateHash& hash) const;

 private:
  void start(const Problem& problem, std::size_t particle, RandomStream& stream);
  void refresh(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m);
  void move(const Problem& problem, std::size_t particle, double inertia);
  void keep_elite(const Problem& problem);
  void find_out_contenders(const Problem& problem);
  void update_bests();
  void take_best(const Evaluation& from, const PointTable& points, std::size_t lane);

  std::int32_t generation_ = 0;
  bool refreshes_;                     ///< option refresh_costs
  std::vector<Evaluation> particles_;  ///< modified costs are bounds, or known, as costs_ says
  std::vector<ph::Controls> velocities_;
  std::vector<Evaluation> personal_bests_;
  Evaluation best_;
  Evaluation own_best_;
  Evaluation elite_;  ///< best particle of the generation before
  LazyCostsIn<Space> costs_;
  PeerTableIn<Space> peers_;             ///< for callers that hold none
  PointTable best_points_;               ///< of the personal bests, then of best_ and of elite_
  std::vector<Evaluation*> stored_;      ///< personal bests and best_, while they are refreshed
  std::vector<std::size_t> contenders_;  ///< particles that may replace a best
};

using SubSwarm = SubSwarmIn<Planar>;

}  // namespace skein::rendezvous
