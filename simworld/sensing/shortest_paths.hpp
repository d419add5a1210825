// The shortest ways with full knowledge of the truth, to measure flights against, and which cells a path joins.
//
// Dijkstra from each different goal cell over free cells, from centre to centre, to the 8 (26) neighbours and cutting
// no corner (TruthGrid::may_move). Source: facts of papers/004, section IV-C, 'shortest path'; Dijkstra 1959.
// Departs from source: none. Complexity: O(goals * cells log cells).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "simworld/sensing/truth_grid.hpp"

namespace skein {

/// By start: the length (m) of the shortest way from its cell's centre to that of its goal's cell; nothing if there is
/// none or one of the two is occupied or outside. @pre as many goals as starts
[[nodiscard]] std::vector<std::optional<double>> shortest_paths_m(const TruthGrid& truth,
                                                                  std::span<const Vec3> starts_m,
                                                                  std::span<const Vec3> goals_m);

/// By cell: the number, from 1, of the region of free cells that paths join it with; 0 if it is occupied.
[[nodiscard]] std::vector<std::uint32_t> regions_of(const TruthGrid& truth);

}  // namespace skein
