#include "groundstation/monitor/screen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "groundstation/monitor/agent_table.hpp"
#include "groundstation/monitor/cost_panel.hpp"
#include "groundstation/monitor/map_panel.hpp"
#include "groundstation/watch/figures.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein::monitor {
namespace {

constexpr int kTableWidth = 43;  ///< of the narrow table, beside the map
constexpr int kLeastMap = 24;
constexpr std::string_view kKeys = " q leave  n p agent  f follow  v plane  +- zoom  arrows pan  t table  ? all keys";

constexpr std::array<std::string_view, 13> kHelp{
    "q        leave; the swarm does not notice",
    "n p      next, previous agent",
    "f        follow the selected agent",
    "v 1 2 3  next plane, x-y, x-z, y-z",
    "+ -      zoom",
    "arrows   pan",
    "0        all in the picture",
    "t        table of all figures, or map",
    "d w      plans (dotted), trails (full lines)",
    "z c l    zones, mapped cells, radio links",
    "?        this page, or not",
    "",
    "~ before a distance to go: as the crow flies",
};

const Style kBar{Colour::Default, false, false, true};
const Style kHeading{Colour::Default, true, false, false};

void draw_title(Grid& grid, const watch::SwarmView& view, const Surroundings& surroundings) {
  std::string text = fmt::format(" skein {}  ", surroundings.swarm);
  if (view.heard_tick) {
    text += fmt::format("{}  step {}  {:.1f} s  x{}  {} live", name_of(view.phase), view.step, view.time_s,
                        view.times_real_time ? fmt::format("{:.1f}", *view.times_real_time) : "-", view.live);
  } else {
    text += "no tick heard yet";
  }
  if (view.mission) text += fmt::format("  {}  seed {}", view.mission->name, view.mission->seed);
  text += fmt::format("  round {}", view.round);
  grid.fill(0, 0, grid.width(), U' ', kBar);
  grid.put(0, 0, text, kBar, grid.width());
}

Style style_of_event(const watch::Event& event) {
  using watch::EventKind;
  const bool bad = event.kind == EventKind::Collision || event.kind == EventKind::NearMiss ||
                   (event.kind == EventKind::Roster && event.what == "lost");
  if (bad) return {Colour::Red, true, false, false};
  if (event.kind == EventKind::Safety) return {Colour::Yellow, false, false, false};
  return event.agent == kWorldId ? kHeading : style_of(event.agent);
}

/// The newest at the bottom.
void draw_events(Grid& grid, const Area& area, const watch::SwarmView& view) {
  if (area.height < 1) return;
  grid.put(area.x, area.y, "events", kHeading, area.width);
  const auto count = static_cast<int>(view.events.size());
  const int rows = std::min(count, area.height - 1);
  for (int row = 0; row < rows; ++row) {
    const int index = count - rows + row;
    const watch::Event& event = view.events[static_cast<std::size_t>(index)];
    grid.put(area.x, area.y + 1 + row, watch::event_text(event), style_of_event(event), area.width - 1);
  }
}

void draw_help(Grid& grid, const Area& area) {
  for (std::size_t i = 0; i < kHelp.size() && static_cast<int>(i) < area.height; ++i) {
    grid.put(area.x + 1, area.y + static_cast<int>(i), kHelp[i], {}, area.width - 1);
  }
}

void draw_foot(Grid& grid, const watch::SwarmView& view, const Surroundings& surroundings) {
  const int y = grid.height() - 1;
  std::string text(kKeys);
  Style style = kBar;
  if (!surroundings.notice.empty()) text = " " + surroundings.notice;
  if (view.outcome) {
    text = fmt::format(" the run has ended ({}): {}; q leaves", view.outcome->exit_code, view.outcome->reason);
    style.bold = true;
  }
  grid.fill(0, y, grid.width(), U' ', style);
  grid.put(0, y, text, style, grid.width());
}

}  // namespace

Grid draw_screen(const watch::SwarmView& view, const Choices& choices, const Surroundings& surroundings, int width,
                 int height) {
  Grid grid(width, height);
  if (width < kLeastWidth || height < kLeastHeight) {
    grid.put(0, 0, fmt::format("at least {} x {}, please", kLeastWidth, kLeastHeight));
    grid.put(0, 1, "q leaves");
    return grid;
  }
  const int lower = std::max(4, (height - 2) / 4);
  const Area upper{0, 1, width, height - 2 - lower};
  const int below_y = upper.y + upper.height;
  const int right = std::clamp(width / 2 + 3, kTableWidth, std::max(kTableWidth, width - kLeastMap));
  const Area left_part{0, upper.y, width - right - 1, upper.height};
  const Area right_part{width - right, upper.y, right, upper.height};
  draw_title(grid, view, surroundings);
  if (choices.help) {
    draw_help(grid, upper);
  } else if (choices.table || left_part.width < kLeastMap) {
    draw_agents(grid, upper, view, choices);
  } else {
    draw_map(grid, left_part, view, choices, surroundings.symbols);
    draw_agents(grid, right_part, view, choices);
  }
  const int cost_width = std::min(width * 2 / 5, 44);
  draw_events(grid, {0, below_y, width - cost_width, lower}, view);
  draw_costs(grid, {width - cost_width, below_y, cost_width, lower}, view, choices, surroundings.symbols);
  draw_foot(grid, view, surroundings);
  return grid;
}

}  // namespace skein::monitor
