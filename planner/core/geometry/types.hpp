// Value types of space, shared by every layer.
//
// Frames: world ENU (x east, y north, z up), body FLU (x forward, y left, z up). Headings turn counter-clockwise from
// east. SI throughout: metres, seconds, radians.
#pragma once

#include <Eigen/Core>

namespace skein {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// Position and direction of motion in the world frame (papers/001, section 2.1: x, y, z, chi, gamma).
struct Pose {
  Vec3 position_m = Vec3::Zero();
  double heading_rad = 0.0;  ///< chi: direction in the horizontal plane, from east, counter-clockwise
  double climb_rad = 0.0;    ///< gamma: above the horizontal plane

  bool operator==(const Pose&) const = default;
};

/// A vertical range that stands for 'unbounded': nothing flies higher or lower.
inline constexpr double kUnboundedZ_m = 1e6;

/// Upright cylinder; a circle in planar problems.
struct Cylinder {
  Vec2 centre_m = Vec2::Zero();
  double radius_m = 0.0;
  double z_min_m = -kUnboundedZ_m;
  double z_max_m = kUnboundedZ_m;

  bool operator==(const Cylinder&) const = default;
};

/// Axis-aligned box; a rectangle in planar problems.
struct Box {
  Vec3 min_m = Vec3(0.0, 0.0, -kUnboundedZ_m);
  Vec3 max_m = Vec3(0.0, 0.0, kUnboundedZ_m);

  bool operator==(const Box&) const = default;
};

}  // namespace skein
