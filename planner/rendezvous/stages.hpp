// Stages of planning: when the paths of a swarm stay infeasible, those concerned take one more segment.
//
// Stage 1 is planning with a single segment each. A stage that finds no feasible set, which is known at the latest when
// the rounds of the alignment are used up, at the opening of it if some UAV has no path of its own, and when nothing
// changes any more, is followed by the next one, up to
// option max_segments: search and alignment begin again, and each UAV whose published path violated a constraint of its
// own has one more segment; if nobody's did, all have. Whether a stage ends, and for whom it adds a segment, follows
// from samples of one round that all live UAVs see alike, so all change stage in the same round, whoever is lost.
//
// Source: papers/001, Remark 4. Departs from source: the paper does not say when paths get more segments.
// Complexity: O(peers).
#pragma once

#include <cstdint>
#include <span>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/lockstep/samples.hpp"

namespace skein::rendezvous {

/// Whether any of one's own and the peers' samples of a round names trouble of its own.
[[nodiscard]] bool anyone_in_trouble(const Representative& own, std::span<const Representative> peers);

/// Whether the UAV that published `own` takes one more segment in the next stage.
[[nodiscard]] bool takes_segment(const Representative& own, std::span<const Representative> peers);

/// Notices that an alignment goes nowhere: what all publish has not changed for longer than a UAV waits for an answer.
class Standstill {
 public:
  /// To be called once a round with the samples of the round before; whether they stand still.
  [[nodiscard]] bool lasts(const Representative& own, std::span<const Representative> peers);

  void add_to(StateHash& hash) const;

 private:
  std::uint64_t seen_ = 0;  ///< hash of the samples of the round before
  std::int32_t quiet_ = 0;  ///< rounds since they changed
};

/// The seed of a stage's random streams: the run's in stage 1, no stage's twice.
[[nodiscard]] std::uint64_t seed_of_stage(std::uint64_t run_seed, std::uint32_t stage);

}  // namespace skein::rendezvous
