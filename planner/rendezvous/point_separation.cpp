#include "planner/rendezvous/point_separation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {

template <typename Space>
std::vector<PointSeparation> point_separations(const ProblemIn<Space>& problem, std::span<const PlannedPath> paths) {
  std::vector<std::vector<typename Space::Vec>> points_m;
  for (const PlannedPath& path : paths) {
    const std::optional<ph::Controls> controls = controls_of<Space>(path.particle);
    if (!controls) throw std::invalid_argument("a planned path has not the numbers of 1 to 4 segments");
    points_m.emplace_back(static_cast<std::size_t>(problem.options.check_points));
    const typename Space::Hermite& hermite = participant_of(problem, path.agent).hermite;
    equidistant_points(hermite.path(*controls), points_m.back());
  }
  std::vector<PointSeparation> separations;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t j = i + 1; j < paths.size(); ++j) {
      double least_squared = (points_m[i][0] - points_m[j][0]).squaredNorm();
      for (std::size_t k = 1; k < points_m[i].size(); ++k) {
        least_squared = std::min(least_squared, (points_m[i][k] - points_m[j][k]).squaredNorm());
      }
      separations.push_back(
          {paths[i].agent, paths[j].agent, std::sqrt(least_squared),
           required_separation_m(participant_of(problem, paths[i].agent), participant_of(problem, paths[j].agent))});
    }
  }
  return separations;
}

template std::vector<PointSeparation> point_separations(const ProblemIn<Planar>&, std::span<const PlannedPath>);
template std::vector<PointSeparation> point_separations(const ProblemIn<Spatial>&, std::span<const PlannedPath>);

std::vector<PointSeparation> point_separations(const Mission& mission, std::span<const PlannedPath> paths) {
  if (mission.vehicles.empty()) throw std::invalid_argument("rendezvous: the mission has no vehicles");
  const AgentId any = mission.vehicles.front().id;
  if (is_planar(mission)) return point_separations(make_problem<Planar>(mission, any), paths);
  return point_separations(make_problem<Spatial>(mission, any), paths);
}

}  // namespace skein::rendezvous
