// The two spaces that a rendezvous is planned in: what a point, a path, its pieces and an interpolant are there.
//
// Cost, swarm and alignment are written once over a `Space` and instantiated for both, so that a planar problem pays
// nothing for the third axis. The header of each declares the templates; aliases without `In` name the planar ones.
// Source: papers/001, sections 4.1 and 4.2. Departs from source: none. Complexity: none.
#pragma once

#include <span>
#include <type_traits>

#include "planner/rendezvous/kernel/kernel.hpp"
#include "planner/rendezvous/ph/joined_hermite.hpp"

namespace skein::rendezvous {

struct Planar {
  using Vec = Vec2;
  using Piece = ph::PlanarPath;
  using Path = ph::JoinedPlanarPath;
  using Hermite = ph::JoinedHermite;
  using EndRows = kernel::Ends;
  using PathRows = kernel::Paths;
  static constexpr bool kSpatial = false;
  [[nodiscard]] static const kernel::Steps& steps(const kernel::Kernel& kernel) { return kernel.planar; }
};

struct Spatial {
  using Vec = Vec3;
  using Piece = ph::SpatialPath;
  using Path = ph::JoinedSpatialPath;
  using Hermite = ph::SpatialJoinedHermite;
  using EndRows = kernel::SpatialEnds;
  using PathRows = kernel::SpatialPaths;
  static constexpr bool kSpatial = true;
  [[nodiscard]] static const kernel::Steps& steps(const kernel::Kernel& kernel) { return kernel.spatial; }
};

/// A view that takes no part in the deduction of the space, so that vectors and empty braces convert to it.
template <typename T>
using View = std::type_identity_t<std::span<const T>>;

}  // namespace skein::rendezvous
