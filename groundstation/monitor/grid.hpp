// A screen of characters with attributes, as plain values: what is drawn is decided here, a terminal only copies it.
//
// Column 0, row 0 is the upper left. Whatever is put outside is cut off. Source: none needed. Departs from source:
// none. Complexity: O(characters).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace skein::monitor {

enum class Colour : std::uint8_t { Default = 0, Red, Green, Yellow, Blue, Magenta, Cyan };

/// Nothing is told by the colour alone: not every terminal has any.
struct Style {
  Colour colour = Colour::Default;
  bool bold = false;
  bool dim = false;
  bool reverse = false;

  bool operator==(const Style&) const = default;
};

struct Glyph {
  char32_t symbol = U' ';
  Style style;

  bool operator==(const Glyph&) const = default;
};

/// A part of a screen.
struct Area {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

class Grid {
 public:
  /// Negative sizes count as 0.
  Grid(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// @pre inside
  [[nodiscard]] const Glyph& at(int x, int y) const { return glyphs_[place(x, y)]; }
  void put(int x, int y, char32_t symbol, const Style& style = {});
  /// ASCII text; other bytes become '?'. @param limit columns at most; negative: to the edge
  void put(int x, int y, std::string_view text, const Style& style = {}, int limit = -1);
  /// Fills a row from x on, as far as `width` columns.
  void fill(int x, int y, int width, char32_t symbol, const Style& style);
  /// A row as UTF-8, without the blanks at its end.
  [[nodiscard]] std::string row(int y) const;
  /// All rows, each ended by a newline.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Glyph> glyphs_;
};

/// The bytes of a character.
[[nodiscard]] std::string utf8(char32_t symbol);

}  // namespace skein::monitor
