#include "groundstation/figure/outline.hpp"

#include "planner/core/math/det_math.hpp"

namespace skein::figure {
namespace {

constexpr int kCorners = 72;
constexpr double kTurn_rad = 6.283185307179586;

std::vector<Vec2> circle(const Vec2& centre_m, double radius_m) {
  std::vector<Vec2> corners;
  for (int k = 0; k <= kCorners; ++k) {
    const double angle_rad = kTurn_rad * (k % kCorners) / kCorners;
    corners.emplace_back(centre_m + radius_m * Vec2(math::cos(angle_rad), math::sin(angle_rad)));
  }
  return corners;
}

struct Outliner {
  ZoneKind kind;

  Outline operator()(const Cylinder& cylinder) const {
    return {kind, circle(cylinder.centre_m, cylinder.radius_m), {cylinder.z_min_m, cylinder.z_max_m}};
  }
  Outline operator()(const Box& box) const {
    const Vec3& a = box.min_m;
    const Vec3& b = box.max_m;
    return {kind, {{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}, {a.x(), a.y()}}, {a.z(), b.z()}};
  }
  Outline operator()(const Sphere& sphere) const {
    const double z_m = sphere.centre_m.z();
    return {kind, circle(sphere.centre_m.head<2>(), sphere.radius_m), {z_m - sphere.radius_m, z_m + sphere.radius_m}};
  }
  Outline operator()(const Mesh& mesh) const { return (*this)(mesh.bounds()); }
  Outline operator()(const Terrain& /*terrain*/) const { return {kind, {}, {}}; }
};

}  // namespace

Outline outline_of(const Zone& zone) {
  return std::visit(Outliner{zone.no_fly ? ZoneKind::NoFly : ZoneKind::Obstacle}, zone.shape);
}

Outline outline_of(const Obstacle& hidden) {
  return std::visit(Outliner{ZoneKind::Hidden}, hidden.shape);
}

Outline outline_of(const Announcement& announced) {
  return std::visit(Outliner{ZoneKind::Announced}, announced.shape);
}

}  // namespace skein::figure
