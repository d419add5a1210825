// Is a cell in sight of a point: does a ray reach it through free cells?
//
// A ray goes from the point to the cell's centre, and, if that is blocked, to the centres of those faces (at most
// three) that look towards the point. It is blocked by the first occupied cell on its way, whole: the grid is walked
// cell by cell (Amanatides, Woo 1987). Conservative: a cell counts as opaque all over even if the obstacle fills only a
// part of it, and a ray through an edge or corner is blocked if one of the cells that meet there is occupied. The
// point's own cell blocks nothing, and an occupied cell is seen by its near side. Where nothing is in the block between
// the two, no ray is needed.
// Source: Amanatides, Woo, 'A fast voxel traversal algorithm for ray tracing', Eurographics 1987. Departs from source:
// edges and corners are crossed at once. Complexity: O(1), beside obstacles O(cells between).
#pragma once

#include "simworld/sensing/truth_grid.hpp"

namespace skein {

/// @param from_m a point (of a plane at any height); outside the grid nothing is in sight
/// @pre the grid contains the cell
[[nodiscard]] bool in_sight(const TruthGrid& truth, const Vec3& from_m, const Cell& cell);

}  // namespace skein
