#include "agent/controller/separation.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace skein {
namespace {

/// Segments whose directions differ by less than this (sine squared) count as parallel.
constexpr double kParallel = 1e-12;

/// From the closest point of b to that of a.
Vec3 between(const Segment& a, const Segment& b) {
  const Vec3 along_a = a.to_m - a.from_m;
  const Vec3 along_b = b.to_m - b.from_m;
  const Vec3 apart = a.from_m - b.from_m;
  const double aa = along_a.squaredNorm();
  const double bb = along_b.squaredNorm();
  const double ab = along_a.dot(along_b);
  const double a_apart = along_a.dot(apart);
  const double b_apart = along_b.dot(apart);
  double s = 0.0;
  double t = 0.0;
  if (bb <= 0.0) {
    if (aa > 0.0) s = std::clamp(-a_apart / aa, 0.0, 1.0);
  } else if (aa <= 0.0) {
    t = std::clamp(b_apart / bb, 0.0, 1.0);
  } else {
    const double cross = aa * bb - ab * ab;
    if (cross > kParallel * aa * bb) s = std::clamp((ab * b_apart - a_apart * bb) / cross, 0.0, 1.0);
    t = (ab * s + b_apart) / bb;
    if (t < 0.0 || t > 1.0) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((t * ab - a_apart) / aa, 0.0, 1.0);
    }
  }
  return apart + s * along_a - t * along_b;
}

bool before(const Segment& a, const Segment& b) {
  const auto key = [](const Segment& s) {
    return std::tuple(s.from_m.x(), s.from_m.y(), s.from_m.z(), s.to_m.x(), s.to_m.y(), s.to_m.z());
  };
  return key(a) < key(b);
}

}  // namespace

Separation separation(const Segment& own, const Segment& other) {
  const bool first = before(own, other);
  const Segment& a = first ? own : other;
  const Segment& b = first ? other : own;
  const Vec3 apart = between(a, b);
  const double distance = apart.norm();
  if (!(distance > 0.0)) return {};
  const Vec3 n = apart / distance;
  const double low = std::min(n.dot(a.from_m), n.dot(a.to_m));
  const double high = std::max(n.dot(b.from_m), n.dot(b.to_m));
  const double sign = first ? 1.0 : -1.0;
  return {sign * n, sign * 0.5 * (low + high), 0.5 * (low - high)};
}

double distance_m(const Segment& a, const Segment& b) {
  return between(a, b).norm();
}

}  // namespace skein
