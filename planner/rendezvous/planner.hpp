// The rendezvous planner of one UAV: what an agent calls once a planning round, over every carrier.
//
// Rounds 0 .. T are generations of the sub-swarm (Searching); then the swarm aligns path lengths (Aligning, Settled).
// Every round maps (own state, the peers' representatives of the round before) to a representative; nothing else
// enters, so all live UAVs reach Ready or Failed in the same round and two carriers give the same bits.
// The reference length of Eq. 16 is the longest among the representatives' own-fitness lengths; of equal ones that of
// the lowest id counts.
//
// Source: papers/001, section 3.2.5 (steps 1-6) and Remark 3. Departs from source: see swarm/sub_swarm.hpp and
// align/aligner.hpp. Complexity: a generation costs O(M (evaluation + Np peers)).
#pragma once

#include <optional>
#include <span>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"
#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/align/aligner.hpp"
#include "planner/rendezvous/cost/problem.hpp"
#include "planner/rendezvous/ph/planar_path.hpp"
#include "planner/rendezvous/swarm/sub_swarm.hpp"

namespace skein::rendezvous {

enum class PlanStatus : std::uint8_t {
  Planning,  ///< rounds go on
  Ready,     ///< all live UAVs hold feasible paths of one length
  Failed,    ///< the rounds are used up without a feasible set
};

struct PlanRound {
  Representative representative;  ///< to be published; run, incarnation and round are left 0 for the runtime
  PlanStatus status = PlanStatus::Planning;
  Constraint failed_constraint = Constraint::None;  ///< with Failed
  AgentId failed_peer = 0;  ///< with Failed: the peer of a separation, or the UAV that names the constraint; 0: self
  std::uint32_t generation = 0;  ///< of the sub-swarm; stays at T while the swarm aligns
};

class Planner {
 public:
  /// @throws std::invalid_argument if the mission cannot be planned (cost/problem.hpp) or has no vehicle `self`.
  Planner(const Mission& mission, AgentId self, const kernel::Kernel& kernel = kernel::chosen_kernel());

  /// Whether advance() takes this representative: from a peer of the mission, its particle two numbers within that
  /// peer's search range, its lengths positive and finite.
  [[nodiscard]] bool can_use(const Representative& peer) const;

  /// One planning round. `peers`: the representatives that all live peers published in the round before, by ascending
  /// id; none in the first round (it reads none). A peer may be absent from any round on: it no longer counts.
  /// After Ready or Failed every call returns the same.
  /// @throws std::invalid_argument if a representative is out of order or cannot be used (can_use).
  PlanRound advance(std::span<const Representative> peers);

  /// The final path. @pre the last round was Ready. @throws std::logic_error otherwise
  [[nodiscard]] const ph::PlanarPath& path() const;

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const SubSwarm& swarm() const { return swarm_; }

  /// Everything that decides later behaviour.
  void add_to(StateHash& hash) const;

 private:
  void check(std::span<const Representative> peers) const;
  void search(std::span<const Representative> peers);
  void align(std::span<const Representative> peers);
  [[nodiscard]] std::optional<double> reference_length_m(std::span<const Representative> peers) const;
  void report_search();
  void report_alignment();

  Problem problem_;
  SubSwarm swarm_;
  bool started_ = false;
  PeerTable peers_;  ///< of the round before, kept to save walking unchanged paths again
  std::optional<Aligner> aligner_;
  PlanRound round_;
  ph::PlanarPath path_;
};

}  // namespace skein::rendezvous
