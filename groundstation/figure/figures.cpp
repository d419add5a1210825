#include "groundstation/figure/figures.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace skein::figure {
namespace {

// Widths are of the SVG; a PNG is made at twice its size.
constexpr int kScale = 2;
constexpr const char* kLook =
    "set encoding utf8\nset tics nomirror\nset grid linecolor rgb '#dddddd' linewidth 0.7\n"
    "set border 3 linecolor rgb '#444444'\n";

struct Sketcher {
  FigureKind kind;
  const std::string& value;

  Sketched operator()(const RunInput& run) const {
    if (kind == FigureKind::Box) return NoSketch{"box plots are of sweeps"};
    if (run.data.vehicles.empty()) return NoSketch{"there are no samples of the run"};
    switch (kind) {
      case FigureKind::Paths:
        return sketch_paths(run);
      case FigureKind::Paths3d:
        return sketch_paths3d(run);
      case FigureKind::Curvature:
        return sketch_curvature(run);
      case FigureKind::Torsion:
        return sketch_torsion(run);
      case FigureKind::Separation:
        return sketch_separation(run);
      default:
        return sketch_cost(run);
    }
  }
  Sketched operator()(const SweepInput& sweep) const {
    if (kind == FigureKind::Box) return sketch_box(sweep, value);
    return NoSketch{"it is of one run, and this is a sweep"};
  }
};

}  // namespace

std::string_view name_of(FigureKind kind) {
  return kFigureNames[static_cast<std::size_t>(kind)];
}

std::optional<FigureKind> figure_from(std::string_view name) {
  const auto found = std::ranges::find(kFigureNames, name);
  if (found == kFigureNames.end()) return std::nullopt;
  return static_cast<FigureKind>(found - kFigureNames.begin());
}

Sketched sketch(FigureKind kind, const Input& input, const std::string& value) {
  return std::visit(Sketcher{kind, value}, input);
}

std::string script_of(const Sketch& figure, Format format) {
  const std::string terminal =
      format == Format::Svg
          ? fmt::format("set terminal svg noenhanced size {},{} font 'DejaVu Sans,14' background '#ffffff'\n",
                        figure.width_px, figure.height_px)
          : fmt::format(
                "set terminal pngcairo noenhanced size {},{} font 'DejaVu Sans,14' fontscale {} linewidth {} "
                "pointscale {} background '#ffffff'\n",
                kScale * figure.width_px, kScale * figure.height_px, kScale, kScale, kScale);
  return terminal + kLook + figure.commands;
}

}  // namespace skein::figure
