// First-order Hermite interpolation by 1 to 4 joined PH segments: from two poses and controls to a path.
//
// In the frame of the chord, of length D, the preimage spline (preimage_spline.hpp) has c_0 = sqrt(m0) e^{i a0/2} and
// c_{n+1} = sqrt(m1) e^{i a1/2} as a single segment has w0 and w2; one coefficient in the middle closes the chord; each
// of the n - 1 others is free:
//   in the plane  c_j = sqrt(m_j) e^{i a_j/2}, so that |c_j^2| = m_j and a_j is its direction from the chord,
//   in space      c_j = sqrt(m_j) (cos(a_j/2) cos(e_j/2), sin(a_j/2) cos(e_j/2), sin(e_j/2)), azimuth and elevation,
// with angles in [-pi, pi], continuous across 0. Signs are chosen as for a single segment: both plus while start and
// end are within 90 degrees of the chord, otherwise the two (of c_{n+1} and of the root) of least elastic energy. With
// empty `interior` the path is that of the single segment, bit for bit.
//
// Source: papers/001, Remark 4. Departs from source: the paper does not say how segments are joined. Complexity:
// O(n^2).
#pragma once

#include "planner/rendezvous/ph/hermite.hpp"
#include "planner/rendezvous/ph/joined_path.hpp"
#include "planner/rendezvous/ph/spatial_hermite.hpp"

namespace skein::rendezvous::ph {

/// `reshaped`: controls of a path of n segments that is close to a given one; to that of a single segment it is equal,
/// but for lengths or angles out of their range.
class JoinedHermite : public Hermite {
 public:
  static constexpr std::size_t kPerCoefficient = 2;  ///< numbers of a free coefficient: m, direction

  /// @throws std::invalid_argument if the two positions coincide.
  using Hermite::Hermite;

  /// The path of controls whose lengths m are positive.
  [[nodiscard]] JoinedPlanarPath path(const Controls& m) const;
  /// Its length (m) alone.
  [[nodiscard]] double length_m(const Controls& m) const;
  [[nodiscard]] Controls reshaped(const Controls& m, std::size_t n) const;
};

class SpatialJoinedHermite : public SpatialHermite {
 public:
  static constexpr std::size_t kPerCoefficient = 3;  ///< numbers of a free coefficient: m, azimuth, elevation

  /// @throws std::invalid_argument if the two positions coincide.
  using SpatialHermite::SpatialHermite;

  /// The path of controls whose lengths m are positive.
  [[nodiscard]] JoinedSpatialPath path(const Controls& m) const;
  /// Its length (m) alone.
  [[nodiscard]] double length_m(const Controls& m) const;
  [[nodiscard]] Controls reshaped(const Controls& m, std::size_t n) const;
};

}  // namespace skein::rendezvous::ph
