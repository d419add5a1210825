#include "planner/core/geometry/terrain.hpp"

#include <algorithm>
#include <cmath>

#include "planner/core/math/det_math.hpp"

namespace skein {

double ground_m(const Terrain& terrain, const Vec2& place_m) {
  const double x = place_m.x() / terrain.unit_m;
  const double y = place_m.y() / terrain.unit_m;
  const double height = terrain.a * math::sin(x + terrain.b) + terrain.c * math::sin(y + terrain.d) +
                        terrain.e * math::cos(terrain.f * std::sqrt(x * x + y * y)) +
                        terrain.g * math::sin(terrain.h * x + terrain.l * y);
  return height * terrain.unit_m;
}

double highest_m(const Terrain& terrain) {
  return (std::fabs(terrain.a) + std::fabs(terrain.c) + std::fabs(terrain.e) + std::fabs(terrain.g)) * terrain.unit_m;
}

double slope_bound(const Terrain& terrain) {
  return std::sqrt(terrain.a * terrain.a + terrain.c * terrain.c) + std::fabs(terrain.e * terrain.f) +
         std::fabs(terrain.g) * std::sqrt(terrain.h * terrain.h + terrain.l * terrain.l);
}

double tilt_of(const Terrain& terrain) {
  const double slope = slope_bound(terrain);
  return std::sqrt(1.0 + slope * slope);
}

double bend_bound_per_m(const Terrain& terrain) {
  const double bend = std::max(std::fabs(terrain.a), std::fabs(terrain.c)) +
                      std::fabs(terrain.e) * terrain.f * terrain.f +
                      std::fabs(terrain.g) * (terrain.h * terrain.h + terrain.l * terrain.l);
  return bend / terrain.unit_m;
}

double height_above_m(const Terrain& terrain, const Vec3& p) {
  return p.z() - ground_m(terrain, p.head<2>());
}

double least_height_above_m(const Terrain& terrain, const Vec3& a, const Vec3& b) {
  const double level_squared = (b - a).head<2>().squaredNorm();
  return std::min(height_above_m(terrain, a), height_above_m(terrain, b)) -
         bend_bound_per_m(terrain) * level_squared / 8.0;
}

}  // namespace skein
