#include "groundstation/monitor/camera.hpp"

#include <algorithm>
#include <array>

namespace skein::monitor {
namespace {

constexpr std::array<std::string_view, 3> kNames{"x-y", "x-z", "y-z"};
constexpr double kMargin = 1.1;
constexpr double kLeastWidth_m = 10.0;

struct Bounds {
  std::optional<Box> box;

  void add(const Vec3& place_m) {
    if (!box) box = Box{place_m, place_m};
    box->min_m = box->min_m.cwiseMin(place_m);
    box->max_m = box->max_m.cwiseMax(place_m);
  }
};

}  // namespace

std::string_view name_of(Plane plane) {
  return kNames[static_cast<std::size_t>(plane)];
}

Vec2 on_plane(Plane plane, const Vec3& place_m) {
  if (plane == Plane::XY) return {place_m.x(), place_m.y()};
  return {plane == Plane::XZ ? place_m.x() : place_m.y(), place_m.z()};
}

std::optional<Box> bounds_of(const watch::SwarmView& view) {
  Bounds bounds;
  if (view.mission) {
    for (const VehicleSpec& vehicle : view.mission->vehicles) bounds.add(vehicle.start.position_m);
    if (view.mission->transit) {
      bounds.add(view.mission->transit->area.min_m);
      bounds.add(view.mission->transit->area.max_m);
    }
  }
  for (const watch::AgentView& agent : view.agents) {
    if (agent.goal_m) bounds.add(*agent.goal_m);
    if (!view.mission && agent.position_m) bounds.add(*agent.position_m);
    for (const Vec3& point_m : agent.planned_m) bounds.add(point_m);
  }
  return bounds.box;
}

Camera::Camera(Plane plane, const Box& bounds, const std::optional<Vec3>& centre_m, double zoom, int width, int height)
    : plane_(plane), centre_m_(centre_m.value_or((bounds.min_m + bounds.max_m) / 2.0)) {
  const Vec2 size_m = on_plane(plane, bounds.max_m) - on_plane(plane, bounds.min_m);
  const double columns = std::max(1, width);
  const double rows = std::max(1, height);
  dot_m_ = std::max({size_m.x() * kMargin / columns, size_m.y() * kMargin / rows, kLeastWidth_m / columns}) / zoom;
  const Vec2 middle_m = on_plane(plane, centre_m_);
  left_m_ = middle_m.x() - dot_m_ * columns / 2.0;
  top_m_ = middle_m.y() + dot_m_ * rows / 2.0;
}

}  // namespace skein::monitor
