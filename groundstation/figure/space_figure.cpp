#include <fmt/core.h>

#include <algorithm>

#include "groundstation/figure/path_parts.hpp"

namespace skein::figure {
namespace {

/// Lines around a zone: its outline at both ends of its heights, and edges between them.
void add_frame(Block& block, const Outline& outline, const Span& z_m, const LengthUnit& unit) {
  const double low = std::clamp(outline.heights_m.min, z_m.low, z_m.high) / unit.in_m;
  const double high = std::clamp(outline.heights_m.max, z_m.low, z_m.high) / unit.in_m;
  for (const double z : {low, high}) {
    for (const Vec2& corner : outline.corners_m) block.row(corner.x() / unit.in_m, corner.y() / unit.in_m, z);
    block.gap();
  }
  const std::size_t every = outline.corners_m.size() > 8 ? 9 : 1;
  for (std::size_t k = 0; k + 1 < outline.corners_m.size(); k += every) {
    const Vec2 corner = outline.corners_m[k] / unit.in_m;
    block.row(corner.x(), corner.y(), low).row(corner.x(), corner.y(), high).gap();
  }
}

bool inside(const Outline& outline, const Extent& extent) {
  return std::ranges::any_of(outline.corners_m, [&](const Vec2& corner) {
    return corner.x() >= extent.x.low && corner.x() <= extent.x.high && corner.y() >= extent.y.low &&
           corner.y() <= extent.y.high;
  });
}

std::string ground_block(const Terrain& terrain, const Extent& extent, const LengthUnit& unit) {
  constexpr int kLines = 48;
  Block block("ground");
  for (int i = 0; i <= kLines; ++i) {
    for (int j = 0; j <= kLines; ++j) {
      const Vec2 place_m(extent.x.low + extent.x.width() * i / kLines, extent.y.low + extent.y.width() * j / kLines);
      block.row(place_m.x() / unit.in_m, place_m.y() / unit.in_m, ground_m(terrain, place_m) / unit.in_m);
    }
    block.gap();
  }
  return block.text();
}

}  // namespace

Sketched sketch_paths3d(const RunInput& input) {
  if (is_planar(input.data)) return NoSketch{"all is in one plane"};
  const Extent extent = extent_of(input);
  const LengthUnit unit = unit_for(std::max(extent.x.width(), extent.y.width()));
  Span z_m;
  for (const VehicleTrace& vehicle : input.data.vehicles) {
    z_m.take(vehicle.spec.start.position_m.z());
    for (const TracePoint& point : vehicle.flown) z_m.take(point.position_m.z());
    for (const auto& point : vehicle.planned) z_m.take(point.position_m.z());
  }
  z_m = {std::min(0.0, z_m.low), z_m.widened(kPathMargin, 0.0).high};
  Sketch figure;
  figure.height_px = 680;
  figure.caption = "Paths in space, as planned before the flight and as flown; heights have a scale of their own.";
  figure.commands = path_blocks(input, unit) + labels(input, unit, true) + axes(extent, unit);
  std::string plots;
  const auto& terrain = input.data.mission.terrain;
  if (terrain) {
    figure.commands += ground_block(*terrain, extent, unit);
    plots += ", $ground using 1:2:3 with lines linewidth 0.5 linecolor rgb '#e2d8c6' title 'ground'";
  }
  for (std::size_t k = 0; k < kZoneLooks.size(); ++k) {
    Block block(kZoneLooks[k].block);
    bool any = false;
    for (const Outline& outline : input.outlines) {
      if (outline.kind != static_cast<ZoneKind>(k) || !inside(outline, extent)) continue;
      add_frame(block, outline, z_m, unit);
      any = true;
    }
    if (!any) continue;
    figure.commands += block.text();
    plots += fmt::format(", ${} using 1:2:3 with lines linewidth 0.8 linecolor rgb '{}' title '{}'",
                         kZoneLooks[k].block, kZoneLooks[k].edge, kZoneLooks[k].title);
  }
  const Seen seen = seen_in(input, unit, true);
  figure.commands += seen.blocks;
  plots += seen.plots + path_plots(input, "1:2:3", input.data.mission.transit.has_value());
  figure.commands += fmt::format(
      "set zrange [{:.9g}:{:.9g}]\nset xyplane at {:.9g}\nset zlabel 'height ({})' rotate parallel\n"
      "set view 60,332,1,0.75\nset view equal xy\nset ticslevel 0\nset border 127+256+512 linecolor rgb '#888888'\n"
      "set lmargin at screen 0.20\nset rmargin at screen 0.68\nset tmargin at screen 0.97\nset bmargin at screen 0.07\n"
      "set key at screen 0.985,0.96 right top vertical Left reverse samplen 2\nsplot {}\n",
      z_m.low / unit.in_m, z_m.high / unit.in_m, z_m.low / unit.in_m, unit.name, plots.substr(2));
  return figure;
}

}  // namespace skein::figure
