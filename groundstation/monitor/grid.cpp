#include "groundstation/monitor/grid.hpp"

#include <algorithm>

namespace skein::monitor {

Grid::Grid(int width, int height)
    : width_(std::max(0, width)),
      height_(std::max(0, height)),
      glyphs_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

void Grid::put(int x, int y, char32_t symbol, const Style& style) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  glyphs_[place(x, y)] = {symbol, style};
}

void Grid::put(int x, int y, std::string_view text, const Style& style, int limit) {
  int column = x;
  for (const char c : text) {
    if (limit >= 0 && column - x >= limit) return;
    const bool printable = c >= ' ' && c <= '~';
    put(column++, y, printable ? static_cast<char32_t>(c) : U'?', style);
  }
}

void Grid::fill(int x, int y, int width, char32_t symbol, const Style& style) {
  for (int column = x; column < x + width; ++column) put(column, y, symbol, style);
}

std::string Grid::row(int y) const {
  std::string text;
  std::size_t used = 0;
  for (int x = 0; x < width_; ++x) {
    text += utf8(at(x, y).symbol);
    if (at(x, y).symbol != U' ') used = text.size();
  }
  text.resize(used);
  return text;
}

std::string Grid::text() const {
  std::string all;
  for (int y = 0; y < height_; ++y) all += row(y) + "\n";
  return all;
}

std::string utf8(char32_t symbol) {
  const auto code = static_cast<std::uint32_t>(symbol);
  const auto byte = [](std::uint32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0U | (code >> 6U)), byte(0x80U | (code & 0x3FU))};
  return {byte(0xE0U | ((code >> 12U) & 0xFU)), byte(0x80U | ((code >> 6U) & 0x3FU)), byte(0x80U | (code & 0x3FU))};
}

}  // namespace skein::monitor
