#include "groundstation/monitor/cost_panel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "groundstation/monitor/map_panel.hpp"
#include "planner/core/math/det_math.hpp"

namespace skein::monitor {
namespace {

constexpr double kDecades = 100.0;  ///< from least to largest, over which the scale is logarithmic

std::string cost_text(double cost) {
  return cost < 1e5 ? fmt::format("{:.6g}", cost) : fmt::format("{:.2e}", cost);
}

}  // namespace

void draw_costs(Grid& grid, const Area& area, const watch::SwarmView& view, const Choices& choices, Symbols symbols) {
  const watch::AgentView* agent = selected_agent(choices, view);
  if (agent == nullptr || area.height < 2) return;
  const std::vector<watch::CostPoint>& costs = agent->costs;
  const Style heading{Colour::Default, true, false, false};
  if (costs.empty()) {
    grid.put(area.x, area.y, fmt::format("agent {}: no search seen", agent->id), heading, area.width);
    return;
  }
  const auto [least, largest] = std::ranges::minmax(costs, {}, &watch::CostPoint::cost);
  const bool logarithmic = largest.cost > kDecades * least.cost;
  grid.put(area.x, area.y,
           fmt::format("agent {}: cost {}, gen {}", agent->id, cost_text(costs.back().cost), costs.back().generation),
           heading, area.width);
  const Area plot{area.x, area.y + 1, area.width, area.height - 1};
  const auto height_of = [&](double cost) { return logarithmic ? math::log(cost) : cost; };
  const double low = height_of(least.cost);
  const double span = std::max(height_of(largest.cost) - low, 1e-12);
  const double first = costs.front().generation;
  const double generations = std::max(1.0, costs.back().generation - first);
  Canvas canvas(plot.width, plot.height);
  const auto dot_of = [&](const watch::CostPoint& point) {
    return Dot{(point.generation - first) / generations * (canvas.width() - 1),
               (1.0 - (height_of(point.cost) - low) / span) * (canvas.height() - 1)};
  };
  for (std::size_t i = 0; i + 1 < costs.size(); ++i) {
    canvas.line(dot_of(costs[i]), dot_of(costs[i + 1]), style_of(agent->id));
  }
  canvas.draw(grid, plot.x, plot.y, symbols);
  const std::string top = cost_text(largest.cost) + (logarithmic ? " log" : "");
  grid.put(plot.x + plot.width - static_cast<int>(top.size()), plot.y, top);
}

}  // namespace skein::monitor
