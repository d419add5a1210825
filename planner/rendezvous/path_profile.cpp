#include "planner/rendezvous/path_profile.hpp"

#include <stdexcept>

namespace skein::rendezvous {
namespace {

template <typename Space>
std::vector<ProfilePoint> profile_in(const Mission& mission, const PlannedPath& plan, std::size_t points) {
  const ProblemIn<Space> problem = make_problem<Space>(mission, plan.agent);
  const typename Space::Path path = problem.own().hermite.path({plan.particle[0], plan.particle[1]});
  std::vector<ProfilePoint> profile(points);
  for (std::size_t k = 0; k < points; ++k) {
    ProfilePoint& point = profile[k];
    point.arc_m = path.length_m() * static_cast<double>(k) / static_cast<double>(points - 1);
    point.curvature_per_m = path.curvature_at(point.arc_m);
    if constexpr (Space::kSpatial) {
      point.position_m = path.position_at(point.arc_m);
      point.torsion_per_m = path.torsion_at(point.arc_m);
    } else {
      const Vec2 place_m = path.position_at(point.arc_m);
      point.position_m = {place_m.x(), place_m.y(), problem.own().altitude_m};
    }
  }
  return profile;
}

}  // namespace

std::vector<ProfilePoint> path_profile(const Mission& mission, const PlannedPath& path, std::size_t points) {
  if (path.particle.size() != 2) throw std::invalid_argument("a planned path is not two numbers");
  if (points < 2) throw std::invalid_argument("a profile has at least two points");
  return is_planar(mission) ? profile_in<Planar>(mission, path, points) : profile_in<Spatial>(mission, path, points);
}

}  // namespace skein::rendezvous
