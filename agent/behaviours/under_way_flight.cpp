#include <algorithm>
#include <cmath>

#include "agent/behaviours/under_way.hpp"
#include "planner/core/geometry/distance.hpp"
#include "planner/core/geometry/frames.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein {
namespace {

Vec3 velocity_along(double heading_rad, double speed_mps) {
  const Vec2 along = direction_of_heading(heading_rad);
  return {speed_mps * along.x(), speed_mps * along.y(), 0.0};
}

/// A level pose after an arc of a length (m) that turns by an angle (rad).
Pose after_arc(const Pose& pose, double length_m, double turn_rad) {
  const double half_rad = 0.5 * turn_rad;
  const double chord_m = length_m * (std::fabs(half_rad) > 1e-8 ? math::sin(half_rad) / half_rad : 1.0);
  Pose after = pose;
  after.position_m += velocity_along(pose.heading_rad + half_rad, chord_m);
  after.heading_rad = math::wrap_angle(pose.heading_rad + turn_rad);
  return after;
}

}  // namespace

/// Of a constant-speed vehicle: on its path, or on its circle.
Pose UnderWay::pose_at_switch(const Tick& tick) const {
  const double step_m = spec_.speed_mps * mission_.step_s;
  const double steps = replanning_.switch_step() - tick.step;
  if (accepted_) {
    const double s_m = plan_->follower.next_m() + steps * step_m;
    const Vec3 along = plan_->path.direction_at(s_m);
    Pose pose;
    pose.position_m = plan_->path.position_at(s_m) + std::max(0.0, s_m - plan_->path.length_m()) * along;
    pose.heading_rad = heading_of(along.head<2>());
    pose.climb_rad = math::atan2(along.z(), along.head<2>().norm());
    return pose;
  }
  Pose pose = sense_.pose;
  if (tick.phase == Phase::Planning) {  // what it senses is a step old
    const double turned = math::wrap_angle(heading_of(steering_.velocity_mps.head<2>()) - pose.heading_rad);
    pose = after_arc(pose, step_m, std::clamp(turned, -std::fabs(turn_rad_), std::fabs(turn_rad_)));
  }
  for (double k = 0.0; k < steps; k += 1.0) pose = after_arc(pose, step_m, turn_rad_);
  return pose;
}

/// The velocity that plan or waiting place ask for.
Vec3 UnderWay::wish() {
  const Pose& pose = sense_.pose;
  if (!hovers()) {
    if (!accepted_) return velocity_along(pose.heading_rad + turn_rad_, spec_.speed_mps);
    reference_m_ = plan_->path.position_at(plan_->follower.next_m());
    const auto command =
        std::visit([&](const auto& path) { return plan_->follower.command(path, pose); }, plan_->path.in_space());
    arrived_ = command.path_flown && !replanning_.engaged();
    return command.velocity_mps;
  }
  if (on_path()) {
    const FlightPath& path = plan_->path;
    const auto position_at = [&](double s_m) { return path.position_at(s_m); };
    reference_m_ = path.position_at(plan_->reference.travelled_m(path.length_m(), plan_->reference.now_s()));
    const MovingReference::Command command = plan_->reference.command(path.length_m(), position_at, pose.position_m);
    const double off_m = (slot_pose(mission_, spec_).position_m - pose.position_m).norm();
    arrived_ = arrived_ || (!waiting_ && command.path_flown && off_m <= mission_.arrival_radius_m);
    return clipped(command.velocity_mps, top_mps_);
  }
  if (!waiting_) {
    const std::vector<Track> known = obstacles();
    waiting_ = place_off_path({mission_, self_, known}, pose.position_m, sense_.velocity_mps);
  }
  reference_m_ = waiting_->pose.position_m;
  return clipped(hold_.towards(*reference_m_, pose.position_m), top_mps_);
}

/// Whether the plan enters one of the zones within the horizon.
bool UnderWay::leads_into(std::span<const ZoneShape> zones) const {
  if (zones.empty() || !accepted_) return false;
  const double from_m = to_come_m();
  const double to_m = std::min(plan_->path.length_m(), from_m + spec_.speed_mps * mission_.controller.horizon_s);
  for (double s_m = from_m; s_m <= to_m; s_m += 0.5 * spec_.speed_mps * mission_.step_s) {
    const Vec3 there_m = plan_->path.position_at(s_m);
    for (const ZoneShape& zone : zones) {
      const double off_m = std::visit([&](const auto& shape) { return signed_distance(there_m, shape); }, zone);
      if (off_m < spec_.radius_m + mission_.controller.margin_m) return true;
    }
  }
  return false;
}

void UnderWay::fly(RoundOutput& out) {
  if (!sense_.obeyed) {  // its vehicle is not its own: it holds its course
    out.commanded_velocity_mps = sense_.velocity_mps;
    return;
  }
  steering_ = {wish(), false, false, false};
  if (hovers() && mission_.controller.sensor_range_m > 0.0) {
    steering_ = controller_.command(surroundings_.scene(), steering_.velocity_mps);
  }
  out.commanded_velocity_mps = steering_.velocity_mps;
  watch_over(out);
}

void UnderWay::watch_over(RoundOutput& out) const {
  Situation now = surroundings_.situation(Vec3::Zero());
  if (accepted_) now.reference_m = reference_m_;
  now.has_plan = accepted_;
  now.replanning = replanning_.engaged();
  now.zone_unconfirmed = leads_into(surroundings_.closed_zones());
  now.steering = steering_;
  const Watch found = watch(mission_.controller, now);
  out.safety_mode = found.mode;
  out.safety_reason = found.reason;
  out.deviation_m = found.deviation_m;
  out.predicted_separation_m = found.predicted_separation_m;
}

void UnderWay::add_to(StateHash& hash) const {
  replanning_.add_to(hash);
  speed_.add_to(hash);
  late_.add_to(hash);
  surroundings_.add_to(hash);
  hash.add(plan_.has_value()).add(accepted_);
  if (plan_) {
    plan_->reference.add_to(hash);
    plan_->follower.add_to(hash);
    hash.add(plan_->path.length_m());
  }
  if (waiting_) hash.add(waiting_->pose).add(waiting_->stop ? waiting_->stop->at_m : -1.0);
  hash.add(known_.size());
  for (const Known& known : known_) {
    hash.add(known.settled);
    skein::add_to(hash, known.track);
  }
  hash.add(arrived_).add(turn_rad_).add(steering_.velocity_mps);
}

}  // namespace skein
