#include "groundstation/watch/planned_path.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "planner/rendezvous/path_profile.hpp"

namespace skein::watch {
namespace {

constexpr std::size_t kPoints = 65;

}  // namespace

std::vector<Vec3> planned_line(const Mission& mission, AgentId agent, std::span<const double> particle,
                               const std::optional<Pose>& from) {
  std::vector<Vec3> line_m;
  if (mission.kind != MissionKind::Rendezvous || particle.empty()) return line_m;
  try {
    Mission own = mission;
    if (from) {
      const auto vehicle = std::ranges::find(own.vehicles, agent, &VehicleSpec::id);
      if (vehicle == own.vehicles.end()) return line_m;
      vehicle->start = *from;
    }
    for (const auto& point : rendezvous::path_profile(own, {agent, {particle.begin(), particle.end()}}, kPoints)) {
      line_m.push_back(point.position_m);
    }
  } catch (const std::invalid_argument&) {
    line_m.clear();  // it passed the checks of the wire, and is the path of nothing
  }
  return line_m;
}

std::vector<Vec3> intended_line(const Mission& mission, const Intent& intent, const Vec3& position_m) {
  std::vector<Vec3> line_m{position_m, intent.to_m};
  if (!mission.transit) return line_m;
  const CellGrid grid = grid_of(*mission.transit);
  for (const CellIndex cell : intent.next_cells) {
    if (cell < grid.size()) line_m.push_back(grid.centre_m(grid.cell_at(cell)));
  }
  return line_m;
}

double left_m(std::span<const Vec3> line_m, const Vec3& position_m) {
  double least_m = std::numeric_limits<double>::infinity();
  double from_start_m = 0.0;
  double at_m = 0.0;
  for (std::size_t i = 0; i + 1 < line_m.size(); ++i) {
    const Vec3 way = line_m[i + 1] - line_m[i];
    const double length_m = way.norm();
    const double part =
        length_m > 0.0 ? std::clamp((position_m - line_m[i]).dot(way) / (length_m * length_m), 0.0, 1.0) : 0.0;
    const double distance_m = (line_m[i] + part * way - position_m).norm();
    if (distance_m < least_m) {
      least_m = distance_m;
      at_m = from_start_m + part * length_m;
    }
    from_start_m += length_m;
  }
  return from_start_m - at_m;
}

}  // namespace skein::watch
