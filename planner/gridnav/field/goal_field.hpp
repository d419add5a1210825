// Distance of cells to one goal cell, exact on the map as known, repaired where the map changes.
//
// Moves lead to the 8 (26) cells around; a move is open if every cell of the box that its two cells span is open (no
// corner is cut, so that a body as wide as a cell fits). Costs are whole numbers: a move's length in 1/1024 cell edges.
//   rhs(c) = min over open moves c -> n of cost + g(n);  c is consistent if g(c) = rhs(c)
//   key(c) = (min(g, rhs) + h(start, c) + km, min(g, rhs));  inconsistent cells are settled by ascending key
// h is the distance without obstacles, hence consistent; km makes up for a start that has moved. Only cells are touched
// whose value the change alters and the start needs; the value of another cell is settled when it is asked for.
// Source: Koenig, Likhachev, 'D* Lite', AAAI 2002, optimised version (Fig. 4). Departs from source: integer costs,
// values of cells other than the start, lazy deletion from the queue; ties are broken by cell, so results are the same
// everywhere. Complexity: O(k log k) for k cells settled anew.
#pragma once

#include <cstdint>
#include <vector>

#include "planner/core/cells/cell_grid.hpp"

namespace skein::gridnav {

using Cost = std::uint32_t;
inline constexpr Cost kInfinite = 0x3fffffff;  ///< no way
inline constexpr Cost kCellCost = 1024;        ///< of a move by one cell edge

class GoalField {
 public:
  /// All cells open. @pre goal and start are in the grid
  GoalField(const CellGrid& grid, const Cell& goal, const Cell& start);

  /// Says whether a cell is blocked. Values are repaired when they are next asked for.
  void set_blocked(CellIndex cell, bool blocked);
  [[nodiscard]] bool blocked(CellIndex cell) const { return blocked_[place_of(grid_.cell_at(cell))] != 0; }
  /// From where the goal is looked for: values near there are cheap.
  void move_start(CellIndex start);
  /// Distance of a cell to the goal, kInfinite if no way is known to be open.
  [[nodiscard]] Cost value(CellIndex cell);
  [[nodiscard]] double metres(Cost cost) const { return cost * grid_.cell_m / kCellCost; }

  struct Step {
    CellIndex cell;
    Cost cost;
  };
  /// The open moves from a cell, in a fixed order.
  void steps_from(CellIndex cell, std::vector<Step>& steps) const;
  /// g as it stands: exact for cells on a shortest way from the start after value(start), for others a hint.
  [[nodiscard]] Cost settled(CellIndex cell) const { return g_[place_of(grid_.cell_at(cell))]; }
  /// Cells settled so far: the cost of all repairs.
  [[nodiscard]] std::uint64_t expanded() const { return expanded_; }
  [[nodiscard]] CellIndex goal() const { return goal_cell_; }

 private:
  using Place = std::uint32_t;  ///< index in the grid with a border of blocked cells
  struct Move {
    std::int32_t offset;
    Cost cost;
    std::uint32_t needs;  ///< bits of the cells around that must be open
  };
  struct Entry {
    std::uint64_t key;
    Place place;
  };

  void make_moves();
  [[nodiscard]] Place place_of(const Cell& c) const;
  [[nodiscard]] Cell cell_at(Place place) const;
  [[nodiscard]] Cost heuristic(const Cell& a, const Cell& b) const;
  [[nodiscard]] std::uint64_t key_of(Place place) const;
  [[nodiscard]] std::uint32_t blocked_around(Place place) const;
  [[nodiscard]] Cost least(Place place) const;
  void update(Place place);
  void pop();
  void settle(Place target);
  void expand(Place place, std::uint64_t key);
  void raise(Place place);
  void repair();

  CellGrid grid_;
  std::int32_t row_ = 0;
  std::int32_t level_ = 0;
  Cost edge_[2][2][2] = {};  ///< cost of a move, by whether it goes along x or y once, both, and z
  std::vector<Move> moves_;
  std::vector<std::int32_t> around_;
  std::vector<Cost> g_;
  std::vector<Cost> rhs_;
  std::vector<std::uint64_t> queued_;  ///< key in the queue; 0: not in it
  std::vector<std::uint8_t> blocked_;
  std::vector<std::uint8_t> dirty_;
  std::vector<Place> changed_;
  std::vector<Entry> queue_;
  CellIndex goal_cell_;
  Place goal_;
  Cell start_;
  Cost moved_ = 0;  ///< km
  std::uint64_t expanded_ = 0;
};

}  // namespace skein::gridnav
