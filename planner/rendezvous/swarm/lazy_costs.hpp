// Modified costs of a sub-swarm's particles (Eq. 14), each found out only when it decides something.
//
// Equidistant points, and with them J_collision, are what a particle costs most to find out. Everything else is known
// at once, so the modified cost lies between two bounds: without and with the penalty of a collision. Rounded sums are
// monotone, so the bounds hold for computed values too. A particle whose lower bound is not below its personal best
// cannot replace it; the best of a sub-swarm is found by finding out those of least lower bound until the least value
// of all is a known one, the worst likewise from above. Every decision is the one that full knowledge gives.
//
// Source: papers/001, Eq. 14-17. Departs from source: evaluation on demand. Complexity: O(M) bounds; O(Np peers) and
// Np Newton steps for each particle that is found out, a pack of them at a time.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/rendezvous/cost/batch.hpp"

namespace skein::rendezvous {

enum class Evaluate : std::uint8_t {
  OnDemand,  ///< for use
  Always,    ///< every particle, every generation: the plain formulation, whose decisions OnDemand takes
};

/// The scalar kernel stands for the plain formulation throughout: one candidate at a time, each evaluated in full.
[[nodiscard]] constexpr Evaluate default_of(const kernel::Kernel& kernel) {
  return kernel.width == 1 ? Evaluate::Always : Evaluate::OnDemand;
}

template <typename Space>
class LazyCostsIn {
 public:
  using Problem = ProblemIn<Space>;
  using Evaluation = EvaluationIn<Space>;
  using PointTable = PointTableIn<Space>;

  LazyCostsIn(const Problem& problem, std::size_t particles, Evaluate when);

  /// The particles of a new generation: own costs of all.
  void evaluate(const Problem& problem, std::span<Evaluation> particles);
  /// What costs are modified by from now on (peers stay the caller's); no modified cost is known then, and `modified`
  /// is its lower bound.
  void face(const Problem& problem, const kernel::Peers& peers, std::optional<double> reference_length_m,
            std::span<Evaluation> particles);
  /// The same peers and reference for the next generation alone: what is known of this one stays.
  void expect(const kernel::Peers& peers, std::optional<double> reference_length_m);
  /// Modified costs by the same peers and reference of lanes 0 .. n - 1 of other points.
  void modify(const Problem& problem, const PointTable& points, std::span<Evaluation* const> evaluations);

  /// Lower bounds of the modified costs of all particles, with what face() was given.
  void bound(const Problem& problem, std::span<Evaluation> particles);
  /// Finds out those of the particles that are unknown.
  void find_out(const Problem& problem, std::span<Evaluation> particles, std::span<const std::size_t> chosen);
  /// The same, and in the same packs those that least() and largest() are likely to ask for next.
  void find_out_ahead(const Problem& problem, std::span<Evaluation> particles, std::vector<std::size_t>& chosen);
  /// The first particle of least and of largest modified cost; it is known then.
  [[nodiscard]] std::size_t least(const Problem& problem, std::span<Evaluation> particles);
  [[nodiscard]] std::size_t largest(const Problem& problem, std::span<Evaluation> particles);

  [[nodiscard]] bool is_known(std::size_t particle) const { return known_[particle] != 0; }
  /// The points of particles that were known since they were evaluated, each in its lane.
  [[nodiscard]] const PointTable& points() const { return points_; }
  [[nodiscard]] std::size_t lane_of(std::size_t particle) const { return lane_of_[particle]; }
  /// Puts a known candidate into a particle's place: lane `lane` of `points`.
  void replace(std::size_t particle, const PointTable& points, std::size_t lane);
  /// Makes the points of all particles known.
  void walk_all(const Problem& problem);

 private:
  std::size_t walk(const Problem& problem, std::span<const std::size_t> chosen);
  void list_open(std::size_t most);
  template <typename Key>
  std::size_t extreme(const Problem& problem, std::span<Evaluation> particles, const Key& key);

  Evaluate when_;
  BatchIn<Space> batch_;
  kernel::Peers peers_{};  ///< since face(), until the end of the generation
  std::optional<double> reference_length_m_;
  /// Walked paths, in the order of the calls: those of one call stand side by side, where `meet` can take them.
  PointTable points_;
  std::vector<std::size_t> lane_of_;
  std::size_t lanes_used_ = 0;
  PointTable gathered_;
  kernel::LaneTable collided_;
  std::vector<char> walked_;
  std::vector<char> known_;
  std::vector<std::size_t> all_;
  std::vector<std::size_t> to_walk_;
  std::vector<std::size_t> open_;
  std::vector<double> keys_;
};

using LazyCosts = LazyCostsIn<Planar>;

}  // namespace skein::rendezvous
