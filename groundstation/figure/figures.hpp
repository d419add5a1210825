// Figures as gnuplot text: each is a pure function of what there is to draw.
//
//   paths       planned and flown paths from above, with obstacles, starts and slots or goals
//   paths3d     the same in space
//   curvature   along each planned path, with its limits; of a path in the plane positive to the left
//   torsion     the same, in space
//   separation  least distance of two vehicles over time, with the sums of safety radii and of bodies
//   cost        cost of each sub-swarm's best particle by generation
//   box         a sweep's figures by swept value: median, quartiles, whiskers to 1.5 times their distance, single runs
//
// Colours are those of Okabe and Ito (without yellow), which colour-blind people tell apart; curves differ in their
// dashes too, and paths carry the number of their vehicle. The text names no file and no terminal: its output goes to
// standard output, in the format that terminal() asks for.
// Source: M. Okabe, K. Ito, Color Universal Design (2008). Departs from source: brown and grey for yellow and black.
// Complexity: linear in the points, thinned to kMostPoints a figure.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "groundstation/figure/input.hpp"

namespace skein::figure {

enum class FigureKind : std::uint8_t { Paths, Paths3d, Curvature, Torsion, Separation, Cost, Box };

inline constexpr std::array<std::string_view, 7> kFigureNames{"paths",      "paths3d", "curvature", "torsion",
                                                              "separation", "cost",    "box"};
inline constexpr std::size_t kMostPoints = 12'000;

[[nodiscard]] std::string_view name_of(FigureKind kind);
[[nodiscard]] std::optional<FigureKind> figure_from(std::string_view name);

/// A figure before gnuplot.
struct Sketch {
  std::string commands;  ///< gnuplot text without terminal
  int width_px = 900;
  int height_px = 450;
  std::string caption;  ///< one sentence: what it shows
};

/// Why a figure cannot be drawn, in one line.
struct NoSketch {
  std::string reason;
};

using Sketched = std::variant<Sketch, NoSketch>;

/// @param value of a box figure: a name of the sweep's figures; empty: those that say most
[[nodiscard]] Sketched sketch(FigureKind kind, const Input& input, const std::string& value = "");

enum class Format : std::uint8_t { Svg, Png };

/// The whole text for gnuplot. PNG has two pixels for one of SVG.
[[nodiscard]] std::string script_of(const Sketch& figure, Format format);

[[nodiscard]] Sketched sketch_paths(const RunInput& input);
[[nodiscard]] Sketched sketch_paths3d(const RunInput& input);
[[nodiscard]] Sketched sketch_curvature(const RunInput& input);
[[nodiscard]] Sketched sketch_torsion(const RunInput& input);
[[nodiscard]] Sketched sketch_separation(const RunInput& input);
[[nodiscard]] Sketched sketch_cost(const RunInput& input);
[[nodiscard]] Sketched sketch_box(const SweepInput& input, const std::string& value);

}  // namespace skein::figure
