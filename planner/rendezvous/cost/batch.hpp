// Candidates of one UAV evaluated together, and the representatives of its peers, in the kernel's lanes.
//
// Source: papers/001, section 3.2.3 and 3.2.4. Departs from source: see cost/cost.hpp.
// Complexity: that of the kernel; nothing allocates but construction, and PeerTable while it grows.
#pragma once

#include <span>
#include <vector>

#include "planner/rendezvous/cost/cost.hpp"
#include "planner/rendezvous/kernel/lane_table.hpp"

namespace skein::rendezvous {

/// What a path is judged by (Eq. 11, 12), as the kernel takes it.
class RuleTable {
 public:
  explicit RuleTable(const Problem& problem);
  /// Valid as long as this table.
  [[nodiscard]] kernel::Rules rules() const;

 private:
  double max_curvature_per_m_;
  double keep_out_m_;
  std::vector<double> places_;
  std::vector<kernel::Circle> circles_;
  std::vector<kernel::Rectangle> rectangles_;
};

/// Puts the two poses of a UAV into a lane of a table with rows kernel::Ends.
void put_ends(const ph::Hermite& hermite, std::size_t lane, kernel::LaneTable& ends);

/// Equidistant points of paths, one path a lane: row k is point number k (m).
struct PointTable {
  kernel::LaneTable x_m;
  kernel::LaneTable y_m;

  PointTable() = default;
  PointTable(std::size_t points, std::size_t lanes) : x_m(points, lanes), y_m(points, lanes) {}
  void copy_lane(const PointTable& from, std::size_t from_lane, std::size_t to_lane);
  /// One path's points; as many as the table has.
  void copy_to(std::size_t lane, std::span<Vec2> points_m) const;
  void copy_from(std::size_t lane, std::span<const Vec2> points_m);
  void pad(std::size_t used);
};

/// Representatives of peers, one a lane.
class PeerTable {
 public:
  void assign(std::span<const PeerPath> peers, std::size_t points);
  /// The paths of representatives, those that changed since the last call walked in one call of the kernel.
  /// @pre can_use() of each
  void follow(const Problem& problem, std::span<const Representative> peers);
  /// Valid until the next assign() or follow().
  [[nodiscard]] kernel::Peers peers() const;

 private:
  void resize(std::size_t points, std::size_t peers);
  void walk(const Problem& problem, std::span<const std::size_t> lanes);

  PointTable points_;
  std::vector<double> separation_m_;
  std::size_t count_ = 0;
  std::vector<AgentId> ids_;            ///< of those that are followed
  std::vector<ph::Controls> controls_;  ///< of their paths
};

class Batch {
 public:
  /// For up to `capacity` (at least 1) candidates of problem.own().
  Batch(const Problem& problem, std::size_t capacity);

  /// evaluate() of cost.hpp for each candidate's controls, but without points.
  void evaluate(const Problem& problem, std::span<Evaluation> candidates);

  /// Equidistant points of some candidates of the last evaluate(): lane i of `into` is that of candidate chosen[i].
  /// @pre chosen is not empty
  void walk(const Problem& problem, std::span<const std::size_t> chosen, PointTable& into);

 private:
  RuleTable rules_;
  kernel::LaneTable ends_;
  kernel::LaneTable controls_;  ///< rows m0, m1
  kernel::LaneTable paths_;
  kernel::LaneTable chosen_paths_;
  kernel::LaneTable verdicts_;
};

/// The points of equidistant_points() along one path, parts of it in lanes; at least 2 of them.
void walk_in_parts(const kernel::Kernel& kernel, const ph::PlanarPath& path, std::span<Vec2> points_m);

}  // namespace skein::rendezvous
