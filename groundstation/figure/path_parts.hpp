// What figures of paths share: their extent, blocks of points, labels, and curves with their names.
//
// Source, Departs from source: none. Complexity: linear in the points.
#pragma once

#include <array>
#include <string>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot_text.hpp"

namespace skein::figure {

inline constexpr double kPathMargin = 0.07;  // of the greatest extent

struct Extent {
  Span x, y;
};

/// How zones of a kind are drawn.
struct ZoneLook {
  const char* block;
  const char* fill;
  const char* edge;
  const char* title;
};

inline constexpr std::array<ZoneLook, 4> kZoneLooks{{
    {"obstacle", "#c4c4c4", "#8a8a8a", "obstacle"},
    {"nofly", "#f4c7c3", "#c0504d", "no-fly zone"},
    {"announced", "#fbe3a6", "#b8860b", "announced zone"},
    {"hidden", "#d9d9e8", "#7a7a9a", "hidden obstacle"},
}};

/// What is shown from above: all paths and their ends, and the obstacles near them, with a margin.
[[nodiscard]] Extent extent_of(const RunInput& input);
/// Whether there is a zone of that kind with an outline.
[[nodiscard]] bool has(const RunInput& input, ZoneKind kind);
/// $f1, $p1, ... of each vehicle, flown and planned; $starts and $ends.
[[nodiscard]] std::string path_blocks(const RunInput& input, const LengthUnit& unit);
/// Numbers at the starts, on the side to which the vehicle does not go.
[[nodiscard]] std::string labels(const RunInput& input, const LengthUnit& unit, bool in_space);
/// The curves of all vehicles, and what they are called. @param columns "1:2" or "1:2:3"
[[nodiscard]] std::string path_plots(const RunInput& input, const char* columns, bool transit);
/// Ranges and names of the axes x and y.
[[nodiscard]] std::string axes(const Extent& extent, const LengthUnit& unit);

/// What sensors saw and nobody planned for: $seen, where it was, and from above its size ($bodies).
struct Seen {
  std::string blocks;
  std::string plots;
};
[[nodiscard]] Seen seen_in(const RunInput& input, const LengthUnit& unit, bool in_space);

}  // namespace skein::figure
