// Which motion a UAV announces for the next decision, given what its planner offers and what the others said.
//
//   1. the first option that conflicts with nobody;
//   2. if only motions of others with right of way are in the way: wait;
//   3. a detour: a cell nearer to the goal that conflicts with nobody;
//   4. if somebody with right of way asks, or comes against: back off, on its behalf (back_off.hpp);
//   5. wait, and ask whoever stands in the way without right of way, unless a command holds it there.
// A UAV that is asked counts as the asker does in the order, so it may itself ask the next one: the chain ends at a
// free cell, or nobody moves and patience runs out.
// Source: Okumura et al., AIJ 2022 (PIBT). Departs from source: by messages; see right_of_way.hpp.
// Complexity: O(options x others), and one breadth-first search when it backs off.
#pragma once

#include <functional>

#include "planner/gridnav/traffic/back_off.hpp"
#include "planner/gridnav/traffic/right_of_way.hpp"

namespace skein::gridnav {

/// A straight motion that is clear on the map.
struct Option {
  Vec3 end_m;
  Vec3 after_m;  ///< where the way leads on from there
};

struct Traveller {
  Body body;
  Vec3 start_m;  ///< where the motion of the next decision starts
  Intent own;    ///< status, waited, to_go_m of its own; on_behalf_of itself
};

struct Announcement {
  Intent intent;          ///< without from_m, next_cells and decision
  bool yielding = false;  ///< whether it is for others with right of way that it does not get on
};

/// @param detours  asked for only if all options are obstructed
[[nodiscard]] Announcement negotiate(const KnownMap& map, const Traveller& traveller, std::span<const Option> options,
                                     const std::function<std::vector<Option>()>& detours,
                                     std::span<const Other> others);

/// The first option that conflicts with nobody, or staying; for planners that neither ask nor give way.
[[nodiscard]] Announcement announce_plainly(const Traveller& traveller, std::span<const Option> options,
                                            std::span<const Other> others);

}  // namespace skein::gridnav
