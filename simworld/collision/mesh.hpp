// A triangle mesh as an obstacle: does a box meet its surface, and how far from it is a segment?
//
// The surface alone is solid: a closed mesh is hollow, but nothing gets in without touching it. Boxes and segments (as
// capsules of kThread_m) are held against a hierarchy of oriented boxes.
// Source: FCL (Pan, Chitta, Manocha, ICRA 2012) for hierarchy and distances; assimp for files. Departs from source:
// none. Complexity: about O(log triangles) a query.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "planner/core/geometry/types.hpp"

namespace skein {

class Mesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// @throws std::invalid_argument without a triangle, or if one names a point that is not there or not finite
  Mesh(std::vector<Vec3> points_m, std::vector<Triangle> triangles);

  [[nodiscard]] const Box& bounds() const;
  [[nodiscard]] std::size_t triangles() const;
  /// The surface meets the box's interior; what reaches in by less than 0.01 mm does not count.
  [[nodiscard]] bool overlaps(const Box& box) const;
  /// Distance (m) of the segment from a to b to the surface, 0 if they meet; right to 0.1 mm.
  [[nodiscard]] double distance_m(const Vec3& a, const Vec3& b) const;

  /// The same points and triangles in the same order.
  bool operator==(const Mesh& other) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;  ///< immutable; copies of a scenario share the hierarchy
};

/// A mesh, or why there is none, as the end of a sentence.
using MeshResult = std::variant<Mesh, std::string>;

/// Reads a file of any kind that assimp knows (obj, stl, ply, dae, ...), scales it about its origin, then moves that
/// to at_m. Files are taken as they are: x east, y north, z up.
[[nodiscard]] MeshResult read_mesh(const std::string& file, const Vec3& at_m, double scale);

}  // namespace skein
