#include "planner/core/geometry/distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace skein {
namespace {

template <typename Vec>
double to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

/// Signed distance to the box [low, high] of n dimensions.
template <typename Vec>
double point_to_box(const Vec& p, const Vec& low, const Vec& high) {
  double outside_squared = 0.0;
  double deepest = -HUGE_VAL;
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const double beyond = std::max(low[i] - p[i], p[i] - high[i]);
    deepest = std::max(deepest, beyond);
    if (beyond > 0.0) outside_squared += beyond * beyond;
  }
  return deepest > 0.0 ? std::sqrt(outside_squared) : deepest;
}

/// Half the derivative of the squared distance to the box, by t, at the point a + t along.
template <typename Vec>
double slope_at(double t, const Vec& a, const Vec& along, const Vec& low, const Vec& high) {
  double slope = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const double x = a[i] + t * along[i];
    if (x < low[i]) slope += (x - low[i]) * along[i];
    if (x > high[i]) slope += (x - high[i]) * along[i];
  }
  return slope;
}

/// Place of the least distance to the box: the root of a non-decreasing piecewise linear slope.
template <typename Vec>
double nearest_place(const Vec& a, const Vec& along, const Vec& low, const Vec& high) {
  std::array<double, 8> knots{0.0, 1.0};  // ascending: the ends, and where a coordinate meets a face
  std::size_t n = 2;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (along[i] == 0.0) continue;
    for (const double bound : {low[i], high[i]}) {
      const double t = (bound - a[i]) / along[i];
      if (!(t > 0.0 && t < 1.0)) continue;
      std::size_t place = n++;
      for (; knots[place - 1] > t; --place) knots[place] = knots[place - 1];
      knots[place] = t;
    }
  }
  double before = slope_at(knots[0], a, along, low, high);
  if (before >= 0.0) return knots[0];
  for (std::size_t i = 1; i < n; ++i) {
    const double after = slope_at(knots[i], a, along, low, high);
    if (after >= 0.0) return knots[i - 1] + (knots[i] - knots[i - 1]) * (-before / (after - before));
    before = after;
  }
  return 1.0;
}

/// Deepest point of a segment that meets the box: least, over t, of the largest of 2 n lines.
template <typename Vec>
double deepest_in_box(const Vec& a, const Vec& along, const Vec& low, const Vec& high) {
  struct Line {
    double at_start;
    double slope;
  };
  std::array<Line, 6> lines{};
  std::size_t n = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    lines[n++] = {low[i] - a[i], -along[i]};
    lines[n++] = {a[i] - high[i], along[i]};
  }
  const auto value = [&](double t) {
    double largest = -HUGE_VAL;
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, lines[i].at_start + t * lines[i].slope);
    return largest;
  };
  double least = std::min(value(0.0), value(1.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const double slopes = lines[i].slope - lines[j].slope;
      if (slopes == 0.0) continue;
      const double t = (lines[j].at_start - lines[i].at_start) / slopes;
      if (t > 0.0 && t < 1.0) least = std::min(least, value(t));
    }
  }
  return least;
}

template <typename Vec>
double segment_to_box(const Vec& a, const Vec& b, const Vec& low, const Vec& high) {
  const Vec along = b - a;
  const double t = nearest_place(a, along, low, high);
  const double outside = point_to_box(Vec(a + t * along), low, high);
  return outside > 0.0 ? outside : std::min(outside, deepest_in_box(a, along, low, high));
}

Vec2 low_of(const Box& box) {
  return box.min_m.head<2>();
}
Vec2 high_of(const Box& box) {
  return box.max_m.head<2>();
}

/// Least value on [0, 1] of a convex function, to rounding.
template <typename Function>
double least_of_convex(const Function& f) {
  constexpr double kGolden = 0.6180339887498949;
  double low = 0.0;
  double high = 1.0;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double f_left = f(left);
  double f_right = f(right);
  double least = std::min({f(low), f(high), f_left, f_right});
  for (int i = 0; i < 80; ++i) {
    if (f_left <= f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - kGolden * (high - low);
      f_left = f(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + kGolden * (high - low);
      f_right = f(right);
    }
    least = std::min({least, f_left, f_right});
  }
  return least;
}

}  // namespace

double point_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return to_segment(p, a, b);
}

double point_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return to_segment(p, a, b);
}

double signed_distance(const Vec2& p, const Cylinder& cylinder) {
  return (p - cylinder.centre_m).norm() - cylinder.radius_m;
}

double signed_distance(const Vec2& p, const Box& box) {
  return point_to_box(p, low_of(box), high_of(box));
}

double signed_distance(const Vec2& a, const Vec2& b, const Cylinder& cylinder) {
  return to_segment(cylinder.centre_m, a, b) - cylinder.radius_m;
}

double signed_distance(const Vec2& a, const Vec2& b, const Box& box) {
  return segment_to_box(a, b, low_of(box), high_of(box));
}

double signed_distance(const Vec3& p, const Cylinder& cylinder) {
  const double radial = signed_distance(Vec2(p.head<2>()), cylinder);
  const double axial = std::max(cylinder.z_min_m - p.z(), p.z() - cylinder.z_max_m);
  return radial > 0.0 && axial > 0.0 ? std::sqrt(radial * radial + axial * axial) : std::max(radial, axial);
}

double signed_distance(const Vec3& p, const Box& box) {
  return point_to_box(p, box.min_m, box.max_m);
}

double signed_distance(const Vec3& a, const Vec3& b, const Cylinder& cylinder) {
  if (std::min(a.z(), b.z()) >= cylinder.z_min_m && std::max(a.z(), b.z()) <= cylinder.z_max_m) {
    const double beside_m = signed_distance(Vec2(a.head<2>()), Vec2(b.head<2>()), cylinder);
    if (beside_m >= 0.0) return beside_m;  // between the heights of the ends the side is nearest
  }
  const Vec3 along = b - a;
  return least_of_convex([&](double t) { return signed_distance(Vec3(a + t * along), cylinder); });
}

double signed_distance(const Vec3& a, const Vec3& b, const Box& box) {
  return segment_to_box(a, b, box.min_m, box.max_m);
}

}  // namespace skein
