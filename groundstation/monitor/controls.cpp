#include "groundstation/monitor/controls.hpp"

#include <algorithm>

namespace skein::monitor {
namespace {

constexpr double kZoomStep = 1.5;
constexpr double kMaxZoom = 1e4;
constexpr double kMinZoom = 0.1;
constexpr double kPan = 0.125;  ///< of what the bounds span, at zoom 1

void select(Choices& choices, const watch::SwarmView& view, int way) {
  const watch::AgentView* now = selected_agent(choices, view);
  if (now == nullptr) return;
  const auto count = static_cast<std::ptrdiff_t>(view.agents.size());
  const std::ptrdiff_t place = now - view.agents.data();
  choices.selected = view.agents[static_cast<std::size_t>((place + way + count) % count)].id;
}

void pan(Choices& choices, const watch::SwarmView& view, Special way) {
  const std::optional<Box> bounds = bounds_of(view);
  if (!bounds) return;
  const Vec3 span_m = bounds->max_m - bounds->min_m;
  const double step_m = std::max({span_m.x(), span_m.y(), span_m.z(), 1.0}) * kPan / choices.zoom;
  Vec3 centre_m = centre_of(choices, view).value_or((bounds->min_m + bounds->max_m) / 2.0);
  const auto u = choices.plane == Plane::YZ ? 1 : 0;
  const auto v = choices.plane == Plane::XY ? 1 : 2;
  if (way == Special::Left) centre_m[u] -= step_m;
  if (way == Special::Right) centre_m[u] += step_m;
  if (way == Special::Down) centre_m[v] -= step_m;
  if (way == Special::Up) centre_m[v] += step_m;
  choices.centre_m = centre_m;
  choices.follow = false;
}

void zoom(Choices& choices, double factor) {
  choices.zoom = std::clamp(choices.zoom * factor, kMinZoom, kMaxZoom);
}

Plane next(Plane plane) {
  return plane == Plane::XY ? Plane::XZ : plane == Plane::XZ ? Plane::YZ : Plane::XY;
}

bool turn_switch(Choices& choices, char key) {
  bool* switched = key == 'f'   ? &choices.follow
                   : key == 't' ? &choices.table
                   : key == '?' ? &choices.help
                   : key == 'd' ? &choices.plans
                   : key == 'w' ? &choices.trails
                   : key == 'z' ? &choices.zones
                   : key == 'c' ? &choices.cells
                   : key == 'l' ? &choices.links
                                : nullptr;
  if (switched == nullptr) return false;
  *switched = !*switched;
  return true;
}

}  // namespace

const watch::AgentView* selected_agent(const Choices& choices, const watch::SwarmView& view) {
  if (view.agents.empty()) return nullptr;
  const auto found = std::ranges::find(view.agents, choices.selected, &watch::AgentView::id);
  return found == view.agents.end() ? &view.agents.front() : &*found;
}

std::optional<Vec3> centre_of(const Choices& choices, const watch::SwarmView& view) {
  if (choices.follow) {
    const watch::AgentView* agent = selected_agent(choices, view);
    if (agent != nullptr && agent->position_m) return agent->position_m;
  }
  return choices.centre_m;
}

Choices after_key(Choices choices, const Key& key, const watch::SwarmView& view) {
  if (key.special != Special::None) {
    pan(choices, view, key.special);
    return choices;
  }
  if (turn_switch(choices, key.character)) return choices;
  switch (key.character) {
    case 'q':
      choices.quit = true;
      break;
    case 'n':
      select(choices, view, 1);
      break;
    case 'p':
      select(choices, view, -1);
      break;
    case 'v':
      choices.plane = next(choices.plane);
      break;
    case '1':
      choices.plane = Plane::XY;
      break;
    case '2':
      choices.plane = Plane::XZ;
      break;
    case '3':
      choices.plane = Plane::YZ;
      break;
    case '+':
    case '=':
      zoom(choices, kZoomStep);
      break;
    case '-':
      zoom(choices, 1.0 / kZoomStep);
      break;
    case '0':
      choices.zoom = 1.0;
      choices.centre_m.reset();
      choices.follow = false;
      break;
    default:
      break;
  }
  return choices;
}

}  // namespace skein::monitor
