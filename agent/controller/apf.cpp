#include "agent/controller/apf.hpp"

#include <algorithm>
#include <cmath>

namespace skein {
namespace {

constexpr double kRight = 0.3;
constexpr double kGain = 1.0;
constexpr double kClosing_mps = 1.0;
constexpr double kMix = 0.0;
constexpr double kReach = 1.0;

struct Body {
  Vec3 position_m;
  Vec3 velocity_mps;
  double safe_m;  ///< D_safe
  bool column;
};

Vec3 right_of(const Vec3& motion) {
  const double flat = std::sqrt(motion.x() * motion.x() + motion.y() * motion.y());
  if (flat <= 1e-3 * motion.norm()) return Vec3::UnitX();
  return Vec3(motion.y() / flat, -motion.x() / flat, 0.0);
}

Vec3 push_of(const Body& body, const Vec3& position_m, const Vec3& velocity_mps, double horizon_s) {
  Vec3 apart_m = position_m - body.position_m;
  Vec3 motion_mps = velocity_mps - body.velocity_mps;
  if (body.column) apart_m.z() = motion_mps.z() = 0.0;
  const double speed_squared = motion_mps.squaredNorm();
  const double closing = -apart_m.dot(motion_mps);
  const double distance_m = apart_m.norm();
  Vec3 sum = Vec3::Zero();
  if (distance_m < body.safe_m && distance_m > 0.0) sum += (1.0 - distance_m / body.safe_m) / distance_m * apart_m;
  if (closing <= 0.0 || closing >= speed_squared * horizon_s) return sum;
  const double at_s = closing / speed_squared;
  const Vec3 offset_m = apart_m + at_s * motion_mps;
  const double strength = repulsion(offset_m.norm() / (kReach * body.safe_m));
  if (strength <= 0.0) return sum;
  const double approach = std::min(1.0, closing / (distance_m * kClosing_mps));
  const Vec3 aside_m = offset_m + kRight * body.safe_m * right_of(motion_mps);
  const double size = aside_m.norm();
  if (!(size > 0.0)) return sum;
  return sum + strength * (1.0 - at_s / horizon_s) * approach / size * aside_m;
}

}  // namespace

Vec3 attraction(const Vec3& to_goal_m, double speed_mps, double acceleration_mps2) {
  const double distance_m = to_goal_m.norm();
  if (!(distance_m > 0.0)) return Vec3::Zero();
  const double near_mps = std::min(distance_m, std::sqrt(acceleration_mps2 * distance_m));
  return std::min(speed_mps, near_mps) / distance_m * to_goal_m;
}

double repulsion(double x) {
  if (x >= 3.0) return 0.0;
  return x < 2.0 ? 1.0 - 0.45 * x : 0.1 * (3.0 - x);
}

Vec3 apf_push(const ControllerOptions& options, const VehicleSpec& spec, const Scene& scene, const Vec3& wish_mps) {
  Vec3 sum = Vec3::Zero();
  const double own_m = spec.radius_m + options.margin_m;
  const Vec3 u = kMix * wish_mps + (1 - kMix) * scene.velocity_mps;
  for (const Neighbour& other : scene.neighbours) {
    const Body body{other.position_m, other.velocity_mps, own_m + other.radius_m, false};
    sum += push_of(body, scene.position_m, u, options.horizon_s);
  }
  for (const Track& track : scene.tracks) {
    const Body body{track.position_m, track.velocity_mps, own_m + track.radius_m, track.column};
    sum += push_of(body, scene.position_m, u, options.horizon_s);
  }
  if (wish_mps.z() == 0.0 && scene.velocity_mps.z() == 0.0) sum.z() = 0.0;
  return kGain * spec.speed_mps * sum;
}

}  // namespace skein
