#include "groundstation/monitor/canvas.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace skein::monitor {
namespace {

constexpr char32_t kBraille = 0x2800;
constexpr std::array<std::array<std::uint8_t, 2>, 4> kBits{{{1, 8}, {2, 16}, {4, 32}, {64, 128}}};
/// By the number of dots.
constexpr std::array<char32_t, 9> kDensity{U' ', U'.', U'.', U':', U':', U'+', U'+', U'#', U'#'};

/// Narrows [from, to] of the line's parameter to where start + t way lies in [0, size). @return whether any is left
bool clip(double start, double way, double size, double& from, double& to) {
  if (way == 0.0) return start >= 0.0 && start < size;
  const double a = -start / way;
  const double b = (size - 1e-9 - start) / way;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
  return from <= to;
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(std::max(0, width)),
      height_(std::max(0, height)),
      cells_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void Canvas::dot(int x, int y, const Style& style, int rank) {
  if (x < 0 || y < 0 || x >= width() || y >= height()) return;
  Cell& cell = cells_[place(x / 2, y / 4)];
  cell.dots =
      static_cast<std::uint8_t>(cell.dots | kBits[static_cast<std::size_t>(y % 4)][static_cast<std::size_t>(x % 2)]);
  if (rank < cell.rank) return;
  cell.rank = rank;
  cell.style = style;
}

int Canvas::line(const Dot& from, const Dot& to, const Style& style, int rank, int every, int phase) {
  double begin = 0.0;
  double end = 1.0;
  const Dot way{to.x - from.x, to.y - from.y};
  if (!std::isfinite(way.x) || !std::isfinite(way.y)) return phase;
  if (!clip(from.x, way.x, width(), begin, end) || !clip(from.y, way.y, height(), begin, end)) return phase;
  const double length = std::max(std::fabs(way.x), std::fabs(way.y)) * (end - begin);
  const int steps = static_cast<int>(std::ceil(length));
  for (int i = 0; i <= steps; ++i) {
    if ((phase + i) % every != 0) continue;
    const double t = steps == 0 ? begin : begin + (end - begin) * i / steps;
    dot(static_cast<int>(std::floor(from.x + t * way.x)), static_cast<int>(std::floor(from.y + t * way.y)), style,
        rank);
  }
  return phase + steps;
}

void Canvas::draw(Grid& grid, int x, int y, Symbols symbols) const {
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const Cell& cell = cells_[place(column, row)];
      if (cell.dots == 0) continue;
      const auto count = static_cast<std::size_t>(std::popcount(cell.dots));
      grid.put(x + column, y + row, symbols == Symbols::Braille ? kBraille + cell.dots : kDensity[count], cell.style);
    }
  }
}

}  // namespace skein::monitor
