#include "tests/planner/gridnav/maps.hpp"

#include <algorithm>
#include <array>

#include "planner/core/random/random_stream.hpp"

namespace skein::gridnav {
namespace {

constexpr std::array<std::array<double, 4>, 27> kBoxes{{
    {240, 0, 270, 36},    {240, 48, 270, 213},  {240, 216, 270, 260}, {240, 265, 270, 372}, {240, 380, 270, 500},
    {192, 182, 240, 190}, {192, 238, 240, 246}, {204, 206, 212, 216}, {212, 224, 220, 232}, {100, 110, 124, 134},
    {130, 180, 154, 204}, {60, 190, 84, 214},   {160, 270, 190, 300}, {90, 290, 130, 330},  {150, 60, 190, 90},
    {60, 380, 110, 420},  {150, 400, 190, 430}, {196, 110, 214, 130}, {310, 230, 334, 254}, {310, 290, 334, 314},
    {350, 180, 390, 210}, {300, 80, 340, 120},  {380, 60, 420, 110},  {390, 262, 398, 296}, {400, 340, 408, 372},
    {310, 400, 350, 440}, {420, 420, 460, 460},
}};
constexpr std::array<double, 4> kLastBox{330, 340, 350, 360};
constexpr std::array<std::array<double, 2>, 9> kStarts{
    {{39, 69}, {39, 93}, {39, 45}, {27, 81}, {27, 57}, {51, 81}, {51, 57}, {27, 105}, {27, 33}}};

}  // namespace

Layout forest_in_space(std::uint64_t seed, const CellGrid& grid, double density, std::size_t uavs) {
  Layout layout;
  layout.grid = grid;
  RandomStream stream(seed, 0, Purpose::Test, 5);
  std::vector<CellIndex> free;
  for (CellIndex n = 0; n < grid.size(); ++n) {
    layout.occupied.push_back(stream.uniform() < density);
    if (!layout.occupied.back()) free.push_back(n);
  }
  for (std::size_t n = 0; n < 2 * uavs; ++n) {
    const std::size_t at = stream.below(free.size());
    const Cell c = grid.cell_at(free[at]);
    if (n % 2 == 0)
      layout.starts.push_back(c);
    else
      layout.goals_m.push_back(grid.centre_m(c));
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return layout;
}

Layout forest(std::uint64_t seed, std::int32_t nx, std::int32_t ny, double density, double cell_m, std::size_t uavs) {
  return forest_in_space(seed, {Vec3::Zero(), cell_m, cell_m, nx, ny, 1}, density, uavs);
}

Layout power_station(double cell_m, std::size_t uavs) {
  Layout layout;
  layout.grid = grid_over({Vec3(0, 0, 4), Vec3(500, 500, 24)}, cell_m, 20.0);
  const CellGrid& grid = layout.grid;
  layout.occupied.assign(grid.size(), false);
  const auto block = [&](const std::array<double, 4>& b) {
    for (CellIndex n = 0; n < grid.size(); ++n) {
      const Box box = grid.box_of(grid.cell_at(n));
      if (box.min_m.x() < b[2] && box.max_m.x() > b[0] && box.min_m.y() < b[3] && box.max_m.y() > b[1])
        layout.occupied[n] = true;
    }
  };
  std::for_each(kBoxes.begin(), kBoxes.end(), block);
  block(kLastBox);
  for (std::size_t n = 0; n < uavs; ++n) {
    layout.starts.push_back(grid.cell_of(Vec3(kStarts[n][0], kStarts[n][1], 14.0)));
    layout.goals_m.push_back(Vec3(465, 330, 14));
  }
  return layout;
}

}  // namespace skein::gridnav
