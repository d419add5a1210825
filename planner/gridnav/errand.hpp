// What a UAV does by command instead of flying to its goal: it stays, or flies to a point and stays there.
//
// It flies to the place nearest to the point that it can reach: of the cells that open moves join to its own on the map
// as known (unknown counts as open), without those in which others are held, the one whose centre is nearest to the
// point; there to the point itself if it lies in that cell and a body fits, else to the centre. The place is chosen
// anew when no way leads there any more and, unless it is in the point's own cell, when the map or who is held changes.
// The way is that of peach3d whatever the mission flies by, and right of way is as for any other.
// Source: own. Departs from source: none. Complexity: O(cells) for a choice; else of the planner.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "planner/gridnav/steer/guide.hpp"

namespace skein::gridnav {

enum class ErrandState : std::uint8_t {
  UnderWay = 0,
  Stays = 1,   ///< where it was told to
  Short = 2,   ///< at the place nearest to the point that it can reach, not in the point's cell
  GaveUp = 3,  ///< on its way: it found no way past the others
};

class Errand {
 public:
  /// To stay.
  Errand() = default;
  /// To fly to a point (m) in the grid. @param task its mission's, with step_m as it is to fly
  Errand(const Task& task, const Vec3& point_m);

  [[nodiscard]] ErrandState state() const { return state_; }
  [[nodiscard]] bool stays() const { return state_ != ErrandState::UnderWay; }
  /// How far it goes in a decision (m).
  [[nodiscard]] double step_m() const { return task_.step_m; }

  /// As Steering::learn.
  bool learn(const KnownMap& map, std::span<const CellChange> changed);
  /// At the start of a decision, at a position (m): if that is its place, it stays.
  void look_around(const KnownMap& map, const Vec3& position_m);
  void give_up() { state_ = ErrandState::GaveUp; }
  /// As Guide::plan. @pre it is under way
  [[nodiscard]] Guide::Around plan(const Situation& at, std::span<const CellIndex> held);
  /// @pre plan was called
  [[nodiscard]] Steering& steering() const { return guide_->steering(); }

  void add_to(StateHash& hash) const;

 private:
  void choose(const Situation& at, std::span<const CellIndex> held);
  [[nodiscard]] bool at_point() const { return task_.grid.cell_of(task_.goal_m) == task_.grid.cell_of(point_m_); }

  ErrandState state_ = ErrandState::Stays;
  Task task_;  ///< its goal is where it flies to
  Vec3 point_m_ = Vec3::Zero();
  std::optional<Guide> guide_;
  std::vector<CellIndex> held_;  ///< as planned with last
  bool stale_ = true;            ///< what is open changed since
};

}  // namespace skein::gridnav
