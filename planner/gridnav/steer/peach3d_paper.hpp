// 3DGPeach as printed: a list of waypoints to the goal, found by walking Peach through the map as known.
//
//   mode 1  nothing is known to be in line with the goal: straight on, at most to the end of the sensor's range
//   mode 2  else: Peach is run cell by cell to the goal (Algorithm 3); a waypoint goes if its neighbours see each other
//   mode 3  a dead end: all cells around are shut or visited; back over the visited cells, most recent first, to one
//           that has a cell around not visited, and the potential of those left behind is raised by alpha
// The list is kept until something is known on it, a neighbour stands beside its first leg, or the mode changes.
// Source: papers/004, Algorithms 2 and 3, section III-D2. Departs from source: readings, since details are left to its
// reference [10]: mode 1 looks along the whole line (option known_line; 0: as far as the sensor reaches); the walk
// of Algorithm 3 ends after kMostSteps cells; when a dead end is left; and those of potential_table.hpp. It may never
// arrive. Complexity: O(steps of the walk) when the list is made anew.
#pragma once

#include <deque>

#include "planner/gridnav/steer/potential_table.hpp"

namespace skein::gridnav {

inline constexpr int kMostSteps = 20000;

class Peach3dPaper final : public Steering {
 public:
  explicit Peach3dPaper(const Task& task);

  bool learn(const KnownMap&, std::span<const CellChange> changed) override { return table_.learn(changed); }
  [[nodiscard]] Plan plan(const Situation& at) override;
  [[nodiscard]] std::array<CellIndex, 4> way_from(const KnownMap& map, const Vec3& end_m) override;

 private:
  enum class Mode : std::uint8_t { Free = 1, Obstacle = 2, DeadEnd = 3 };

  [[nodiscard]] bool clear(const KnownMap& map, const Vec3& a, const Vec3& b) const;
  [[nodiscard]] bool goal_in_line(const Situation& at) const;
  [[nodiscard]] bool leg_obstructed(const Situation& at) const;
  void visit(const Cell& c);
  [[nodiscard]] bool dead_end(const Cell& own);
  void retrace(std::vector<CellIndex>& revisited);
  void walk(const Situation& at);
  void offer_near(const Situation& at, Plan& plan);
  [[nodiscard]] CellIndex least_around(CellIndex from);

  Task task_;
  Cell goal_;
  PotentialTable table_;
  Mode mode_ = Mode::Free;
  std::deque<Vec3> waypoints_m_;
  std::vector<CellIndex> trail_;  ///< cells visited, without what was retraced
  std::vector<std::uint8_t> visited_;
  std::vector<Cell> around_;
};

}  // namespace skein::gridnav
