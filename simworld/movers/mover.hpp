// Things in the air that no agent is told of: they move, cross, or are suddenly there.
//
// A body is a sphere, or a column (upright, without ends). It moves in one of four ways:
//   still  it stays where it is
//   line   p(t) = p0 + v t
//   loop   from waypoint to waypoint at one speed, the first one being its place, and from the last to the first again
//   walk   at one speed, in a direction that it draws anew with probability step_s / turn_s a step; at the walls of a
//   box
//          it is reflected. A column, or a body in a flat box, walks level
// It is there from the start, from a time on, once a UAV comes near, or on the course of a UAV (simworld/movers/
// appearance.hpp for how near it may appear). Source: papers/000, section 2.3 (dynamic and unpredicted obstacles).
// Departs from source: none; the paper gives no motions.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planner/core/mission/mission.hpp"

namespace skein {

struct StillMotion {
  bool operator==(const StillMotion&) const = default;
};

struct LineMotion {
  Vec3 velocity_mps = Vec3::Zero();

  bool operator==(const LineMotion&) const = default;
};

struct LoopMotion {
  std::vector<Vec3> waypoints_m;  ///< at least two
  double speed_mps = 0.0;

  bool operator==(const LoopMotion&) const = default;
};

struct WalkMotion {
  double speed_mps = 0.0;
  double turn_s = 0.0;  ///< mean time between two turns
  Box within;           ///< in which the centre stays

  bool operator==(const WalkMotion&) const = default;
};

using MoverMotion = std::variant<StillMotion, LineMotion, LoopMotion, WalkMotion>;

/// It appears on the line along which a UAV moves.
struct AheadOf {
  AgentId agent = 0;        ///< 0: one that is drawn by the seed
  double distance_m = 0.0;  ///< in front of the UAV, centre to centre
  bool crosses = false;     ///< it comes from the side, level, so that it would meet the UAV there

  bool operator==(const AheadOf&) const = default;
};

struct Mover {
  std::string name;  ///< its place in the scenario, for messages
  Vec3 position_m = Vec3::Zero();
  double radius_m = 0.0;
  bool column = false;
  MoverMotion motion;
  bool sudden = false;  ///< it waits until it may appear (appearance.hpp); else it is there in any case
  double at_s = 0.0;    ///< not before
  double until_s = std::numeric_limits<double>::infinity();  ///< and gone after
  double near_m = 0.0;                                       ///< positive: once a UAV is that near to its place
  std::optional<AheadOf> ahead;                              ///< its place is on a UAV's course instead

  bool operator==(const Mover&) const = default;
};

/// The speed (m/s) that it never exceeds.
[[nodiscard]] double speed_of(const Mover& mover);

}  // namespace skein
