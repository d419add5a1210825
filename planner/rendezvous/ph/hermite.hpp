// First-order Hermite interpolation by planar quintic PH paths: from two poses and (m0, m1) to a path.
//
// The data are turned so that the chord, of length D, lies on the positive real axis. With start and end angle a0, a1
// wrapped to (-pi, pi],
//   w0 = sqrt(m0) e^{i a0/2},  w2 = sqrt(m1) e^{i a1/2},
//   w1 = (-3 (w0 + w2) + sqrt(120 D - 15 w0^2 - 15 w2^2 + 10 w0 w2)) / 4      (principal root),
// and turned back. The signs of w2 and of the root give four solutions. The one with both signs plus is free of loops
// while both headings are within 90 degrees of the chord; otherwise the one of least elastic energy is taken.
//
// Source: papers/001, section 2.2; Farouki and Neff, Math. Comput. 64 (1995). Departs from source: the paper leaves
// the choice of the solution open. Complexity: O(1), no trigonometric function per (m0, m1).
#pragma once

#include "planner/core/geometry/types.hpp"
#include "planner/rendezvous/ph/controls.hpp"
#include "planner/rendezvous/ph/planar_path.hpp"

namespace skein::rendezvous::ph {

struct PlanarPose {
  Vec2 position_m = Vec2::Zero();
  double heading_rad = 0.0;

  bool operator==(const PlanarPose&) const = default;
};

class Hermite {
 public:
  /// @throws std::invalid_argument if the two positions coincide.
  Hermite(const PlanarPose& start, const PlanarPose& end);

  [[nodiscard]] double chord_m() const { return chord_m_; }
  [[nodiscard]] const Vec2& start_m() const { return start_m_; }
  /// What the choice and the formula need, in the chord frame: see the members.
  [[nodiscard]] bool forward() const { return forward_; }
  [[nodiscard]] Complex half_start() const { return half_start_; }
  [[nodiscard]] Complex half_end() const { return half_end_; }
  [[nodiscard]] Complex half_chord() const { return half_chord_; }
  /// The path of positive controls.
  [[nodiscard]] PlanarPath path(const Controls& m) const;
  /// Its length (m) alone.
  [[nodiscard]] double length_m(const Controls& m) const;

 private:
  [[nodiscard]] Preimage in_chord_frame(const Controls& m) const;
  [[nodiscard]] Preimage solution(Complex w0, Complex w2, double root_sign) const;

  Vec2 start_m_;
  double chord_m_;
  bool forward_;        ///< both headings within 90 degrees of the chord
  Complex half_start_;  ///< e^{i a0/2}
  Complex half_end_;    ///< e^{i a1/2}
  Complex half_chord_;  ///< e^{i phi/2}, phi the direction of the chord
};

}  // namespace skein::rendezvous::ph
