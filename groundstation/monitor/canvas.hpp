// Dots and lines on characters: each character holds 2 x 4 dots, as a Braille pattern or, without those, by density.
//
//   U+2800 + sum of bits: rows 0 to 2 of the left column 1, 2, 4, of the right one 8, 16, 32; row 3 64 and 128
// A character has one style, that of the last dot of the highest rank. Source: Unicode, block 'Braille Patterns'.
// Departs from source: none. Complexity: O(dots).
#pragma once

#include <cstdint>
#include <vector>

#include "groundstation/monitor/grid.hpp"

namespace skein::monitor {

enum class Symbols : std::uint8_t { Braille, Ascii };

/// A place in dots: x to the right, y down, (0, 0) the upper left corner.
struct Dot {
  double x = 0.0;
  double y = 0.0;
};

class Canvas {
 public:
  /// In characters.
  Canvas(int width, int height);

  [[nodiscard]] int width() const { return 2 * width_; }    ///< in dots
  [[nodiscard]] int height() const { return 4 * height_; }  ///< in dots
  void dot(int x, int y, const Style& style, int rank = 0);
  /// The part of the straight line that is on the canvas. @param every only each so-manieth dot: 1 is a full line
  /// @param phase how many dots went before @return the phase with which a line from `to` on continues
  int line(const Dot& from, const Dot& to, const Style& style, int rank = 0, int every = 1, int phase = 0);
  /// Copies what has dots to the grid, from (x, y) on.
  void draw(Grid& grid, int x, int y, Symbols symbols) const;

 private:
  struct Cell {
    std::uint8_t dots = 0;
    int rank = -1;
    Style style;
  };
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Cell> cells_;
};

}  // namespace skein::monitor
