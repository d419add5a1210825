#include "groundstation/monitor/screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/groundstation/monitor/views.hpp"

namespace skein::monitor {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Surroundings kGeese{"geese", Symbols::Braille, ""};

/// Rows of the table that begin with this agent's number.
bool has_row(const std::string& text, AgentId id) {
  return text.find(std::to_string(id) + " flying") != std::string::npos;
}

TEST(Screen, In80x24ItShowsTwelveAgentsMapEventsCostsAndKeys) {
  auto view = row_of(12);
  view.events = {{20.0, 40, 95, 3, watch::EventKind::Safety, "controlled", "peer"}};
  const Grid grid = draw_screen(view, {}, kGeese, 80, 24);
  EXPECT_EQ(grid.width(), 80);
  EXPECT_EQ(grid.height(), 24);
  const std::string text = grid.text();
  for (AgentId id = 1; id <= 12; ++id) EXPECT_TRUE(has_row(text, id)) << id << "\n" << text;
  EXPECT_THAT(grid.row(0), HasSubstr("skein geese  flying  step 40"));
  EXPECT_THAT(text, HasSubstr("20.0 s  agent 3 controlled: peer"));
  EXPECT_THAT(text, HasSubstr("agent 1: cost 2.5, gen 2"));
  EXPECT_THAT(grid.row(23), HasSubstr("q leave"));
  EXPECT_THAT(grid.row(23), HasSubstr("? all keys"));
  EXPECT_THAT(text, HasSubstr("x-y"));
}

TEST(Screen, TheMapHasVehiclesGoalsAndTrails) {
  const Grid grid = draw_screen(row_of(2), {}, {"geese", Symbols::Ascii, ""}, 80, 24);
  const std::string map = [&] {
    std::string all;
    for (int y = 1; y < 18; ++y) all += grid.row(y).substr(0, 36) + "\n";
    return all;
  }();
  EXPECT_THAT(map, HasSubstr("x"));
  EXPECT_THAT(map, HasSubstr("1"));
  EXPECT_THAT(map, HasSubstr("2"));
  EXPECT_THAT(map, HasSubstr("."));
}

TEST(Screen, WithoutBrailleItIsAscii) {
  const std::string text = draw_screen(row_of(12), {}, {"geese", Symbols::Ascii, ""}, 80, 24).text();
  EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

TEST(Screen, TheTableTakesThePlaceOfTheMapWithMoreColumns) {
  Choices choices;
  choices.table = true;
  const std::string text = draw_screen(row_of(12), choices, kGeese, 80, 24).text();
  for (const char* column : {"mode", "step", "m/s", "to go", "sep", "least", "cost", "gen", "B/s", "age", "late"}) {
    EXPECT_THAT(text, HasSubstr(column));
  }
  EXPECT_THAT(text, Not(HasSubstr("x-y")));
  EXPECT_THAT(text, Not(HasSubstr("tiles")));
}

TEST(Screen, WhereThereIsAMapTheTableHasItsTiles) {
  Choices choices;
  choices.table = true;
  auto view = row_of(12);
  view.cells.states = {CellState::Free};
  const std::string text = draw_screen(view, choices, kGeese, 80, 24).text();
  for (const char* column : {"mode", "step", "m/s", "to go", "least", "cost", "gen", "tiles", "B/s", "age", "late"}) {
    EXPECT_THAT(text, HasSubstr(column));
  }
}

TEST(Screen, InAWideTerminalMapAndAllColumnsAreThere) {
  const std::string text = draw_screen(row_of(12), {}, kGeese, 200, 50).text();
  for (const char* word : {"x-y", "sep", "B/s", "late", "safety"}) EXPECT_THAT(text, HasSubstr(word));
}

TEST(Screen, MoreAgentsThanRowsScrollWithTheSelectedOne) {
  Choices choices;
  choices.selected = 50;
  const std::string text = draw_screen(row_of(64), choices, kGeese, 80, 24).text();
  EXPECT_TRUE(has_row(text, 50)) << text;
  EXPECT_THAT(text, HasSubstr("> 50 flying"));
  EXPECT_THAT(text, HasSubstr("of 64, n and p go on"));
}

TEST(Screen, HelpNamesEveryKey) {
  Choices choices;
  choices.help = true;
  const std::string text = draw_screen(row_of(2), choices, kGeese, 80, 24).text();
  for (const char* word : {"leave", "follow", "plane", "zoom", "pan", "plans", "zones", "links"}) {
    EXPECT_THAT(text, HasSubstr(word));
  }
}

TEST(Screen, TheOutcomeIsAtTheFoot) {
  auto view = row_of(2);
  view.outcome = Outcome{4, "agent 2 was lost"};
  const Grid grid = draw_screen(view, {}, kGeese, 80, 24);
  EXPECT_THAT(grid.row(23), HasSubstr("the run has ended (4): agent 2 was lost"));
}

TEST(Screen, ANoticeTakesThePlaceOfTheKeys) {
  const Grid grid = draw_screen(row_of(2), {}, {"geese", Symbols::Braille, "no tick for 7 s"}, 80, 24);
  EXPECT_THAT(grid.row(23), HasSubstr("no tick for 7 s"));
}

TEST(Screen, EverySizeIsDrawn) {
  const auto view = row_of(5);
  for (const bool table : {false, true}) {
    Choices choices;
    choices.table = table;
    for (int width = 0; width <= 220; width += 11) {
      for (int height = 0; height <= 60; height += 3) {
        const Grid grid = draw_screen(view, choices, kGeese, width, height);
        ASSERT_EQ(grid.width(), width);
        ASSERT_EQ(grid.height(), height);
      }
    }
  }
  EXPECT_THAT(draw_screen(view, {}, kGeese, 39, 30).text(), HasSubstr("at least 40 x 12"));
}

TEST(Screen, BeforeAnythingIsHeardItSaysSo) {
  const std::string text = draw_screen({}, {}, kGeese, 80, 24).text();
  EXPECT_THAT(text, HasSubstr("no tick heard yet"));
  EXPECT_THAT(text, HasSubstr("no place is known yet"));
}

TEST(Screen, WhoIsLostOrUnheardIsCalledSo) {
  auto view = row_of(3);
  view.agents[0].live = false;
  view.agents[1].heard = false;
  const std::string text = draw_screen(view, {}, kGeese, 80, 24).text();
  EXPECT_THAT(text, HasSubstr(">  1 lost"));
  EXPECT_THAT(text, HasSubstr("   2 unheard"));
}

TEST(Screen, MappedCellsZonesAndLinksCanBeSwitchedOff) {
  auto view = row_of(2);
  view.agents[0].flown_m.clear();
  view.agents[1].flown_m.clear();
  view.cells.grid = CellGrid{{0.0, 0.0, 0.0}, 500.0, 500.0, 2, 2, 1};
  view.cells.states = {CellState::Occupied, CellState::Free, CellState::Unknown, CellState::Unknown};
  view.links = {{1, 2}};
  view.mission->zones = {{Cylinder{{400.0, 1500.0}, 100.0}, true},
                         {Box{{0.0, 1200.0, 0.0}, {100.0, 1300.0, 50.0}}, false}};
  Choices none;
  none.cells = none.links = none.zones = false;
  const Surroundings ascii{"geese", Symbols::Ascii, ""};
  const auto dots = [&](const Choices& choices) {
    const std::string text = draw_screen(view, choices, ascii, 80, 24).text();
    return std::ranges::count(text, '#') + std::ranges::count(text, ':') + std::ranges::count(text, '+');
  };
  EXPECT_LT(dots(none), dots({}));
  for (bool Choices::*what : {&Choices::cells, &Choices::links, &Choices::zones}) {
    Choices without;
    without.*what = false;
    EXPECT_NE(draw_screen(view, without, ascii, 80, 24).text(), draw_screen(view, {}, ascii, 80, 24).text());
  }
}

}  // namespace
}  // namespace skein::monitor
