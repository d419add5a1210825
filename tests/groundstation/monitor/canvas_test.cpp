#include "groundstation/monitor/canvas.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace skein::monitor {
namespace {

char32_t drawn(const Canvas& canvas, int x, int y, Symbols symbols = Symbols::Braille) {
  Grid grid(canvas.width() / 2, canvas.height() / 4);
  canvas.draw(grid, 0, 0, symbols);
  return grid.at(x, y).symbol;
}

TEST(Canvas, EachDotHasItsBit) {
  constexpr int kBits[4][2] = {{1, 8}, {2, 16}, {4, 32}, {64, 128}};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 2; ++x) {
      Canvas canvas(1, 1);
      canvas.dot(x, y, {});
      EXPECT_EQ(drawn(canvas, 0, 0), static_cast<char32_t>(0x2800 + kBits[y][x]));
    }
  }
}

TEST(Canvas, WithoutBrailleDensityTells) {
  Canvas canvas(2, 1);
  canvas.dot(0, 0, {});
  for (int y = 0; y < 4; ++y) {
    canvas.dot(2, y, {});
    canvas.dot(3, y, {});
  }
  EXPECT_EQ(drawn(canvas, 0, 0, Symbols::Ascii), U'.');
  EXPECT_EQ(drawn(canvas, 1, 0, Symbols::Ascii), U'#');
}

TEST(Canvas, AStraightLineHasNoHoles) {
  Canvas canvas(4, 2);
  canvas.line({0.5, 0.5}, {7.5, 7.5}, {});
  Grid grid(4, 2);
  canvas.draw(grid, 0, 0, Symbols::Braille);
  EXPECT_EQ(grid.at(0, 0).symbol, char32_t{0x2800 + 1 + 16});
  EXPECT_EQ(grid.at(1, 0).symbol, char32_t{0x2800 + 4 + 128});
  EXPECT_EQ(grid.at(3, 1).symbol, char32_t{0x2800 + 4 + 128});
}

TEST(Canvas, ADottedLineStaysDottedAcrossItsCorners) {
  Canvas canvas(4, 1);
  int phase = 0;
  for (int x = 0; x < 7; ++x) phase = canvas.line({x + 0.5, 0.5}, {x + 1.5, 0.5}, {}, 0, 3, phase);
  EXPECT_EQ(phase, 7);
  Grid grid(4, 1);
  canvas.draw(grid, 0, 0, Symbols::Braille);
  EXPECT_EQ(grid.at(0, 0).symbol, char32_t{0x2800 + 1});  // dots 0, 3 and 6
  EXPECT_EQ(grid.at(1, 0).symbol, char32_t{0x2800 + 8});
  EXPECT_EQ(grid.at(2, 0).symbol, U' ');
  EXPECT_EQ(grid.at(3, 0).symbol, char32_t{0x2800 + 1});
}

TEST(Canvas, OfALineFarBeyondOnlyThePartInsideIsDrawn) {
  Canvas canvas(4, 1);
  canvas.line({-1e12, 2.0}, {1e12, 2.0}, {});
  for (int x = 0; x < 4; ++x) EXPECT_EQ(drawn(canvas, x, 0), char32_t{0x2800 + 4 + 32}) << x;
  Canvas empty(4, 1);
  empty.line({-5.0, -5.0}, {-1.0, 9.0}, {});
  empty.line({0.0, 0.0}, {std::numeric_limits<double>::infinity(), 0.0}, {});
  EXPECT_EQ(drawn(empty, 0, 0), U' ');
}

TEST(Canvas, TheHighestRankGivesTheStyle) {
  const Style red{Colour::Red, false, false, false};
  const Style blue{Colour::Blue, false, false, false};
  Canvas canvas(1, 1);
  canvas.dot(0, 0, red, 2);
  canvas.dot(1, 1, blue, 1);
  Grid grid(1, 1);
  canvas.draw(grid, 0, 0, Symbols::Braille);
  EXPECT_EQ(grid.at(0, 0).style, red);
  EXPECT_EQ(grid.at(0, 0).symbol, char32_t{0x2800 + 1 + 16});
}

TEST(Canvas, LeavesAloneWhatHasNoDots) {
  Grid grid(2, 1);
  grid.put(0, 0, "a");
  Canvas canvas(2, 1);
  canvas.dot(3, 0, {});
  canvas.draw(grid, 0, 0, Symbols::Ascii);
  EXPECT_EQ(grid.row(0), "a.");
}

}  // namespace
}  // namespace skein::monitor
