// Where a UAV goes that stands in another's way: to the nearest free place off that way, a bay where there is one.
//
// Breadth first over cells that are seen and free, without cutting corners, from the own cell. A cell is a place to
// wait if a body at its centre keeps clear of the ways that must stay free and of every other where that stands. Cells
// taken by others are no passage; if nothing is found so, those of others that can be asked to move aside are, and the
// first of these on the way is named. If all that is known lies on the way, then along it as far as is known, so that
// who follows gets on and sees more. Beyond the announced way lies 'away': who follows pushes on, until a bay comes.
// Source: Okumura et al., AIJ 2022, section 4 (push). Departs from source: looks further than the cells around.
// Complexity: O(cells visited x others), at most kMostCells cells.
#pragma once

#include <span>
#include <vector>

#include "planner/gridnav/map/known_map.hpp"
#include "planner/gridnav/traffic/right_of_way.hpp"

namespace skein::gridnav {

inline constexpr std::size_t kMostCells = 4096;

struct BackOff {
  std::vector<CellIndex> cells;  ///< from the cell after the own one to the place to wait; empty: none
  AgentId blocked_by = 0;        ///< who stands on the way there and must be asked; 0: nobody
};

/// @param way_first  per other: whether its way must be kept free (it has right of way)
[[nodiscard]] BackOff find_back_off(const KnownMap& map, const Vec3& from_m, std::span<const Other> others,
                                    const std::vector<bool>& way_first);

}  // namespace skein::gridnav
