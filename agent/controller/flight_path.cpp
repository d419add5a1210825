#include "agent/controller/flight_path.hpp"

#include "planner/core/geometry/frames.hpp"

namespace skein {

Vec3 FlightPath::direction_at(double s_m) const {
  const double s = std::clamp(s_m, 0.0, length_m());
  if (const auto* planar = std::get_if<0>(&path_)) {
    const Vec2 along = direction_of_heading(planar->heading_at(s));
    return {along.x(), along.y(), 0.0};
  }
  const auto& spatial = std::get<1>(path_);
  return spatial.direction(spatial.parameter_at(s));
}

}  // namespace skein
