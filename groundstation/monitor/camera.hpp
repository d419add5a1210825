// From the world to the dots of a canvas: which plane is looked at, from where, how near.
//
// A plane has two of the three axes, u to the right and v up; dots are square. Without zoom everything that the mission
// names (starts, goals, the area) and every plan is in the picture.
// Source: none needed. Departs from source: none. Complexity: bounds O(points), a point O(1).
#pragma once

#include <optional>

#include "groundstation/monitor/canvas.hpp"
#include "groundstation/watch/view.hpp"

namespace skein::monitor {

enum class Plane : std::uint8_t { XY, XZ, YZ };

[[nodiscard]] std::string_view name_of(Plane plane);

/// u and v of a place (m).
[[nodiscard]] Vec2 on_plane(Plane plane, const Vec3& place_m);

/// What a camera must show without zoom; nothing while no place is known.
[[nodiscard]] std::optional<Box> bounds_of(const watch::SwarmView& view);

class Camera {
 public:
  /// @param centre_m in the middle of the picture; nothing: the middle of the bounds
  /// @param width, height of the canvas, in dots @param zoom over 0
  Camera(Plane plane, const Box& bounds, const std::optional<Vec3>& centre_m, double zoom, int width, int height);

  [[nodiscard]] Dot dot_of(const Vec3& place_m) const { return dot_of(on_plane(plane_, place_m)); }
  [[nodiscard]] Dot dot_of(const Vec2& uv_m) const {
    return {(uv_m.x() - left_m_) / dot_m_, (top_m_ - uv_m.y()) / dot_m_};
  }
  /// The place (u, v) in the middle of a dot.
  [[nodiscard]] Vec2 place_of(int x, int y) const {
    return {left_m_ + (x + 0.5) * dot_m_, top_m_ - (y + 0.5) * dot_m_};
  }
  [[nodiscard]] double dot_m() const { return dot_m_; }  ///< edge of a dot
  [[nodiscard]] Plane plane() const { return plane_; }
  [[nodiscard]] const Vec3& centre_m() const { return centre_m_; }

 private:
  Plane plane_;
  Vec3 centre_m_;
  double dot_m_ = 1.0;
  double left_m_ = 0.0;
  double top_m_ = 0.0;
};

}  // namespace skein::monitor
