#include "simworld/movers/movers.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/movers/appearance.hpp"

namespace skein {
namespace {

/// Below this speed a UAV has no course on which something could appear.
constexpr double kLeastCourse_mps = 0.1;

/// A unit vector, uniform over the circle or the sphere.
Vec3 drawn_direction(RandomStream& stream, bool level) {
  const math::SinCos turn = math::sincos(stream.uniform(0.0, math::kTwoPi));
  const double up = level ? 0.0 : stream.uniform(-1.0, 1.0);
  const double across = std::sqrt(1.0 - up * up);
  return {across * turn.cos, across * turn.sin, up};
}

bool walks_level(const Mover& mover, const WalkMotion& motion) {
  return mover.column || motion.within.max_m.z() <= motion.within.min_m.z();
}

}  // namespace

double distance_m(const Vec3& point_m, const Vec3& centre_m, bool column) {
  const Vec3 apart_m = point_m - centre_m;
  return column ? apart_m.head<2>().norm() : apart_m.norm();
}

double speed_of(const Mover& mover) {
  if (const auto* line = std::get_if<LineMotion>(&mover.motion)) return line->velocity_mps.norm();
  if (const auto* loop = std::get_if<LoopMotion>(&mover.motion)) return loop->speed_mps;
  const auto* walk = std::get_if<WalkMotion>(&mover.motion);
  return walk == nullptr ? 0.0 : walk->speed_mps;
}

Movers::Movers(std::vector<Mover> movers, std::vector<Vec3> goals_m, double goal_clearance_m, std::uint64_t seed,
               double step_s)
    : goals_m_(std::move(goals_m)), goal_clearance_m_(goal_clearance_m), seed_(seed), step_s_(step_s) {
  for (Mover& mover : movers) {
    MoverRecord& record = movers_.emplace_back();
    record.id = static_cast<std::uint32_t>(movers_.size());
    record.position_m = record.before_m = mover.position_m;
    record.spec = std::move(mover);
  }
}

void Movers::add(Mover mover, std::uint32_t step, double step_s) {
  step_s_ = step_s;
  MoverRecord& record = movers_.emplace_back();
  record.id = static_cast<std::uint32_t>(movers_.size());
  record.position_m = mover.position_m;
  record.spec = std::move(mover);
  start(record, step);
}

void Movers::open(std::uint32_t step, std::span<const Bystander> vehicles) {
  const double time_s = step_s_ * static_cast<double>(step - 1);
  for (MoverRecord& mover : movers_) {
    if (mover.present && time_s >= mover.spec.until_s) {
      mover.present = false;
      mover.gone_step = step;
    }
    if (mover.appeared_step != 0 || !due(mover, time_s, vehicles) || !place(mover, vehicles)) continue;
    if (mover.spec.sudden && !may_appear(mover, vehicles)) continue;
    start(mover, step);
  }
}

bool Movers::due(MoverRecord& mover, double time_s, std::span<const Bystander> vehicles) const {
  const Mover& spec = mover.spec;
  if (time_s < spec.at_s || time_s >= spec.until_s) return false;
  if (spec.near_m <= 0.0 || mover.armed) return true;
  mover.armed = std::ranges::any_of(vehicles, [&](const Bystander& vehicle) {
    return vehicle.in_the_air && distance_m(vehicle.position_m, spec.position_m, spec.column) <= spec.near_m;
  });
  return mover.armed;
}

/// False if the UAV on whose course it is to appear has none.
bool Movers::place(MoverRecord& mover, std::span<const Bystander> vehicles) const {
  if (!mover.spec.ahead) return true;
  const AheadOf& ahead = *mover.spec.ahead;
  auto target = std::ranges::find(vehicles, ahead.agent, [](const Bystander& vehicle) { return vehicle.spec.id; });
  if (ahead.agent == 0) {
    RandomStream stream(seed_, mover.id, Purpose::Mover, 0);
    target = vehicles.begin() + static_cast<std::ptrdiff_t>(stream.below(vehicles.size()));
  }
  if (target == vehicles.end() || !target->in_the_air) return false;
  Vec3 course = target->velocity_mps;
  if (mover.spec.column) course.z() = 0.0;
  const double speed_mps = course.norm();
  if (speed_mps < kLeastCourse_mps) return false;
  const double meeting_s = ahead.distance_m / speed_mps;
  mover.position_m = target->position_m + meeting_s * course;
  if (!ahead.crosses) return true;
  const Vec2 level_mps = course.head<2>();
  if (level_mps.norm() < kLeastCourse_mps) return false;
  RandomStream stream(seed_, mover.id, Purpose::Mover, 0);
  (void)stream.next();  // that of the UAV
  const double side = stream.uniform() < 0.5 ? 1.0 : -1.0;
  const Vec2 across = side / level_mps.norm() * Vec2(-level_mps.y(), level_mps.x());
  mover.velocity_mps = speed_of(mover.spec) * Vec3(across.x(), across.y(), 0.0);
  mover.position_m -= meeting_s * mover.velocity_mps;
  return true;
}

bool Movers::may_appear(const MoverRecord& mover, std::span<const Bystander> vehicles) const {
  const Mover& spec = mover.spec;
  const bool stays = std::holds_alternative<StillMotion>(spec.motion) && std::isinf(spec.until_s);
  const bool bars_goal = spec.ahead && stays && std::ranges::any_of(goals_m_, [&](const Vec3& goal_m) {
                           return distance_m(goal_m, mover.position_m, spec.column) < spec.radius_m + goal_clearance_m_;
                         });
  return !bars_goal && std::ranges::none_of(vehicles, [&](const Bystander& vehicle) {
    if (!vehicle.in_the_air) return false;
    const double needed_m = least_appearance_m(vehicle.spec, vehicle.velocity_mps.norm(), speed_of(spec), step_s_) +
                            vehicle.spec.radius_m + spec.radius_m;
    return distance_m(vehicle.position_m, mover.position_m, spec.column) <= needed_m;
  });
}

void Movers::start(MoverRecord& mover, std::uint32_t step) const {
  mover.present = true;
  mover.appeared_step = step;
  mover.before_m = mover.position_m;
  const bool crosses = mover.spec.ahead && mover.spec.ahead->crosses;
  const auto* line = std::get_if<LineMotion>(&mover.spec.motion);
  if (line != nullptr && !crosses) mover.velocity_mps = line->velocity_mps;
  if (const auto* loop = std::get_if<LoopMotion>(&mover.spec.motion)) {
    const Vec3 leg_m = loop->waypoints_m[1] - loop->waypoints_m[0];
    mover.velocity_mps = leg_m * (loop->speed_mps / leg_m.norm());
  }
  if (const auto* walk = std::get_if<WalkMotion>(&mover.spec.motion)) {
    RandomStream stream(seed_, mover.id, Purpose::Mover, 0);
    (void)stream.next();  // that of `ahead`
    mover.velocity_mps = walk->speed_mps * drawn_direction(stream, walks_level(mover.spec, *walk));
  }
}

void Movers::advance(std::uint32_t step) {
  for (MoverRecord& mover : movers_) {
    mover.before_m = mover.position_m;
    if (!mover.present) continue;
    if (const auto* walking = std::get_if<WalkMotion>(&mover.spec.motion)) {
      walk(mover, *walking, step);
    } else if (const auto* looping = std::get_if<LoopMotion>(&mover.spec.motion)) {
      loop(mover, *looping);
    } else {
      mover.position_m += step_s_ * mover.velocity_mps;
    }
  }
}

void Movers::walk(MoverRecord& mover, const WalkMotion& motion, std::uint32_t step) const {
  RandomStream stream(seed_, mover.id, Purpose::Mover, step);
  if (stream.uniform() * motion.turn_s < step_s_) {
    mover.velocity_mps = motion.speed_mps * drawn_direction(stream, walks_level(mover.spec, motion));
  }
  mover.position_m += step_s_ * mover.velocity_mps;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double low_m = motion.within.min_m[axis];
    const double high_m = motion.within.max_m[axis];
    double& at_m = mover.position_m[axis];
    if (at_m >= low_m && at_m <= high_m) continue;
    at_m = std::clamp(at_m < low_m ? low_m + (low_m - at_m) : high_m - (at_m - high_m), low_m, high_m);
    mover.velocity_mps[axis] = -mover.velocity_mps[axis];
  }
}

void Movers::loop(MoverRecord& mover, const LoopMotion& motion) const {
  double left_m = motion.speed_mps * step_s_;
  for (std::size_t legs = 0; left_m > 0.0 && legs <= 2 * motion.waypoints_m.size(); ++legs) {
    const Vec3 leg_m = motion.waypoints_m[mover.next_waypoint] - mover.position_m;
    const double length_m = leg_m.norm();
    if (length_m > 0.0) mover.velocity_mps = leg_m * (motion.speed_mps / length_m);
    if (length_m > left_m) {
      mover.position_m += leg_m * (left_m / length_m);
      return;
    }
    mover.position_m = motion.waypoints_m[mover.next_waypoint];
    mover.next_waypoint = (mover.next_waypoint + 1) % motion.waypoints_m.size();
    left_m -= length_m;
  }
}

void Movers::add_to(StateHash& hash) const {
  for (const MoverRecord& mover : movers_) {
    hash.add(mover.present).add(mover.appeared_step).add(mover.position_m).add(mover.velocity_mps);
  }
}

}  // namespace skein
