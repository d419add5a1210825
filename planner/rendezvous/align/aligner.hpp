// Agreement of the swarm on one common path length, in rounds, each UAV deciding for itself from what all published.
//
//   round 1   publish the length of the best own path, proved (align/alone) if it may be the longest of the swarm or
//             is refuted at once
//   round r   target = the longest length published in round r - 1, one's own included
//             - not at the target: choose the cheapest path of that length (align/choice) that is proved feasible and
//               clear of all UAVs at the target, else clear of those that have the right of way
//             - at the target, in conflict with one that has the right of way: choose again
//             - nothing found: keep a path and publish `Separation`, which asks the others to give way; still nothing
//               two rounds later, or no path of that length at all: take the smallest longer length that has a path,
//               which raises the target for all
//             - else keep the path; Settled if everybody is at the target, feasible and clear of everybody
//   the end   all were Settled in round r - 1: Agreed in round r. More than `equalise_rounds` rounds: Failed.
// The right of way have lower ids, and, before UAVs that do not ask themselves, those that ask. Both ends are decided
// by samples that all live UAVs see alike, so all reach them in the same round, whoever is lost on the way; and a UAV
// that published Settled has not moved since it was found clear.
//
// Source: papers/001, Remark 3 and Eq. 17. Departs from source: exact lengths, right of way, proof between samples.
// Complexity: a round costs one choice, at worst one for each raised length, or nothing.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"
#include "planner/rendezvous/align/choice.hpp"

namespace skein::rendezvous {

enum class AlignOutcome : std::uint8_t {
  Aligning = 0,  ///< rounds go on
  Agreed = 1,    ///< all live UAVs have settled at one length
  Failed = 2,    ///< the rounds are used up
};

template <typename Space>
class AlignerIn {
 public:
  using Outcome = AlignOutcome;
  using Problem = ProblemIn<Space>;
  using DensePath = DensePathIn<Space>;
  using Neighbour = NeighbourIn<Space>;
  using Chosen = ChosenIn<Space>;
  using Choice = ChoiceIn<Space>;

  /// `own_best` and `group_best`: the sub-swarm's best by own and by modified cost.
  AlignerIn(const ph::Controls& own_best, const ph::Controls& group_best);

  /// One round. `peers`: checked representatives of the round before, by ascending id.
  Outcome advance(const Problem& problem, std::span<const Representative> peers);

  /// Rounds so far. After the first, what all published names those that have no path of their own.
  [[nodiscard]] std::int32_t round() const { return round_; }
  [[nodiscard]] bool settled() const { return settled_; }
  [[nodiscard]] const ph::Controls& controls() const { return controls_; }
  [[nodiscard]] double length_m() const { return length_m_; }
  /// What keeps this UAV from settling, and the peer of a failed separation (else 0). After Failed: what the swarm
  /// failed by; if that is another UAV's trouble, its constraint and its id; Length if nobody named any.
  [[nodiscard]] Constraint violated() const { return violated_; }
  [[nodiscard]] AgentId violated_peer() const { return violated_peer_; }

  void add_to(StateHash& hash) const;

 private:
  void open(const Problem& problem, std::span<const Representative> peers);
  void prove(const Problem& problem);
  void blame(std::span<const Representative> peers);
  void look_at(const Problem& problem, std::span<const Representative> peers, double target_m);
  void align(const Problem& problem, std::span<const Representative> peers);
  void find_way(const Problem& problem, double target_m);
  [[nodiscard]] bool may_stay(const Problem& problem, double target_m) const;
  [[nodiscard]] bool raise(const Problem& problem, double target_m);
  void take(const Chosen& chosen, Constraint violated, AgentId peer);
  [[nodiscard]] std::uint64_t task_of(double target_m) const;

  ph::Controls own_best_;
  ph::Controls group_best_;
  ph::Controls controls_;
  double length_m_ = 0.0;
  bool feasible_alone_ = true;
  bool settled_ = false;
  Constraint violated_ = Constraint::None;
  AgentId violated_peer_ = 0;
  std::int32_t round_ = 0;
  std::int32_t asked_ = 0;         ///< rounds since it asks for the way
  std::int32_t raised_ = 0;        ///< how often it raised the target
  std::uint64_t failed_task_ = 0;  ///< the last choice that found nothing
  Outcome outcome_ = Outcome::Aligning;
  DensePath dense_;                    ///< of controls_
  std::vector<Neighbour> neighbours_;  ///< the peers of the round before; kept to save sampling them again
};

using Aligner = AlignerIn<Planar>;

}  // namespace skein::rendezvous
