// Closed interval of real numbers: a search range, a limit from both sides.
//
// Source: none needed. Departs from source: none. Complexity: O(1).
#pragma once

namespace skein {

struct Interval {
  double min = 0.0;
  double max = 0.0;

  [[nodiscard]] constexpr double width() const { return max - min; }
  [[nodiscard]] constexpr bool contains(double x) const { return x >= min && x <= max; }
  [[nodiscard]] constexpr double clamp(double x) const { return x < min ? min : (x > max ? max : x); }

  bool operator==(const Interval&) const = default;
};

}  // namespace skein
