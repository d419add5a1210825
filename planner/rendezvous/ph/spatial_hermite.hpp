// First-order Hermite interpolation by spatial quintic PH paths: from two poses in space and (m0, m1) to a path.
//
// The reference axis u is the unit chord, D its length. For a vector v let root(v) be the vector a with a . u >= 0 and
// 2 (a . u) a - |a|^2 u = v: it bisects u and v, and |a|^2 = |v|. With unit directions t0, t1 of start and end
//   A0 = root(m0 t0),  A2 = root(m1 t1),
//   d  = 120 D u - 15 (m0 t0 + m1 t1) + 5 (A0 u A2* + A2 u A0*),
//   A1 = (-3 (A0 + A2) + root(d)) / 4,
// the complex formulas of hermite.hpp word for word: planar data give the planar path. The signs of A2 and of root(d)
// give four solutions, chosen among as in the plane: both plus while start and end direction are within 90 degrees of
// the chord, otherwise the one of least elastic energy.
//
// Source: papers/001, section 2.2; Farouki, al-Kandari, Sakkalis, Adv. Comput. Math. 17 (2002). Departs from source:
// the free angles are zero; to optimise them gains 1.4 m in 35 km. Complexity: O(1), no trigonometric function per
// (m0, m1).
#pragma once

#include "planner/core/geometry/types.hpp"
#include "planner/rendezvous/ph/hermite.hpp"
#include "planner/rendezvous/ph/spatial_path.hpp"

namespace skein::rendezvous::ph {

class SpatialHermite {
 public:
  /// @throws std::invalid_argument if the two positions coincide.
  SpatialHermite(const Pose& start, const Pose& end);

  [[nodiscard]] double chord_m() const { return chord_m_; }
  [[nodiscard]] const Vec3& start_m() const { return start_m_; }
  /// What the choice and the formula need, in the chord frame: see the members.
  [[nodiscard]] const Axes& axes() const { return axes_; }
  [[nodiscard]] bool forward() const { return forward_; }
  [[nodiscard]] const Vec3& half_start() const { return half_start_; }
  [[nodiscard]] const Vec3& half_end() const { return half_end_; }
  /// The path of positive controls.
  [[nodiscard]] SpatialPath path(const Controls& m) const;
  /// Its length (m) alone.
  [[nodiscard]] double length_m(const Controls& m) const;

 private:
  [[nodiscard]] SpatialPreimage in_chord_frame(const Controls& m) const;
  [[nodiscard]] SpatialPreimage solution(const Vec3& a0, const Vec3& a2, double root_sign) const;

  Vec3 start_m_;
  double chord_m_;
  Axes axes_;        ///< of the chord
  bool forward_;     ///< both directions within 90 degrees of the chord
  Vec3 half_start_;  ///< root(t0), in the frame of the chord
  Vec3 half_end_;    ///< root(t1)
};

}  // namespace skein::rendezvous::ph
