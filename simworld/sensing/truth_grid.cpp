#include "simworld/sensing/truth_grid.hpp"

#include <algorithm>
#include <stdexcept>

namespace skein {
namespace {

constexpr double kTouch_m = 1e-9;

/// The index of the cell in which a coordinate lies, moved into 0 .. count - 1.
std::int32_t clamped(double cells, std::int32_t count) {
  return static_cast<std::int32_t>(std::clamp(std::floor(cells), 0.0, static_cast<double>(count - 1)));
}

Box shrunk(const Box& box) {
  const Vec3 by = Vec3::Constant(kTouch_m);
  return {box.min_m + by, box.max_m - by};
}

}  // namespace

TruthGrid::TruthGrid(const CellGrid& grid, std::span<const Obstacle> obstacles) : grid_(grid) {
  if (grid.nx < 1 || grid.ny < 1 || grid.nz < 1) throw std::invalid_argument("a grid without cells");
  occupied_.resize(grid.size());
  for (const Obstacle& obstacle : obstacles) add(obstacle);
  sum_up();
}

void TruthGrid::sum_up() {
  sums_.resize(place_of_sum(grid_.nx, grid_.ny, grid_.nz) + 1);
  for (std::int32_t k = 0; k < grid_.nz; ++k) {
    for (std::int32_t j = 0; j < grid_.ny; ++j) {
      std::uint32_t row = 0;
      for (std::int32_t i = 0; i < grid_.nx; ++i) {
        row += occupied_[grid_.index_of({i, j, k})];
        const std::uint32_t level = row + below(i + 1, j, k + 1) - below(i + 1, j, k);
        sums_[place_of_sum(i + 1, j + 1, k + 1)] = level + below(i + 1, j + 1, k);
      }
    }
  }
}

std::uint32_t TruthGrid::occupied_between(const Cell& a, const Cell& b) const {
  const Cell low{std::min(a.i, b.i), std::min(a.j, b.j), std::min(a.k, b.k)};
  const Cell high{std::max(a.i, b.i) + 1, std::max(a.j, b.j) + 1, std::max(a.k, b.k) + 1};
  const auto level = [&](std::int32_t k) {
    return below(high.i, high.j, k) - below(low.i, high.j, k) - below(high.i, low.j, k) + below(low.i, low.j, k);
  };
  return level(high.k) - level(low.k);
}

void TruthGrid::add(const Obstacle& obstacle) {
  const Box bounds = bounds_of(obstacle);
  const Vec3 edge(grid_.cell_m, grid_.cell_m, grid_.height_m);
  const Vec3 low = (bounds.min_m - grid_.origin_m).cwiseQuotient(edge);
  const Vec3 high = (bounds.max_m - grid_.origin_m).cwiseQuotient(edge);
  const Vec3 count(grid_.nx, grid_.ny, grid_.nz);
  if ((high.array() <= 0.0).any() || (low.array() >= count.array()).any()) return;
  for (std::int32_t k = clamped(low.z(), grid_.nz); k <= clamped(high.z(), grid_.nz); ++k) {
    for (std::int32_t j = clamped(low.y(), grid_.ny); j <= clamped(high.y(), grid_.ny); ++j) {
      for (std::int32_t i = clamped(low.x(), grid_.nx); i <= clamped(high.x(), grid_.nx); ++i) {
        std::uint8_t& cell = occupied_[grid_.index_of({i, j, k})];
        if (cell == 0 && overlaps(obstacle, shrunk(grid_.box_of({i, j, k})))) cell = 1;
      }
    }
  }
}

bool TruthGrid::may_move(const Cell& from, const Cell& to) const {
  return grid_.contains(from) && grid_.contains(to) && occupied_between(from, to) == 0;
}

std::vector<Obstacle> all_obstacles(const Mission& mission, std::span<const Obstacle> hidden) {
  std::vector<Obstacle> all(hidden.begin(), hidden.end());
  for (const Zone& zone : mission.zones) {
    std::visit([&](const auto& shape) { all.push_back({shape, zone.no_fly ? "no_fly" : "obstacles"}); }, zone.shape);
  }
  if (mission.terrain) all.push_back({*mission.terrain, "terrain"});
  return all;
}

}  // namespace skein
