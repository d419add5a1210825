#include "groundstation/monitor/grid.hpp"

#include <gtest/gtest.h>

namespace skein::monitor {
namespace {

TEST(Grid, HoldsWhatIsPutAndCutsTheRest) {
  Grid grid(5, 2);
  grid.put(3, 0, "abc");
  grid.put(-1, 1, "xy");
  grid.put(0, 7, "nowhere");
  EXPECT_EQ(grid.text(), "   ab\ny\n");
}

TEST(Grid, TextsHaveALimit) {
  Grid grid(8, 1);
  grid.put(0, 0, "abcdef", {}, 3);
  EXPECT_EQ(grid.row(0), "abc");
}

TEST(Grid, ControlCharactersDoNotReachATerminal) {
  Grid grid(4, 1);
  grid.put(0, 0, "a\x1b[\x80");
  EXPECT_EQ(grid.row(0), "a?[?");
}

TEST(Grid, StylesStayWithTheirCharacters) {
  Grid grid(3, 1);
  const Style bold{Colour::Red, true, false, false};
  grid.put(1, 0, "b", bold);
  EXPECT_EQ(grid.at(1, 0).style, bold);
  EXPECT_EQ(grid.at(0, 0).style, Style{});
}

TEST(Grid, WritesUtf8) {
  EXPECT_EQ(utf8(U'a'), "a");
  EXPECT_EQ(utf8(U'\u00e9'), "\xc3\xa9");
  EXPECT_EQ(utf8(U'\u28ff'), "\xe2\xa3\xbf");
}

TEST(Grid, NegativeSizesAreEmpty) {
  EXPECT_EQ(Grid(-3, 2).text(), "\n\n");
}

}  // namespace
}  // namespace skein::monitor
