#include "groundstation/monitor/agent_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "groundstation/monitor/map_panel.hpp"
#include "planner/core/lockstep/names.hpp"

namespace skein::monitor {
namespace {

using watch::AgentView;

struct Column {
  std::string_view title;
  int width;
  int rank;  ///< the lower, the sooner it gets room
  std::string (*text)(const AgentView&);
};

/// A number in at most six characters.
std::string number(double value) {
  if (value >= 99999.5) return fmt::format("{:.0e}", value);
  return fmt::format("{:.{}f}", value, value < 99.95 ? 2 : value < 9999.5 ? 1 : 0);
}

std::string number(const std::optional<double>& value) {
  return value ? number(*value) : "-";
}

std::string mode_text(const AgentView& agent) {
  if (!agent.heard) return "unheard";
  if (!agent.live && agent.incarnation > 0) return "lost";
  if (agent.mode == AgentMode::Unreachable) return "no way";
  if (agent.mode == AgentMode::Replanning) return "replan";
  return std::string(name_of(agent.mode));
}

std::string safety_text(const AgentView& agent) {
  if (agent.safety_mode == SafetyMode::Autonomous) return "";
  return fmt::format("{} {}", agent.safety_mode == SafetyMode::Hold ? "hold" : "ctrl", name_of(agent.safety_reason));
}

std::string to_go_text(const AgentView& agent) {
  const bool straight = agent.to_go_by == watch::ToGoBy::Straight && agent.to_go_m;
  return fmt::format("{}{}", straight ? "~" : "", number(agent.to_go_m));
}

constexpr int kSeparation = 9;
constexpr int kTiles = 7;  ///< only where there is a map

const std::array<Column, 13> kColumns{{
    {"mode", 8, 0, mode_text},
    {"step", 6, 6, [](const AgentView& a) { return std::to_string(a.step); }},
    {"m/s", 6, 1, [](const AgentView& a) { return number(a.speed_mps); }},
    {"to go", 7, 2, to_go_text},
    {"sep", 6, kSeparation, [](const AgentView& a) { return number(a.separation_m); }},
    {"least", 6, 3, [](const AgentView& a) { return number(a.min_separation_m); }},
    {"cost", 7, 5, [](const AgentView& a) { return number(a.cost); }},
    {"gen", 4, 5, [](const AgentView& a) { return std::to_string(a.generation); }},
    {"tiles", 5, kTiles, [](const AgentView& a) { return std::to_string(a.map_tiles); }},
    {"B/s", 6, 8, [](const AgentView& a) { return number(a.rate.bytes_per_s); }},
    {"age", 5, 4, [](const AgentView& a) { return a.age_s ? fmt::format("{:.1f}", *a.age_s) : std::string("-"); }},
    {"late", 4, 8, [](const AgentView& a) { return std::to_string(a.late_steps); }},
    {"safety", 13, 10, safety_text},
}};
constexpr int kIdWidth = 4;

/// Those for which there is room, in the order of the table.
std::vector<const Column*> chosen(int width, bool has_map) {
  std::vector<const Column*> by_rank;
  for (const Column& column : kColumns) {
    if (has_map || column.rank != kTiles) by_rank.push_back(&column);
  }
  std::ranges::stable_sort(by_rank, {}, &Column::rank);
  int left = width - kIdWidth;
  std::vector<const Column*> columns;
  for (const Column* column : by_rank) {
    if (column->width + 1 > left) continue;
    left -= column->width + 1;
    columns.push_back(column);
  }
  std::ranges::sort(columns);
  return columns;
}

void draw_row(Grid& grid, const Area& area, int y, const AgentView& agent, bool selected,
              std::span<const Column* const> columns) {
  Style style = style_of(agent.id);
  style.dim = !agent.live;
  style.reverse = selected;
  if (selected) grid.fill(area.x, y, area.width, U' ', style);
  grid.put(area.x, y, fmt::format("{}{:>3}", selected ? ">" : " ", agent.id), style);
  int x = area.x + kIdWidth;
  for (const Column* column : columns) {
    const std::string text = agent.heard || column->rank <= 2 ? column->text(agent) : "-";
    const int start = x + 1 + std::max(0, column->width - static_cast<int>(text.size()));
    const bool left_aligned = column->rank == 0 || column->rank == 10;
    grid.put(left_aligned ? x + 1 : start, y, text, style, column->width);
    x += column->width + 1;
  }
}

}  // namespace

void draw_agents(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices) {
  if (area.height < 2) return;
  const std::vector<const Column*> columns = chosen(area.width, !view.cells.states.empty());
  const Style heading{Colour::Default, true, false, false};
  grid.put(area.x + 2, area.y, "id", heading);
  int x = area.x + kIdWidth;
  for (const Column* column : columns) {
    const bool left_aligned = column->rank == 0 || column->rank == 10;
    grid.put(left_aligned ? x + 1 : x + 1 + column->width - static_cast<int>(column->title.size()), area.y,
             column->title, heading);
    x += column->width + 1;
  }
  const auto count = static_cast<int>(view.agents.size());
  const AgentView* selected = selected_agent(choices, view);
  const bool all = count < area.height;
  const int rows = all ? count : area.height - 2;  // the last row says how many more there are
  if (rows <= 0) return;
  const int place = selected == nullptr ? 0 : static_cast<int>(selected - view.agents.data());
  const int first = std::clamp(place - rows / 2, 0, std::max(0, count - rows));
  for (int row = 0; row < std::min(rows, count); ++row) {
    const int index = first + row;
    const AgentView& agent = view.agents[static_cast<std::size_t>(index)];
    draw_row(grid, area, area.y + 1 + row, agent, &agent == selected, columns);
  }
  if (!all) {
    grid.put(area.x + 2, area.y + area.height - 1, fmt::format("{} of {}, n and p go on", rows, count),
             {Colour::Default, false, true, false}, area.width - 2);
  }
}

}  // namespace skein::monitor
