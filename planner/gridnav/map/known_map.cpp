#include "planner/gridnav/map/known_map.hpp"

#include <algorithm>
#include <array>

#include "planner/core/geometry/distance.hpp"

namespace skein::gridnav {
namespace {

constexpr double kTouch_m = 1e-9;  ///< a body may touch a cell

struct Range {
  double from = 0.0;
  double to = 1.0;
};

/// The part of `within` in which the segment's coordinate a + f (b - a) lies in [low, high].
Range clip(double a, double b, double low, double high, Range within) {
  const double d = b - a;
  if (std::fabs(d) < 1e-12) return a < low || a > high ? Range{1.0, 0.0} : within;
  const double f0 = (low - a) / d;
  const double f1 = (high - a) / d;
  return {std::max(within.from, std::min(f0, f1)), std::min(within.to, std::max(f0, f1))};
}

struct Cells {
  std::int32_t first;
  std::int32_t last;
};

/// The cells of one axis that lie within r of the segment's coordinate over a part of it.
Cells cells_of(double a, double b, Range part, double r, double edge, std::int32_t n) {
  const double p = a + part.from * (b - a);
  const double q = a + part.to * (b - a);
  const auto at = [edge](double x) { return static_cast<std::int32_t>(std::floor(x / edge)); };
  return {std::max(at(std::min(p, q) - r), 0), std::min(at(std::max(p, q) + r), n - 1)};
}

}  // namespace

bool KnownMap::motion_clear(const Vec3& a, const Vec3& b, double radius_m, Need need) const {
  const CellGrid& g = grid_;
  const Vec3 p = a - g.origin_m;
  const Vec3 q = b - g.origin_m;
  const Vec3 size(g.nx * g.cell_m, g.ny * g.cell_m, g.nz * g.height_m);
  for (int axis = 0; axis < (planar() ? 2 : 3); ++axis) {
    if (std::min(p[axis], q[axis]) - radius_m < -kTouch_m) return false;
    if (std::max(p[axis], q[axis]) + radius_m > size[axis] + kTouch_m) return false;
  }
  const auto hit = [&](const Box& box) {
    const double d = planar() ? signed_distance(Vec2(a.head<2>()), Vec2(b.head<2>()), box) : signed_distance(a, b, box);
    return d < radius_m - kTouch_m;
  };
  const Cells is = cells_of(p.x(), q.x(), {}, radius_m, g.cell_m, g.nx);
  for (std::int32_t i = is.first; i <= is.last; ++i) {
    const Range x = clip(p.x(), q.x(), i * g.cell_m - radius_m, (i + 1) * g.cell_m + radius_m, {});
    if (x.from > x.to) continue;
    const Cells js = cells_of(p.y(), q.y(), x, radius_m, g.cell_m, g.ny);
    for (std::int32_t j = js.first; j <= js.last; ++j) {
      const Range xy = clip(p.y(), q.y(), j * g.cell_m - radius_m, (j + 1) * g.cell_m + radius_m, x);
      if (xy.from > xy.to) continue;
      const Cells ks = planar() ? Cells{0, 0} : cells_of(p.z(), q.z(), xy, radius_m, g.height_m, g.nz);
      for (std::int32_t k = ks.first; k <= ks.last; ++k) {
        const Cell c{i, j, k};
        if (!good(g.index_of(c), need) && hit(g.box_of(c))) return false;
      }
    }
  }
  return true;
}

}  // namespace skein::gridnav
