// The path that a vehicle flies, in space: a planned one, whichever space it was planned in.
//
// A planar path lies at one height. Source, Departs from source: none. Complexity: that of the path.
#pragma once

#include <algorithm>
#include <utility>
#include <variant>

#include "planner/core/mission/mission.hpp"
#include "planner/rendezvous/ph/joined_path.hpp"

namespace skein {

class FlightPath {
 public:
  using InSpace = std::variant<rendezvous::ph::JoinedPlanarPath, rendezvous::ph::JoinedSpatialPath>;

  FlightPath() = default;  ///< a point at the origin
  /// @param height_m of a planar path
  FlightPath(InSpace path, double height_m) : path_(std::move(path)), height_m_(height_m) {}

  [[nodiscard]] const InSpace& in_space() const { return path_; }
  [[nodiscard]] double length_m() const {
    return std::visit([](const auto& path) { return path.length_m(); }, path_);
  }
  /// At arc length s (m), clamped to [0, length].
  [[nodiscard]] Vec3 position_at(double s_m) const {
    if (const auto* planar = std::get_if<0>(&path_)) {
      const Vec2 p = planar->position_at(std::clamp(s_m, 0.0, planar->length_m()));
      return {p.x(), p.y(), height_m_};
    }
    const auto& spatial = std::get<1>(path_);
    return spatial.position_at(std::clamp(s_m, 0.0, spatial.length_m()));
  }
  /// Unit vector of motion there.
  [[nodiscard]] Vec3 direction_at(double s_m) const;

 private:
  InSpace path_;
  double height_m_ = 0.0;
};

}  // namespace skein
