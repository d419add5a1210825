#include "planner/gridnav/traffic/right_of_way.hpp"

#include <algorithm>

#include "planner/core/geometry/closest_approach.hpp"
#include "planner/core/geometry/distance.hpp"

namespace skein::gridnav {
namespace {

constexpr double kNever_m = 1e300;  ///< to go, if there is no way

int group_of(NavStatus status) {
  switch (status) {
    case NavStatus::Deadlock:
      return 1;
    case NavStatus::Unreachable:
      return 2;
    case NavStatus::Held:
      return 3;
    default:
      return 0;
  }
}

}  // namespace

Key key_of(AgentId id, const Intent& intent) {
  const double to_go_m = intent.to_go_m < 0 ? kNever_m : intent.to_go_m;
  return {group_of(intent.status), intent.waited, to_go_m, intent.on_behalf_of, intent.on_behalf_of != id, id};
}

bool may_fly(const Body& own, const Intent& intent, std::span<const Neighbour> neighbours,
             std::span<const double> reaches_m) {
  const Key key = key_of(own.id, intent);
  for (std::size_t n = 0; n < neighbours.size(); ++n) {
    const Neighbour& other = neighbours[n];
    const double apart_m = own.radius_m + other.radius_m + kMargin_m;
    const double stands_m = point_to_segment(other.position_m, intent.from_m, intent.to_m);
    if (stands_m < apart_m) return false;  // (a)
    if (!other.intent) {
      if (stands_m < apart_m + reaches_m[n]) return false;  // (c)
    } else if (key_of(other.id, *other.intent) < key) {
      const Intent& its = *other.intent;
      if (closest_approach(intent.from_m, intent.to_m, other.position_m, its.to_m).distance_m < apart_m)
        return false;  // (b)
    }
  }
  return true;
}

OnWay on_way(const Vec3& p, std::span<const Vec3> way_m) {
  OnWay best{(p - way_m.front()).norm(), 0.0};
  double before_m = 0.0;
  for (std::size_t n = 1; n < way_m.size(); ++n) {
    const Vec3 d = way_m[n] - way_m[n - 1];
    const double length_m = d.norm();
    if (length_m < 1e-9) continue;
    const double f = std::clamp((p - way_m[n - 1]).dot(d) / (length_m * length_m), 0.0, 1.0);
    const double distance_m = (p - (way_m[n - 1] + f * d)).norm();
    if (distance_m <= best.distance_m) best = {distance_m, before_m + f * length_m};
    before_m += length_m;
  }
  return best;
}

Conflict conflict_of(const Vec3& start, const Vec3& end, const Vec3& after, const Other& other, bool other_first) {
  const double apart_m = other.clearance_m;
  if (point_to_segment(other.next_m, start, end) < apart_m) return Conflict::Standing;
  if (!other_first) return Conflict::None;
  const OnWay at_end = on_way(end, other.way_m);
  if (at_end.distance_m < apart_m) {
    const OnWay then = on_way(after, other.way_m);
    if (then.distance_m < apart_m && then.along_m < at_end.along_m - 1e-6) return Conflict::Against;
  }
  if (other.moves_on && other.way_m.size() > 2 &&
      closest_approach(start, end, other.next_m, other.way_m[2]).distance_m < apart_m)
    return Conflict::Moving;
  return Conflict::None;
}

}  // namespace skein::gridnav
