// Starts and goals drawn by the seed, from free cells or from cells that a path joins.
//
// One stream, (seed, 0, Layout, 1): a free cell of the box for starts is drawn, until the cells that count with it (all
// free ones, or those of its region) hold enough starts and goals; then starts and goals are drawn from these without
// repetition, each start at least the sum of both safety radii from the others and outside the goal radius of its goal.
// Source: none; after papers/004, section IV-C, whose starts and goals are not printed. Departs from source: none.
// Complexity: O(cells + tries * vehicles).
#pragma once

#include <vector>

#include "simworld/scenario/common.hpp"
#include "simworld/sensing/truth_grid.hpp"

namespace skein::scenario {

inline constexpr Keys kDrawKeys[] = {"from", "own_goals", "starts", "goals"};

struct Draw {
  bool connected = true;  ///< paths join all starts and goals; else they are just free
  bool own_goals = false;
  Box starts;  ///< boxes in which the cells' centres lie
  Box goals;
};

struct Drawn {
  std::vector<Vec3> starts_m;  ///< centres of cells
  std::vector<Vec3> goals_m;   ///< as many
};

/// The section draw. @param own_goals if the section does not say
[[nodiscard]] Draw read_draw(const MapReader& root, const Box& area, bool own_goals);

/// Places for `vehicles` vehicles. @throws ReadFault at `place` if no room is found
[[nodiscard]] Drawn draw_places(const Draw& draw, const TruthGrid& truth, std::size_t vehicles,
                                const VehicleSpec& common, double goal_radius_m, std::uint64_t seed,
                                const Place& place);

}  // namespace skein::scenario
