#include "simworld/collision/obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/core/geometry/distance.hpp"
#include "simworld/collision/clearance.hpp"

namespace skein {
namespace {

constexpr double kFar_m = 1e8;  // beyond every coordinate of a scenario

Box bounds(const Box& box) {
  return box;
}
Box bounds(const Cylinder& c) {
  const Vec2 reach = Vec2::Constant(c.radius_m);
  Box box;
  box.min_m << c.centre_m - reach, c.z_min_m;
  box.max_m << c.centre_m + reach, c.z_max_m;
  return box;
}
Box bounds(const Sphere& s) {
  const Vec3 reach = Vec3::Constant(s.radius_m);
  return {s.centre_m - reach, s.centre_m + reach};
}
Box bounds(const Terrain& terrain) {
  return {Vec3(-kFar_m, -kFar_m, -kUnboundedZ_m), Vec3(kFar_m, kFar_m, highest_m(terrain))};
}
Box bounds(const Mesh& mesh) {
  return mesh.bounds();
}

bool meets(const Box& a, const Box& b) {
  return (a.min_m.array() < b.max_m.array()).all() && (b.min_m.array() < a.max_m.array()).all();
}
bool meets(const Cylinder& c, const Box& box) {
  if (c.z_min_m >= box.max_m.z() || c.z_max_m <= box.min_m.z()) return false;
  const Vec2 nearest = c.centre_m.cwiseMax(box.min_m.head<2>()).cwiseMin(box.max_m.head<2>());
  return (nearest - c.centre_m).squaredNorm() < c.radius_m * c.radius_m;
}
bool meets(const Sphere& s, const Box& box) {
  const Vec3 nearest = s.centre_m.cwiseMax(box.min_m).cwiseMin(box.max_m);
  return (nearest - s.centre_m).squaredNorm() < s.radius_m * s.radius_m;
}
bool meets(const Terrain& terrain, const Box& box) {
  const Vec2 half = 0.5 * (box.max_m - box.min_m).head<2>();
  const Vec2 middle = 0.5 * (box.max_m + box.min_m).head<2>();
  return ground_m(terrain, middle) + slope_bound(terrain) * half.norm() > box.min_m.z();
}
bool meets(const Mesh& mesh, const Box& box) {
  return mesh.overlaps(box);
}

double clearance(const Motion& motion, const Box& box) {
  return clearance_m(motion, Zone{box, false});
}
double clearance(const Motion& motion, const Cylinder& cylinder) {
  return clearance_m(motion, Zone{cylinder, false});
}
double clearance(const Motion& motion, const Terrain& terrain) {
  return clearance_m(motion, terrain);
}
double clearance(const Motion& motion, const Sphere& sphere) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    least_m = std::min(least_m, point_to_segment(sphere.centre_m, motion.points_m[p - 1], motion.points_m[p]));
  }
  return least_m - sphere.radius_m;
}
double clearance(const Motion& motion, const Mesh& mesh) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t p = 1; p < kMotionPoints; ++p) {
    least_m = std::min(least_m, mesh.distance_m(motion.points_m[p - 1], motion.points_m[p]));
  }
  return least_m;
}

}  // namespace

Box bounds_of(const Obstacle& obstacle) {
  return std::visit([](const auto& shape) { return bounds(shape); }, obstacle.shape);
}

bool overlaps(const Obstacle& obstacle, const Box& box) {
  return std::visit([&](const auto& shape) { return meets(shape, box); }, obstacle.shape);
}

double clearance_m(const Motion& motion, const Obstacle& obstacle) {
  return std::visit([&](const auto& shape) { return clearance(motion, shape); }, obstacle.shape);
}

double least_clearance_m(const Motion& motion, const Box& bounds) {
  Vec3 low = motion.points_m.front();
  Vec3 high = low;
  for (const Vec3& p : motion.points_m) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 apart = (bounds.min_m - high).cwiseMax(low - bounds.max_m).cwiseMax(Vec3::Zero());
  return apart.norm();
}

}  // namespace skein
