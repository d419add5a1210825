#include "agent/controller/half_spaces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace skein {
namespace {

/// Velocities (m/s) this much outside count as inside.
constexpr double kTolerance = 1e-9;

/// normal . x >= least, in a plane; the normal is a unit vector.
struct HalfPlane {
  Vec2 normal;
  double least;
};

/// Nearest to `wish` on the boundary of planes[n], in the disc and in the half-planes before n.
std::optional<Vec2> nearest_on_line(std::span<const HalfPlane> planes, std::size_t n, double radius, const Vec2& wish) {
  const Vec2 foot = planes[n].least * planes[n].normal;
  const Vec2 along(-planes[n].normal.y(), planes[n].normal.x());
  const double squared = radius * radius - foot.squaredNorm();
  if (squared < 0.0) return std::nullopt;
  double high = std::sqrt(squared);
  double low = -high;
  for (std::size_t k = 0; k < n; ++k) {
    const double slope = planes[k].normal.dot(along);
    const double rest = planes[k].least - planes[k].normal.dot(foot);
    if (std::fabs(slope) <= kTolerance) {
      if (rest > kTolerance) return std::nullopt;
    } else if (slope > 0.0) {
      low = std::max(low, rest / slope);
    } else {
      high = std::min(high, rest / slope);
    }
    if (low > high) return std::nullopt;
  }
  return foot + std::clamp(along.dot(wish), low, high) * along;
}

std::optional<Vec2> nearest_in_disc(std::span<const HalfPlane> planes, double radius, const Vec2& wish) {
  const double size = wish.norm();
  Vec2 best = size > radius ? Vec2(wish * (radius / size)) : wish;
  for (std::size_t n = 0; n < planes.size(); ++n) {
    if (planes[n].normal.dot(best) >= planes[n].least - kTolerance) continue;
    const std::optional<Vec2> on = nearest_on_line(planes, n, radius, wish);
    if (!on) return std::nullopt;
    best = *on;
  }
  return best;
}

/// Nearest to `wish` in the plane normal . v = offset, in the ball and in `spaces`. `planes` is working space.
std::optional<Vec3> nearest_on_plane(std::span<const HalfSpace> spaces, double slack, const Vec3& normal, double offset,
                                     double radius, const Vec3& wish, std::vector<HalfPlane>& planes) {
  const double squared = radius * radius - offset * offset;
  if (squared < 0.0) return std::nullopt;
  const Vec3 foot = offset * normal;
  const Vec3 e1 = normal.unitOrthogonal();
  const Vec3 e2 = normal.cross(e1);
  planes.clear();
  for (const HalfSpace& space : spaces) {
    const Vec2 in_plane(space.normal.dot(e1), space.normal.dot(e2));
    const double rest = space.least_mps - slack - space.normal.dot(foot);
    const double size = in_plane.norm();
    if (size > kTolerance) {
      planes.push_back({in_plane / size, rest / size});
    } else if (rest > kTolerance) {
      return std::nullopt;
    }
  }
  const std::optional<Vec2> best = nearest_in_disc(planes, std::sqrt(squared), Vec2(wish.dot(e1), wish.dot(e2)));
  if (!best) return std::nullopt;
  return foot + best->x() * e1 + best->y() * e2;
}

}  // namespace

std::optional<Vec3> nearest_in(std::span<const HalfSpace> spaces, double slack_mps, double speed_mps,
                               const Vec3& wish_mps, bool level) {
  std::vector<HalfPlane> planes;
  planes.reserve(spaces.size());
  if (level) {
    auto best = nearest_on_plane(spaces, slack_mps, Vec3::UnitZ(), 0.0, speed_mps, wish_mps, planes);
    if (best) best->z() = 0.0;
    return best;
  }
  const double size = wish_mps.norm();
  Vec3 best = size > speed_mps ? Vec3(wish_mps * (speed_mps / size)) : wish_mps;
  for (std::size_t n = 0; n < spaces.size(); ++n) {
    const double least_mps = spaces[n].least_mps - slack_mps;
    if (spaces[n].normal.dot(best) >= least_mps - kTolerance) continue;
    const std::optional<Vec3> on =
        nearest_on_plane(spaces.first(n), slack_mps, spaces[n].normal, least_mps, speed_mps, wish_mps, planes);
    if (!on) return std::nullopt;
    best = *on;
  }
  return best;
}

Vec3 nearest_or_least_violation(std::span<const HalfSpace> spaces, double speed_mps, const Vec3& wish_mps, bool level) {
  if (const auto best = nearest_in(spaces, 0.0, speed_mps, wish_mps, level)) return *best;
  double low_mps = 0.0;
  double high_mps = 0.0;  // standing still violates no half-space by more
  for (const HalfSpace& space : spaces) high_mps = std::max(high_mps, space.least_mps);
  Vec3 best = Vec3::Zero();
  for (int i = 0; i < kBisections; ++i) {
    const double middle_mps = 0.5 * (low_mps + high_mps);
    if (const auto found = nearest_in(spaces, middle_mps, speed_mps, wish_mps, level)) {
      best = *found;
      high_mps = middle_mps;
    } else {
      low_mps = middle_mps;
    }
  }
  return best;
}

}  // namespace skein
