#include "planner/rendezvous/path_profile.hpp"

#include <stdexcept>

#include "planner/rendezvous/cost/coordinates.hpp"

namespace skein::rendezvous {
namespace {

template <typename Space>
std::vector<ProfilePoint> profile_in(const Mission& mission, const PlannedPath& plan, std::size_t points) {
  const ProblemIn<Space> problem = make_problem<Space>(mission, plan.agent);
  const std::optional<ph::Controls> controls = controls_of<Space>(plan.particle);
  if (!controls) throw std::invalid_argument("a planned path has not the numbers of 1 to 4 segments");
  const typename Space::Path path = problem.own().hermite.path(*controls);
  std::vector<ProfilePoint> profile(points);
  for (std::size_t k = 0; k < points; ++k) {
    ProfilePoint& point = profile[k];
    point.arc_m = path.length_m() * static_cast<double>(k) / static_cast<double>(points - 1);
    point.curvature_per_m = path.curvature_at(point.arc_m);
    if constexpr (Space::kSpatial) {
      point.position_m = path.position_at(point.arc_m);
      point.torsion_per_m = path.torsion(path.parameter_at(point.arc_m));
    } else {
      const Vec2 place_m = path.position_at(point.arc_m);
      point.position_m = {place_m.x(), place_m.y(), problem.own().altitude_m};
    }
  }
  return profile;
}

}  // namespace

std::vector<ProfilePoint> path_profile(const Mission& mission, const PlannedPath& path, std::size_t points) {
  if (points < 2) throw std::invalid_argument("a profile has at least two points");
  return is_planar(mission) ? profile_in<Planar>(mission, path, points) : profile_in<Spatial>(mission, path, points);
}

}  // namespace skein::rendezvous
