// What a transit planner is asked: where could this UAV fly next, on the map as known?
//
// A plan is a list of straight motions from one place, best first, each clear on the map; right of way then takes the
// first that suits the others. Three planners answer: peach, peach3d-paper, peach3d.
// Source: papers/004, section III. Departs from source: execution is gated by right of way. Complexity: see each.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "planner/core/mission/mission.hpp"
#include "planner/gridnav/map/known_map.hpp"
#include "planner/gridnav/traffic/negotiate.hpp"

namespace skein::gridnav {

/// What does not change for one UAV in one mission.
struct Task {
  CellGrid grid;
  Vec3 goal_m = Vec3::Zero();
  double goal_radius_m = 0.0;
  double radius_m = 0.0;  ///< of the body
  double step_m = 0.0;    ///< way in one decision, at most
  double sensor_range_m = 0.0;
  TransitOptions options;
};

struct Situation {
  const KnownMap& map;
  Vec3 start_m;  ///< where the motion starts
  Need need;     ///< of the cells that a motion sweeps
  std::span<const Other> others;
};

struct Plan {
  std::vector<Option> options;       ///< best first; empty: stay
  double to_go_m = 0.0;              ///< negative: there is no way
  std::vector<CellIndex> revisited;  ///< cells that led nowhere
};

class Steering {
 public:
  virtual ~Steering() = default;
  Steering() = default;
  Steering(const Steering&) = delete;
  Steering& operator=(const Steering&) = delete;

  /// The map now holds these changes. @return whether any cell became blocked or open
  virtual bool learn(const KnownMap& map, std::span<const CellChange> changed) = 0;
  [[nodiscard]] virtual Plan plan(const Situation& at) = 0;
  /// Motions to cells around that are nearer to the goal, best first: for when the plan is obstructed.
  [[nodiscard]] virtual std::vector<Option> detours(const Situation&) { return {}; }
  /// The ends of the motions after one that ends at `end_m`, as far as an intent holds.
  [[nodiscard]] virtual std::array<CellIndex, 4> way_from(const KnownMap& map, const Vec3& end_m) = 0;
  /// Whether this planner asks others to move aside, backs off, and says that it cannot arrive.
  [[nodiscard]] virtual bool complete() const { return false; }
};

/// The planner that task.options.name names. @pre the name is one of kTransitPlanners
[[nodiscard]] std::unique_ptr<Steering> make_steering(const Task& task, const Cell& start);

}  // namespace skein::gridnav
