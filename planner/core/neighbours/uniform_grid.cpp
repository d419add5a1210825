#include "planner/core/neighbours/uniform_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace skein {
namespace {

/// Beyond so many cells a coordinate counts as that many: what is there shares the cells at the rim.
constexpr double kRim = 1e9;

std::int64_t cell_of(double x, double cell_m) {
  return static_cast<std::int64_t>(std::floor(std::clamp(x / cell_m, -kRim, kRim)));
}

}  // namespace

UniformGrid::UniformGrid(std::span<const Vec3> points_m, double cell_m) : cell_m_(cell_m) {
  if (!(cell_m > 0.0) || !std::isfinite(cell_m)) throw std::invalid_argument("cell_m must be positive and finite");
  std::size_t slots = 1;
  while (slots < points_m.size()) slots *= 2;
  mask_ = slots - 1;
  begin_.assign(slots + 1, 0);
  std::vector<std::size_t> slot(points_m.size());
  for (std::size_t n = 0; n < points_m.size(); ++n) {
    const Vec3& p = points_m[n];
    if (!p.allFinite()) throw std::invalid_argument("a point is not finite");
    slot[n] = slot_of(cell_of(p.x(), cell_m_), cell_of(p.y(), cell_m_), cell_of(p.z(), cell_m_));
    ++begin_[slot[n] + 1];
  }
  for (std::size_t s = 0; s < slots; ++s) begin_[s + 1] += begin_[s];
  order_.resize(points_m.size());
  sorted_m_.resize(points_m.size());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t n = 0; n < points_m.size(); ++n) {
    const std::uint32_t at = next[slot[n]]++;
    order_[at] = static_cast<std::uint32_t>(n);
    sorted_m_[at] = points_m[n];
  }
}

std::size_t UniformGrid::slot_of(std::int64_t i, std::int64_t j, std::int64_t k) const {
  std::uint64_t mixed = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U;
  mixed = (mixed ^ (mixed >> 32U)) + static_cast<std::uint64_t>(j);
  mixed *= 0xbf58476d1ce4e5b9U;
  mixed = (mixed ^ (mixed >> 32U)) + static_cast<std::uint64_t>(k);
  mixed *= 0x94d049bb133111ebU;
  return static_cast<std::size_t>(mixed ^ (mixed >> 32U)) & mask_;
}

void UniformGrid::within(const Vec3& place_m, double radius_m, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (!place_m.allFinite() || !std::isfinite(radius_m) || radius_m < 0.0) return;
  const double squared = radius_m * radius_m;
  std::int64_t low[3];
  std::int64_t high[3];
  double cells = 1.0;
  for (Eigen::Index d = 0; d < 3; ++d) {
    low[d] = cell_of(place_m[d] - radius_m, cell_m_);
    high[d] = cell_of(place_m[d] + radius_m, cell_m_);
    cells *= static_cast<double>(high[d] - low[d] + 1);
  }
  if (cells > static_cast<double>(order_.size())) {  // to look at every point is less
    for (std::size_t at = 0; at < order_.size(); ++at) {
      if ((sorted_m_[at] - place_m).squaredNorm() <= squared) found.push_back(order_[at]);
    }
    std::sort(found.begin(), found.end());
    return;
  }
  for (std::int64_t i = low[0]; i <= high[0]; ++i)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      for (std::int64_t k = low[2]; k <= high[2]; ++k) {
        const std::size_t slot = slot_of(i, j, k);
        for (std::uint32_t at = begin_[slot]; at < begin_[slot + 1]; ++at) {
          const Vec3& p = sorted_m_[at];
          if ((p - place_m).squaredNorm() > squared) continue;
          const bool here =
              cell_of(p.x(), cell_m_) == i && cell_of(p.y(), cell_m_) == j && cell_of(p.z(), cell_m_) == k;
          if (here) found.push_back(order_[at]);  // another cell may share the slot
        }
      }
  std::sort(found.begin(), found.end());
}

}  // namespace skein
