#include "groundstation/monitor/map_panel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/core/math/det_math.hpp"

namespace skein::monitor {
namespace {

constexpr std::array<Colour, 6> kColours{Colour::Green, Colour::Cyan,    Colour::Yellow,
                                         Colour::Blue,  Colour::Magenta, Colour::Red};
constexpr int kCorners = 48;
constexpr int kDotted = 3;
constexpr int kSparse = 6;
// ranks: what lies above
constexpr int kCells = 0;
constexpr int kLinks = 1;
constexpr int kZones = 2;
constexpr int kPlans = 3;
constexpr int kTrails = 4;

const Style kDim{Colour::Default, false, true, false};
const Style kForbidden{Colour::Red, false, false, false};
const Style kExpected{Colour::Yellow, false, false, false};

void draw_line(Canvas& canvas, const Camera& camera, std::span<const Vec3> line_m, const Style& style, int rank,
               int every) {
  int phase = 0;
  for (std::size_t i = 0; i + 1 < line_m.size(); ++i) {
    phase = canvas.line(camera.dot_of(line_m[i]), camera.dot_of(line_m[i + 1]), style, rank, every, phase);
  }
}

void draw_outline(Canvas& canvas, const Camera& camera, const Box& box, const Style& style, int every) {
  const Vec2 low_m = on_plane(camera.plane(), box.min_m);
  const Vec2 high_m = on_plane(camera.plane(), box.max_m);
  const std::array<Vec2, 5> corners{low_m, Vec2{high_m.x(), low_m.y()}, high_m, Vec2{low_m.x(), high_m.y()}, low_m};
  int phase = 0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    phase = canvas.line(camera.dot_of(corners[i]), camera.dot_of(corners[i + 1]), style, kZones, every, phase);
  }
}

void draw_outline(Canvas& canvas, const Camera& camera, const Cylinder& cylinder, const Style& style, int every) {
  const Vec2& c = cylinder.centre_m;
  const double r = cylinder.radius_m;
  if (camera.plane() != Plane::XY) {
    const Box side{{c.x() - r, c.y() - r, cylinder.z_min_m}, {c.x() + r, c.y() + r, cylinder.z_max_m}};
    return draw_outline(canvas, camera, side, style, every);
  }
  const auto corner = [&](int k) {
    const double angle_rad = math::kTwoPi * k / kCorners;
    return Vec2(c.x() + r * math::cos(angle_rad), c.y() + r * math::sin(angle_rad));
  };
  int phase = 0;
  for (int k = 0; k < kCorners; ++k) {
    phase = canvas.line(camera.dot_of(corner(k)), camera.dot_of(corner(k + 1)), style, kZones, every, phase);
  }
}

void draw_zones(Canvas& canvas, const Camera& camera, const Mission& mission) {
  for (const Zone& zone : mission.zones) {
    std::visit(
        [&](const auto& shape) {
          draw_outline(canvas, camera, shape, zone.no_fly ? kForbidden : Style{}, zone.no_fly ? 2 : 1);
        },
        zone.shape);
  }
  for (const Announcement& announcement : mission.announced) {
    std::visit([&](const auto& shape) { draw_outline(canvas, camera, shape, kExpected, kDotted); }, announcement.shape);
  }
  if (mission.transit) draw_outline(canvas, camera, mission.transit->area, kDim, kDotted);
}

/// Every dot that a known cell covers, cells nearer than a dot among them.
void draw_cells(Canvas& canvas, const Camera& camera, const watch::MappedCells& cells) {
  for (std::size_t n = 0; n < cells.states.size(); ++n) {
    if (cells.states[n] == CellState::Unknown) continue;
    const bool occupied = cells.states[n] == CellState::Occupied;
    const Box box = cells.grid.box_of(cells.grid.cell_at(static_cast<CellIndex>(n)));
    const Dot low = camera.dot_of(box.min_m);
    const Dot high = camera.dot_of(box.max_m);
    const auto within = [](double x, int size) {
      return static_cast<int>(std::clamp(std::floor(x), -1.0, size + 0.0));
    };
    for (int y = within(high.y, canvas.height()); y <= within(low.y - 1e-9, canvas.height()); ++y) {
      for (int x = within(low.x, canvas.width()); x <= within(high.x - 1e-9, canvas.width()); ++x) {
        if (occupied || (x % kSparse == 0 && y % kSparse == 0)) canvas.dot(x, y, occupied ? Style{} : kDim, kCells);
      }
    }
  }
}

void draw_links(Canvas& canvas, const Camera& camera, const watch::SwarmView& view) {
  for (const auto& [a, b] : view.links) {
    const auto from = std::ranges::find(view.agents, a, &watch::AgentView::id);
    const auto to = std::ranges::find(view.agents, b, &watch::AgentView::id);
    canvas.line(camera.dot_of(*from->position_m), camera.dot_of(*to->position_m), kDim, kLinks, kDotted);
  }
}

void put_marks(Grid& grid, const Area& area, const Camera& camera, const watch::SwarmView& view,
               const Choices& choices) {
  const auto put = [&](const Vec3& place_m, const std::string& mark, const Style& style) {
    const Dot dot = camera.dot_of(place_m);
    const double x = std::floor(dot.x / 2.0);
    const double y = std::floor(dot.y / 4.0);
    if (x < 0.0 || y < 0.0 || x >= area.width || y >= area.height) return;
    const int column = static_cast<int>(x);
    grid.put(area.x + column, area.y + static_cast<int>(y), mark, style, area.width - column);
  };
  const watch::AgentView* selected = selected_agent(choices, view);
  for (const watch::AgentView& agent : view.agents) {
    if (agent.goal_m) put(*agent.goal_m, "x", style_of(agent.id));
  }
  for (const watch::AgentView& agent : view.agents) {
    if (!agent.position_m) continue;
    Style style = style_of(agent.id);
    style.bold = true;
    style.reverse = &agent == selected;
    put(*agent.position_m, std::to_string(agent.id), style);
  }
  if (selected != nullptr && selected->position_m) {  // on top of who is at the same place
    Style style = style_of(selected->id);
    style.bold = style.reverse = true;
    put(*selected->position_m, std::to_string(selected->id), style);
  }
}

std::string length_text(double length_m) {
  return length_m >= 1000.0 ? fmt::format("{:.3g} km", length_m / 1000.0) : fmt::format("{:.3g} m", length_m);
}

}  // namespace

