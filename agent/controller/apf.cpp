#include "agent/controller/apf.hpp"

#include <algorithm>
#include <cmath>

#include "agent/controller/evasion.hpp"
#include "agent/controller/manoeuvre.hpp"
#include "agent/controller/nearest_point.hpp"

namespace skein {
namespace {

/// Of D_safe: how far to the right of straight at a body the field turns from one side to the other.
constexpr double kRight = 0.3;
/// The closing speed (m/s) from which on repulsion is whole.
constexpr double kClosing_mps = 1.0;
/// By which the reach of the repulsion from what moves is wider than that of Eq. 6.
constexpr double kWider = 3.0;
/// The x of Eq. 6 from which on there is no repulsion.
constexpr double kReach = 3.0;

struct Body {
  Vec3 apart_m;     ///< from it to the own place
  Vec3 motion_mps;  ///< own, relative to it
  double safe_m;    ///< D_safe
  double wider;
};

Vec3 right_of(const Vec3& motion) {
  const double flat = motion.x() * motion.x() + motion.y() * motion.y();
  if (flat <= 1e-6 * motion.squaredNorm()) return Vec3::UnitX();
  const double size = std::sqrt(flat);
  return {motion.y() / size, -motion.x() / size, 0.0};
}

/// The repulsion from a body, as a part of the vehicle's speed.
Vec3 push_of(const Body& body, double horizon_s) {
  const double apart_squared = body.apart_m.squaredNorm();
  Vec3 sum = Vec3::Zero();
  if (apart_squared < body.safe_m * body.safe_m && apart_squared > 0.0) {
    const double distance_m = std::sqrt(apart_squared);
    sum = (1.0 - distance_m / body.safe_m) / distance_m * body.apart_m;
  }
  const double squared = body.motion_mps.squaredNorm();
  const double closing = -body.apart_m.dot(body.motion_mps);
  if (closing <= 0.0 || closing >= squared * horizon_s) return sum;
  const double at_s = closing / squared;
  const Vec3 offset_m = body.apart_m + at_s * body.motion_mps;
  const double unit_m = body.wider * body.safe_m;  // x = 1 at this distance
  const double offset_squared = offset_m.squaredNorm();
  if (offset_squared >= kReach * kReach * unit_m * unit_m) return sum;
  const Vec3 aside_m = offset_m + kRight * body.safe_m * right_of(body.motion_mps);
  const double size_m = aside_m.norm();
  if (!(size_m > 0.0)) return sum;
  const double approach = std::min(1.0, closing / (std::sqrt(apart_squared) * kClosing_mps));
  const double strength = repulsion(std::sqrt(offset_squared) / unit_m) * (1.0 - at_s / horizon_s) * approach;
  return sum + strength / size_m * aside_m;
}

Vec3 level(const Vec3& v) {
  return {v.x(), v.y(), 0.0};
}

/// The sum of all repulsions, as a part of the vehicle's speed.
/// @param eager part of its speed that the vehicle wishes to fly: who is about to arrive gives less way to peers, which
/// mind it as it minds them, so that several can close in on one goal
Vec3 push_of_all(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene, double eager) {
  const double own_m = spec.radius_m + options.margin_m;
  const Vec3& p = scene.position_m;
  const Vec3& v = scene.velocity_mps;
  Vec3 sum = Vec3::Zero();
  for (const Neighbour& other : scene.neighbours) {
    const Body body{p - other.position_m, v - other.velocity_mps, own_m + other.radius_m, kWider};
    sum += eager * push_of(body, options.horizon_s);
  }
  for (const Track& track : scene.tracks) {
    Body body{p - track.position_m, v - track.velocity_mps, own_m + track.radius_m, track.fixed ? 1.0 : kWider};
    if (track.column) {
      body.apart_m = level(body.apart_m);
      body.motion_mps = level(body.motion_mps);
    }
    sum += push_of(body, options.horizon_s);
  }
  for (const ZoneShape& zone : scene.zones) {
    sum += push_of({p - nearest_point(p, zone), v, own_m, 1.0}, options.horizon_s);
  }
  return sum;
}

}  // namespace

Vec3 attraction(const Vec3& to_goal_m, double speed_mps, double acceleration_mps2) {
  const double distance_m = to_goal_m.norm();
  if (!(distance_m > 0.0)) return Vec3::Zero();
  const double near_mps = std::min(distance_m, std::sqrt(acceleration_mps2 * distance_m));
  return std::min(speed_mps, near_mps) / distance_m * to_goal_m;
}

double repulsion(double x) {
  if (x >= kReach) return 0.0;
  return x < 2.0 ? 1.0 - 0.45 * x : 0.1 * (kReach - x);
}

Vec3 apf_velocity(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene, const Vec3& wish_mps) {
  const bool flat = wish_mps.z() == 0.0 && scene.velocity_mps.z() == 0.0;
  Vec3 push = push_of_all(options, spec, scene, std::min(1.0, wish_mps.norm() / spec.speed_mps));
  if (flat) push.z() = 0.0;
  Vec3 wanted_mps = wish_mps;
  if (!push.isZero(0.0)) wanted_mps = clipped(wish_mps + spec.speed_mps * push, spec.speed_mps);
  return evading(options, spec, scene, wanted_mps, flat);
}

}  // namespace skein
