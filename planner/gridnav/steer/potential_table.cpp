#include "planner/gridnav/steer/potential_table.hpp"

#include <algorithm>
#include <cstdlib>

#include "planner/gridnav/steer/potential.hpp"

namespace skein::gridnav {

PotentialTable::PotentialTable(const Task& task)
    : grid_(task.grid),
      goal_(task.grid.cell_of(task.goal_m)),
      alpha_(task.options.obstacle_potential),
      minimum_raise_(task.options.minimum_raise * task.options.obstacle_potential),
      detected_m_(task.sensor_range_m),
      raised_(grid_.size(), 0.0),
      occupied_(grid_.size(), 0),
      beside_(grid_.size(), 0),
      revisited_(grid_.size(), 0) {}

template <typename Visit>
void PotentialTable::for_around(const Cell& c, Visit visit) const {
  const std::int32_t up = grid_.nz > 1 ? 1 : 0;
  for (std::int32_t k = -up; k <= up; ++k)
    for (std::int32_t j = -1; j <= 1; ++j)
      for (std::int32_t i = -1; i <= 1; ++i) {
        const Cell n{c.i + i, c.j + j, c.k + k};
        if ((i != 0 || j != 0 || k != 0) && grid_.contains(n)) visit(n, Cell{i, j, k});
      }
}

bool PotentialTable::learn(std::span<const CellChange> changed) {
  bool any = false;
  for (const CellChange& change : changed) {
    revisited_[change.cell] = change.state == CellState::Revisited ? 1 : 0;
    const std::uint8_t now = change.state == CellState::Occupied ? 1 : 0;
    if (now == occupied_[change.cell]) continue;
    occupied_[change.cell] = now;
    any = true;
    for_around(grid_.cell_at(change.cell), [&](const Cell& n, const Cell&) {
      std::uint8_t& count = beside_[grid_.index_of(n)];
      count = static_cast<std::uint8_t>(now != 0 ? count + 1 : count - 1);
    });
  }
  return any;
}

void PotentialTable::avoid(const Vec3& own_m, std::span<const Other> others) {
  neighbours_.clear();
  for (const Other& other : others)
    if ((other.next_m - own_m).norm() <= detected_m_) neighbours_.push_back(grid_.cell_of(other.next_m));
}

bool PotentialTable::near_neighbour(const Cell& c) const {
  return std::any_of(neighbours_.begin(), neighbours_.end(), [&](const Cell& n) {
    return std::abs(n.i - c.i) <= 1 && std::abs(n.j - c.j) <= 1 && std::abs(n.k - c.k) <= 1;
  });
}

double PotentialTable::sum(CellIndex cell) const {
  const Cell c = grid_.cell_at(cell);
  double total = goal_potential(grid_, c, goal_) + (beside_[cell] != 0 ? alpha_ / 2 : 0.0);
  total += raised_[cell] == 0.0 && revisited_[cell] != 0 ? minimum_raise_ : raised_[cell];
  return near_neighbour(c) ? total + alpha_ : total;
}

void PotentialTable::cells_around(const Cell& c, std::vector<Cell>& cells) const {
  cells.clear();
  for_around(c, [&](const Cell& n, const Cell& d) {
    bool open = true;
    for (int part = 1; part < 8 && open; ++part)
      open = !occupied(
          {c.i + ((part & 1) != 0 ? d.i : 0), c.j + ((part & 2) != 0 ? d.j : 0), c.k + ((part & 4) != 0 ? d.k : 0)});
    if (open) cells.push_back(n);
  });
}

}  // namespace skein::gridnav
