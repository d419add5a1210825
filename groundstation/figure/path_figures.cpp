#include <fmt/core.h>

#include <algorithm>

#include "groundstation/figure/path_parts.hpp"

namespace skein::figure {
namespace {

constexpr int kPlotWidth_px = 780;
constexpr int kFrame_px = 150;  // title, axis, key

std::string zone_blocks(const RunInput& input, const LengthUnit& unit) {
  std::string text;
  for (std::size_t k = 0; k < kZoneLooks.size(); ++k) {
    if (!has(input, static_cast<ZoneKind>(k))) continue;
    Block block(kZoneLooks[k].block);
    for (const Outline& outline : input.outlines) {
      if (outline.kind != static_cast<ZoneKind>(k) || outline.corners_m.empty()) continue;
      for (const Vec2& corner : outline.corners_m) block.row(corner.x() / unit.in_m, corner.y() / unit.in_m);
      block.gap();
    }
    text += block.text();
  }
  return text;
}

}  // namespace

Sketched sketch_paths(const RunInput& input) {
  const Extent extent = extent_of(input);
  const LengthUnit unit = unit_for(std::max(extent.x.width(), extent.y.width()));
  Sketch figure;
  figure.height_px =
      kFrame_px + std::clamp(static_cast<int>(kPlotWidth_px * extent.y.width() / extent.x.width()), 220, 780);
  figure.caption = "Paths from above, as planned before the flight and as flown; numbers are vehicles.";
  figure.commands = zone_blocks(input, unit) + path_blocks(input, unit) + labels(input, unit, false) +
                    axes(extent, unit) + "set size ratio -1\n" + kKeyBelow;
  std::string plots;
  for (std::size_t k = 0; k < kZoneLooks.size(); ++k) {
    if (!has(input, static_cast<ZoneKind>(k))) continue;
    const ZoneLook& look = kZoneLooks[k];
    plots += fmt::format(
        ", ${0} using 1:2 with filledcurves closed fillcolor rgb '{1}' title '{2}', ${0} using 1:2 with "
        "lines linewidth 0.8 linecolor rgb '{3}' notitle",
        look.block, look.fill, look.title, look.edge);
  }
  const Seen seen = seen_in(input, unit, false);
  figure.commands += seen.blocks;
  plots += seen.plots + path_plots(input, "1:2", input.data.mission.transit.has_value());
  figure.commands += "plot " + plots.substr(2) + "\n";
  return figure;
}

}  // namespace skein::figure
