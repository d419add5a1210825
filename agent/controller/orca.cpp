#include "agent/controller/orca.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "agent/controller/nearest_point.hpp"

namespace skein {
namespace {

/// By which the wish is turned to the right where something is in the way.
constexpr double kTurn = 1e-3;

/// Any direction square to the one given (which need not be a unit vector).
Vec3 square_to(const Vec3& v) {
  return v.squaredNorm() > 0.0 ? Vec3(v.unitOrthogonal()) : Vec3(Vec3::UnitX());
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const double size = v.norm();
  return size > 1e-12 ? Vec3(v / size) : otherwise;
}

}  // namespace

HalfSpace reciprocal(const Vec3& apart_m, const Vec3& own_mps, const Vec3& its_mps, double touch_m, double share,
                     double horizon_s, double step_s) {
  const Vec3 w = own_mps - its_mps;
  const double squared = apart_m.squaredNorm();
  const bool clear = squared > touch_m * touch_m;
  const double time_s = clear ? horizon_s : step_s;
  const Vec3 from_ball = w - apart_m / time_s;
  const double along = from_ball.dot(apart_m);
  Vec3 normal;
  double change = 0.0;  // u = change * normal
  if (!clear || (along < 0.0 && along * along > touch_m * touch_m * from_ball.squaredNorm())) {
    normal = unit_or(from_ball, unit_or(-apart_m, Vec3::UnitX()));
    change = touch_m / time_s - from_ball.norm();
  } else {  // the foot on the cone: sin of its half angle is R / |x|
    const double distance = std::sqrt(squared);
    const Vec3 axis = apart_m / distance;
    const double forward = w.dot(axis);
    const Vec3 aside = w - forward * axis;
    const double sine = touch_m / distance;
    const double cosine = std::sqrt(1.0 - sine * sine);
    normal = cosine * unit_or(aside, square_to(axis)) - sine * axis;
    change = -normal.dot(w);
  }
  return {normal, normal.dot(own_mps) + share * change};
}

Vec3 orca_velocity(const ControllerOptions& options, const VehicleSpec& spec, double step_s, const Scene& scene,
                   const Vec3& wish_mps) {
  const double own_m = spec.radius_m + options.margin_m;
  const double reach_m = 2.0 * spec.speed_mps * options.horizon_s;
  std::vector<HalfSpace> spaces;
  spaces.reserve(scene.neighbours.size() + scene.tracks.size() + scene.zones.size());
  const auto add = [&](const Vec3& apart_m, const Vec3& its_mps, const Vec3& own_mps, double touch_m, double share) {
    if (apart_m.norm() > reach_m + touch_m) return;
    spaces.push_back(
        reciprocal(apart_m, own_mps, its_mps, touch_m, share, std::max(step_s, options.horizon_s), step_s));
  };
  const auto flat = [](const Vec3& v, bool column) { return column ? Vec3(v.x(), v.y(), 0.0) : v; };
  for (const Track& t : scene.tracks) {
    add(flat(t.position_m - scene.position_m, t.column), flat(t.velocity_mps, t.column),
        flat(scene.velocity_mps, t.column), own_m + t.radius_m, 1.0);
  }
  for (const ZoneShape& zone : scene.zones) {
    const Vec3 nearest_m = nearest_point(scene.position_m, zone);
    add(nearest_m - scene.position_m, Vec3::Zero(), scene.velocity_mps, own_m, 1.0);
  }
  for (const Neighbour& n : scene.neighbours) {
    add(n.position_m - scene.position_m, n.velocity_mps, scene.velocity_mps, own_m + n.radius_m, 0.5);
  }
  const auto fits = [&](const HalfSpace& space) { return space.normal.dot(wish_mps) >= space.least_mps; };
  if (std::ranges::all_of(spaces, fits)) return wish_mps;
  const bool level = wish_mps.z() == 0.0 && scene.velocity_mps.z() == 0.0;
  const Vec3 turned_mps = wish_mps + kTurn * Vec3(wish_mps.y(), -wish_mps.x(), 0.0);
  return nearest_or_least_violation(spaces, spec.speed_mps, turned_mps, level);
}

}  // namespace skein
