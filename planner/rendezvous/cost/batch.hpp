// Candidates of one UAV evaluated together, and the representatives of its peers, in the kernel's lanes.
//
// Source: papers/001, section 3.2.3 and 3.2.4. Departs from source: see cost/cost.hpp.
// Complexity: that of the kernel; nothing allocates but construction, and PeerTable while it grows or
// walks joined segments.
#pragma once

#include <span>
#include <vector>

#include "planner/rendezvous/cost/cost.hpp"
#include "planner/rendezvous/kernel/lane_table.hpp"

namespace skein::rendezvous {

/// What a path is judged by (Eq. 11-13), as the kernel takes it.
template <typename Space>
class RuleTableIn {
 public:
  explicit RuleTableIn(const ProblemIn<Space>& problem);
  /// Valid as long as this table and the problem, which is the one that the table was made of, or a copy.
  [[nodiscard]] kernel::Rules rules(const ProblemIn<Space>& problem) const;

 private:
  std::vector<double> places_;
  std::vector<kernel::Circle> circles_;
  std::vector<kernel::Rectangle> rectangles_;
  std::vector<kernel::Volume> volumes_;
};

/// Puts the two poses of a UAV into a lane of a table with rows EndRows.
void put_ends(const ph::Hermite& hermite, std::size_t lane, kernel::LaneTable& ends);
void put_ends(const ph::SpatialHermite& hermite, std::size_t lane, kernel::LaneTable& ends);

/// Equidistant points of paths, one path a lane, laid out as the kernel's `walk` does.
template <typename Space>
class PointTableIn {
 public:
  using Vec = typename Space::Vec;

  PointTableIn() = default;
  PointTableIn(std::size_t points, std::size_t lanes) { resize(points, lanes); }

  void resize(std::size_t points, std::size_t lanes);
  [[nodiscard]] std::size_t points() const { return points_; }
  /// From lane `first` on.
  [[nodiscard]] kernel::Table table(std::size_t first = 0) {
    return {rows_.table().data + first, rows_.table().stride};
  }
  [[nodiscard]] kernel::ConstTable view(std::size_t first = 0) const {
    return {rows_.view().data + first, rows_.view().stride};
  }

  void copy_lane(const PointTableIn& from, std::size_t from_lane, std::size_t to_lane) {
    rows_.copy_lane(from.rows_, from_lane, to_lane);
  }
  void pad(std::size_t used) { rows_.pad(used); }
  [[nodiscard]] Vec at(std::size_t lane, std::size_t k) const;
  void set(std::size_t lane, std::size_t k, const Vec& point_m);
  /// One path's points; as many as the table has.
  void copy_to(std::size_t lane, std::span<Vec> points_m) const;
  void copy_from(std::size_t lane, std::span<const Vec> points_m);

 private:
  std::size_t points_ = 0;
  kernel::LaneTable rows_;
};

/// Representatives of peers, one a lane.
template <typename Space>
class PeerTableIn {
 public:
  void assign(View<PeerPathIn<Space>> peers, std::size_t points);
  /// The paths of representatives, those that changed since the last call walked in one call of the kernel, but those
  /// of joined segments one by one.
  /// @pre can_use() of each
  void follow(const ProblemIn<Space>& problem, std::span<const Representative> peers);
  /// Valid until the next assign() or follow().
  [[nodiscard]] kernel::Peers peers() const { return {points_.view(), separation_m_.data(), count_}; }
  /// The same as plain paths. @pre the last call was follow()
  [[nodiscard]] std::vector<PeerPathIn<Space>> paths() const;

 private:
  void resize(std::size_t points, std::size_t peers);
  void walk(const ProblemIn<Space>& problem, std::span<const std::size_t> lanes);
  void walk_joined(const ProblemIn<Space>& problem, std::size_t lane);

  PointTableIn<Space> points_;
  std::vector<double> separation_m_;
  std::size_t count_ = 0;
  std::vector<AgentId> ids_;            ///< of those that are followed
  std::vector<ph::Controls> controls_;  ///< of their paths
  std::vector<std::size_t> changed_;    ///< lanes to be walked; kept, as the tables below, to save allocating them
  kernel::LaneTable ends_;
  kernel::LaneTable m_;
  kernel::LaneTable paths_;
  PointTableIn<Space> walked_;
};

template <typename Space>
class BatchIn {
 public:
  /// For up to `capacity` (at least 1) candidates of problem.own().
  BatchIn(const ProblemIn<Space>& problem, std::size_t capacity);

  /// evaluate() of cost.hpp for each candidate's controls, but without points.
  void evaluate(const ProblemIn<Space>& problem, std::span<EvaluationIn<Space>> candidates);

  /// Equidistant points of some candidates of the last evaluate(): lane first + i of `into` is that of candidate
  /// chosen[i]. @pre chosen is not empty
  void walk(const ProblemIn<Space>& problem, std::span<const std::size_t> chosen, PointTableIn<Space>& into,
            std::size_t first = 0);

 private:
  RuleTableIn<Space> rules_;
  kernel::LaneTable ends_;
  kernel::LaneTable controls_;  ///< rows m0, m1
  kernel::LaneTable paths_;
  kernel::LaneTable chosen_paths_;
  kernel::LaneTable verdicts_;
};

/// The points of equidistant_points() along one path, parts of it in lanes unless it is joined; at least 2 of them.
template <typename Space>
void walk_in_parts(const kernel::Kernel& kernel, const typename Space::Path& path,
                   std::span<typename Space::Vec> points_m);

using RuleTable = RuleTableIn<Planar>;
using PointTable = PointTableIn<Planar>;
using PeerTable = PeerTableIn<Planar>;
using Batch = BatchIn<Planar>;

}  // namespace skein::rendezvous