Style style_of(AgentId agent) {
  return {kColours[agent % kColours.size()], false, false, false};
}

void draw_map(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices, Symbols symbols) {
  const std::optional<Box> bounds = bounds_of(view);
  if (!bounds) {
    grid.put(area.x + 1, area.y + area.height / 2, "no place is known yet", kDim, area.width - 1);
    return;
  }
  Canvas canvas(area.width, area.height);
  const Camera camera(choices.plane, *bounds, centre_of(choices, view), choices.zoom, canvas.width(), canvas.height());
  if (choices.cells) draw_cells(canvas, camera, view.cells);
  if (choices.links) draw_links(canvas, camera, view);
  if (choices.zones && view.mission) draw_zones(canvas, camera, *view.mission);
  for (const watch::AgentView& agent : view.agents) {
    if (choices.plans) draw_line(canvas, camera, agent.planned_m, style_of(agent.id), kPlans, kDotted);
  }
  for (const watch::AgentView& agent : view.agents) {
    if (choices.trails) draw_line(canvas, camera, agent.flown_m, style_of(agent.id), kTrails, 1);
  }
  canvas.draw(grid, area.x, area.y, symbols);
  put_marks(grid, area, camera, view, choices);
  grid.put(area.x, area.y + area.height - 1,
           fmt::format("{}  {} wide{}", name_of(choices.plane), length_text(camera.dot_m() * canvas.width()),
                       choices.follow ? "  following" : ""),
           kDim, area.width);
}

}  // namespace skein::monitor
