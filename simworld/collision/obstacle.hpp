// An obstacle of the world, in any of its shapes: which boxes it overlaps, and how close a motion comes to it.
//
// Overlap is of interiors, exact for boxes, cylinders and spheres: the distance from the shape's axis or centre to the
// box is less than the radius. Under a terrain a box counts as soon as the ground may reach into it, by its height at
// the box's centre and its steepest slope: never too late. A mesh is its surface (simworld/collision/mesh.hpp).
// Source: elementary. Departs from source: none. Complexity: O(1); of a mesh about O(log triangles).
#pragma once

#include <string>
#include <variant>

#include "planner/core/geometry/terrain.hpp"
#include "planner/core/geometry/types.hpp"
#include "simworld/collision/mesh.hpp"
#include "simworld/vehicles/constant_speed.hpp"

namespace skein {

struct Sphere {
  Vec3 centre_m = Vec3::Zero();
  double radius_m = 0.0;

  bool operator==(const Sphere&) const = default;
};

struct Obstacle {
  std::variant<Box, Cylinder, Sphere, Terrain, Mesh> shape;
  std::string name;  ///< its place in the scenario, for messages

  bool operator==(const Obstacle&) const = default;
};

/// The least box that holds the shape, or one that is larger; of a terrain everything below its highest point.
[[nodiscard]] Box bounds_of(const Obstacle& obstacle);

/// The interiors meet. @pre the box has a positive volume
[[nodiscard]] bool overlaps(const Obstacle& obstacle, const Box& box);

/// Least signed distance (m) from the motion of a centre to the surface, negative inside; 0 on and in a mesh's surface.
[[nodiscard]] double clearance_m(const Motion& motion, const Obstacle& obstacle);

/// At most the distance (m) of the motion to the obstacle: that of their bounding boxes, 0 if these meet.
[[nodiscard]] double least_clearance_m(const Motion& motion, const Box& bounds);

}  // namespace skein
