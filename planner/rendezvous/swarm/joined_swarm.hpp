// The sub-swarm of one UAV whose path has several joined segments: particles of more coordinates, moved as in DCPSO.
//
// Equations 8 to 10 of sub_swarm.hpp act on every coordinate of a particle, each with its own range (cost/coordinates),
// and costs are those of the cooperative group, refreshed every generation. A path of n segments has n M particles. The
// first starts at the path that the UAV had before, with n segments; of the others interior lengths start below twice
// the chord and angles within 2 rad of it, where most paths without loops are. While no particle has kept all own
// constraints, half of the particles are drawn anew in each generation, since the penalties of Eq. 11 are equal
// everywhere and give no direction.
//
// Source: papers/001, sections 3.1, 3.2 and Remark 4. Departs from source: as sub_swarm.hpp, and the start and the
// share that is drawn anew. Complexity: O(n M (evaluation + Np peers)) a generation.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/random/random_stream.hpp"
#include "planner/rendezvous/cost/cost.hpp"

namespace skein::rendezvous {

template <typename Space>
class JoinedSwarmIn {
 public:
  using Problem = ProblemIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using PeerPath = PeerPathIn<Space>;

  /// Generation 0, of paths of so many segments (at least 2), judged by their own cost; `before`: the path that the UAV
  /// had, of any number of segments.
  JoinedSwarmIn(const Problem& problem, std::size_t segments, const ph::Controls& before);

  /// The next generation; parameters as of SubSwarm::advance.
  void advance(const Problem& problem, std::span<const PeerPath> peers, std::optional<double> reference_length_m);

  [[nodiscard]] std::int32_t generation() const { return generation_; }
  /// The representative: best by modified cost (Eq. 14). In generation 0 best by own cost.
  [[nodiscard]] const Evaluation& best() const { return best_; }
  /// The best so far by own cost (Eq. 11).
  [[nodiscard]] const Evaluation& own_best() const { return own_best_; }

  void add_to(StateHash& hash) const;

 private:
  void start(const Problem& problem, std::size_t particle, RandomStream& stream);
  void move(const Problem& problem, std::size_t particle, double inertia, double drawn_anew);
  void update_bests();

  std::int32_t generation_ = 0;
  std::size_t coordinates_;
  std::vector<Evaluation> particles_;
  std::vector<ph::Controls> velocities_;
  std::vector<Evaluation> personal_bests_;
  Evaluation best_;
  Evaluation own_best_;
};

}  // namespace skein::rendezvous
