// The rendezvous planner of one UAV: what an agent calls once a planning round, over every carrier.
//
// Rounds 0 .. T are generations of the sub-swarm (Searching); then the swarm aligns path lengths (Aligning, Settled).
// Every round maps (own state, the peers' representatives of the round before) to a representative; nothing else
// enters, so all live UAVs reach Ready or Failed in the same round and two carriers give the same bits.
// The reference length of Eq. 16 is the longest among the representatives' own-fitness lengths (own_reference 0: among
// their path lengths); of equal ones that of the lowest id counts. With `cooperate` 0 no peer counts in the search.
//
// With `equalise` 0 nothing is aligned: in round T + 1 everybody has everybody's last representative, judges all of
// them alike at the paper's points, and is Ready with its own, or Failed if anyone's violates a constraint.
// What would end Failed is followed by a stage of more segments instead while the option max_segments allows it
// (stages.hpp): at once if the opening of the alignment shows a UAV without a path of its own.
//
// Source: papers/001, section 3.2.5 (steps 1-6) and Remark 3. Departs from source: see swarm/sub_swarm.hpp and
// align/aligner.hpp. Complexity: a generation costs O(M (evaluation + Np peers)).
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"
#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/align/aligner.hpp"
#include "planner/rendezvous/cost/problem.hpp"
#include "planner/rendezvous/stages.hpp"
#include "planner/rendezvous/swarm/search.hpp"

namespace skein::rendezvous {

enum class PlanStatus : std::uint8_t {
  Planning,  ///< rounds go on
  Ready,     ///< all live UAVs hold feasible paths, and with `equalise` of one length
  Failed,    ///< the rounds and stages are used up without a feasible set
};

struct PlanRound {
  Representative representative;  ///< to be published; run, incarnation and round are left 0 for the runtime
  PlanStatus status = PlanStatus::Planning;
  Constraint failed_constraint = Constraint::None;  ///< with Failed
  AgentId failed_peer = 0;  ///< with Failed: the peer of a separation, or the UAV that names the constraint; 0: self
  std::uint32_t generation = 0;  ///< of the sub-swarm; stays at T while the swarm aligns, begins again in each stage
};

/// The planner in one space: in the plane nothing is paid for the third axis.
template <typename Space>
class PlannerIn {
 public:
  using Problem = ProblemIn<Space>;
  using Participant = ParticipantIn<Space>;
  using Search = SearchIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using Aligner = AlignerIn<Space>;
  using Path = typename Space::Path;

  /// @throws std::invalid_argument if the mission cannot be planned (cost/problem.hpp) or has no vehicle `self`.
  PlannerIn(const Mission& mission, AgentId self, const kernel::Kernel& kernel = kernel::chosen_kernel());

  /// Whether advance() takes this representative: from a peer of the mission, its particle that of 1 to max_segments
  /// segments within that peer's search range, its lengths positive and finite.
  [[nodiscard]] bool can_use(const Representative& peer) const;

  /// One planning round. `peers`: the representatives that all live peers published in the round before, by ascending
  /// id; none in the first round (it reads none). A peer may be absent from any round on: it no longer counts.
  /// After Ready or Failed every call returns the same.
  /// @throws std::invalid_argument if a representative is out of order or cannot be used (can_use).
  PlanRound advance(std::span<const Representative> peers);

  /// The final path. @pre the last round was Ready. @throws std::logic_error otherwise
  [[nodiscard]] const Path& path() const;

  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const Search& swarm() const { return swarm_; }

  /// Everything that decides later behaviour.
  void add_to(StateHash& hash) const;

 private:
  void check(std::span<const Representative> peers) const;
  void search(std::span<const Representative> peers);
  void align(std::span<const Representative> peers);
  void conclude(std::span<const Representative> peers);
  void judge(std::span<const Representative> peers);
  void next_stage(std::span<const Representative> peers);
  [[nodiscard]] std::size_t max_segments() const { return static_cast<std::size_t>(problem_.options.max_segments); }
  [[nodiscard]] bool may_add_segments() const { return stage_ < max_segments(); }
  [[nodiscard]] std::optional<double> reference_length_m(std::span<const Representative> peers) const;
  void report_search();
  void report_alignment();

  Problem problem_;  ///< its seed is that of the stage
  std::uint64_t run_seed_;
  std::uint32_t stage_ = 1;
  std::size_t segments_ = 1;  ///< of the own path
  Standstill standstill_;
  Search swarm_;
  bool started_ = false;
  PeerTableIn<Space> peers_;  ///< of the round before, kept to save walking unchanged paths again
  std::optional<Aligner> aligner_;
  PlanRound round_;
  Path path_;
};

/// The planner in the space that the mission asks for (is_planar); otherwise as PlannerIn.
class Planner {
 public:
  using InSpace = std::variant<PlannerIn<Planar>, PlannerIn<Spatial>>;

  Planner(const Mission& mission, AgentId self, const kernel::Kernel& kernel = kernel::chosen_kernel());

  [[nodiscard]] bool can_use(const Representative& peer) const;
  PlanRound advance(std::span<const Representative> peers);
  void add_to(StateHash& hash) const;
  /// Length (m) of the final path. @pre the last round was Ready. @throws std::logic_error otherwise
  [[nodiscard]] double path_length_m() const;

  [[nodiscard]] const InSpace& in_space() const { return in_space_; }
  /// @throws std::bad_variant_access if the mission is not planar
  [[nodiscard]] const PlannerIn<Planar>& planar() const { return std::get<PlannerIn<Planar>>(in_space_); }
  /// @throws std::bad_variant_access if the mission is planar
  [[nodiscard]] const PlannerIn<Spatial>& spatial() const { return std::get<PlannerIn<Spatial>>(in_space_); }

 private:
  InSpace in_space_;
};

}  // namespace skein::rendezvous
