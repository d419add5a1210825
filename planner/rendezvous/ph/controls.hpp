// The control variables of a path from pose to pose: (m0, m1), and what shapes a path of several joined segments.
//
// m0 and m1 are the lengths of dr/dq at start and end. A path of n segments has n - 1 free interior coefficients more
// (joined_hermite.hpp), each given by a length m and by its direction from the chord: one angle in the plane, two in
// space. The numbers of a path in their order, its particle, are m0, m1, then m and angles of each coefficient.
//
// Source: papers/001, section 2.2 and Remark 4. Departs from source: none. Complexity: O(1), no allocation.
#pragma once

#include <array>
#include <cstddef>

namespace skein::rendezvous::ph {

/// The most segments that a path may have.
inline constexpr std::size_t kMaxSegments = 4;

/// The free interior coefficients; empty for a single segment. Values beyond `size` are 0.
struct Interior {
  std::array<double, 3 * (kMaxSegments - 1)> values{};  ///< lengths (m) and angles (rad)
  std::size_t size = 0;

  bool operator==(const Interior&) const = default;
};

struct Controls {
  double m0_m = 0.0;
  double m1_m = 0.0;
  Interior interior;

  Controls() = default;
  Controls(double m0, double m1, const Interior& inside = {}) : m0_m(m0), m1_m(m1), interior(inside) {}
  bool operator==(const Controls&) const = default;

  [[nodiscard]] bool is_joined() const { return interior.size != 0; }
  /// How many numbers there are, and each of them by its place in the particle.
  [[nodiscard]] std::size_t size() const { return 2 + interior.size; }
  [[nodiscard]] double& operator[](std::size_t i) { return i == 0 ? m0_m : i == 1 ? m1_m : interior.values[i - 2]; }
  [[nodiscard]] double operator[](std::size_t i) const {
    return i == 0 ? m0_m : i == 1 ? m1_m : interior.values[i - 2];
  }
};

}  // namespace skein::rendezvous::ph
