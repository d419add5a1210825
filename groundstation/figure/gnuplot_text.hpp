// Words of gnuplot: quoted texts, blocks of numbers, colours and dashes.
//
// Source, Departs from source: none. Complexity: linear in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "planner/core/geometry/types.hpp"

namespace skein::figure {

/// A text in single quotes, in which gnuplot reads nothing; control characters become blanks, quotes typographic ones
/// (gnuplot 5.4 loses a text that begins with a doubled one).
[[nodiscard]] std::string quote(std::string_view text);

/// "linecolor rgb ..." of the i-th curve, from 0.
[[nodiscard]] std::string colour(std::size_t i);
/// "dashtype ..." of the i-th curve; with its colour it is another one for each of 40.
[[nodiscard]] std::string dash(std::size_t i);

/// Rows of numbers that a figure plots under `$name`. Metres and the like: six digits after the point are enough.
class Block {
 public:
  explicit Block(std::string_view name);
  Block& row(double x, double y);
  Block& row(double x, double y, double z);
  /// What follows is not joined to what was before.
  Block& gap();
  [[nodiscard]] std::string text() const { return text_ + "EOD\n"; }

 private:
  std::string text_;
};

/// Least and most of what is shown along an axis.
struct Span {
  double low = 1.0;
  double high = -1.0;  ///< below `low`: nothing yet
  void take(double value);
  [[nodiscard]] bool empty() const { return high < low; }
  /// By a share of its width at both ends, at least by `least`; never empty.
  [[nodiscard]] Span widened(double share, double least) const;
  [[nodiscard]] double width() const { return high - low; }
};

/// "set yrange ..." of an axis of positive values, logarithmic where they differ much, linear from 0 or below
/// elsewhere.
[[nodiscard]] std::string y_axis(const Span& values);
/// Whether that is a logarithmic one.
[[nodiscard]] bool is_logarithmic(const Span& values);

/// Metres, or kilometres where there are many.
struct LengthUnit {
  const char* name = "m";
  double in_m = 1.0;
};
[[nodiscard]] LengthUnit unit_for(double extent_m);

/// What all keys below a plot have in common.
inline constexpr const char* kKeyBelow = "set key outside below center horizontal Left reverse samplen 3 height 0.6\n";
/// The key of curves of n vehicles: below the plot, of many to the right of it, of more none.
[[nodiscard]] std::string key_for(std::size_t n);

/// Every how many-th of a vehicle's points is drawn.
[[nodiscard]] std::size_t stride_for(std::size_t points_of_all);

}  // namespace skein::figure
