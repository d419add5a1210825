#include <fmt/core.h>

#include <algorithm>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot_text.hpp"

namespace skein::figure {
namespace {

constexpr double kMargin = 0.07;
constexpr double kReach = 0.2;  // so far beyond the paths obstacles widen the picture
constexpr std::size_t kSeenPoints = 150;
constexpr int kPlotWidth_px = 780;
constexpr int kFrame_px = 150;  // title, axis, key

struct Extent {
  Span x, y;
};

Extent extent_of(const RunInput& input) {
  Extent extent;
  const auto take = [&](const Vec3& place_m) {
    extent.x.take(place_m.x());
    extent.y.take(place_m.y());
  };
  for (std::size_t i = 0; i < input.data.vehicles.size(); ++i) {
    const VehicleTrace& vehicle = input.data.vehicles[i];
    take(vehicle.spec.start.position_m);
    take(end_m(input.data.mission, i));
    for (const TracePoint& point : vehicle.flown) take(point.position_m);
    for (const auto& point : vehicle.planned) take(point.position_m);
  }
  const double size_m = std::max({extent.x.width(), extent.y.width(), 1.0});
  const Extent far{extent.x.widened(0.0, kReach * size_m), extent.y.widened(0.0, kReach * size_m)};
  for (const Outline& outline : input.outlines) {
    Extent bounds;
    for (const Vec2& corner : outline.corners_m) {
      bounds.x.take(corner.x());
      bounds.y.take(corner.y());
    }
    const bool meets = !bounds.x.empty() && bounds.x.low < far.x.high && bounds.x.high > far.x.low &&
                       bounds.y.low < far.y.high && bounds.y.high > far.y.low;
    if (!meets) continue;
    for (const double x_m : {bounds.x.low, bounds.x.high}) extent.x.take(std::clamp(x_m, far.x.low, far.x.high));
    for (const double y_m : {bounds.y.low, bounds.y.high}) extent.y.take(std::clamp(y_m, far.y.low, far.y.high));
  }
  return {extent.x.widened(0.0, kMargin * size_m), extent.y.widened(0.0, kMargin * size_m)};
}

struct ZoneLook {
  const char* block;
  const char* fill;
  const char* edge;
  const char* title;
};

constexpr std::array<ZoneLook, 4> kZoneLooks{{
    {"obstacle", "#c4c4c4", "#8a8a8a", "obstacle"},
    {"nofly", "#f4c7c3", "#c0504d", "no-fly zone"},
    {"announced", "#fbe3a6", "#b8860b", "announced zone"},
    {"hidden", "#d9d9e8", "#7a7a9a", "hidden obstacle"},
}};

bool has(const RunInput& input, ZoneKind kind) {
  return std::ranges::any_of(input.outlines, [&](const Outline& o) { return o.kind == kind && !o.corners_m.empty(); });
}

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

void add_flown(Block& block, const VehicleTrace& vehicle, std::size_t stride, const LengthUnit& unit) {
  for (std::size_t k = 0; k < vehicle.flown.size(); ++k) {
    const bool jump = k > 0 && vehicle.flown[k].step != vehicle.flown[k - 1].step + 1;
    const bool last = k + 1 == vehicle.flown.size() || vehicle.flown[k + 1].step != vehicle.flown[k].step + 1;
    if (jump) block.gap();
    if (!jump && !last && k % stride != 0) continue;
    const Vec3 place = vehicle.flown[k].position_m / unit.in_m;
    block.row(place.x(), place.y(), place.z());
  }
}

/// $f1, $p1, ... of each vehicle, flown and planned; $starts and $ends.
std::string path_blocks(const RunInput& input, const LengthUnit& unit) {
  std::size_t points = 0;
  for (const VehicleTrace& vehicle : input.data.vehicles) points += vehicle.flown.size();
  std::string text;
  Block starts("starts");
  Block ends("ends");
  for (std::size_t i = 0; i < input.data.vehicles.size(); ++i) {
    const VehicleTrace& vehicle = input.data.vehicles[i];
    Block flown(fmt::format("f{}", i));
    add_flown(flown, vehicle, stride_for(points), unit);
    if (!vehicle.flown.empty()) text += flown.text();
    Block planned(fmt::format("p{}", i));
    for (const auto& point : vehicle.planned) {
      const Vec3 place = point.position_m / unit.in_m;
      planned.row(place.x(), place.y(), place.z());
    }
    if (!vehicle.planned.empty()) text += planned.text();
    const Vec3 start = vehicle.spec.start.position_m / unit.in_m;
    const Vec3 end = end_m(input.data.mission, i) / unit.in_m;
    starts.row(start.x(), start.y(), start.z());
    ends.row(end.x(), end.y(), end.z());
  }
  return text + starts.text() + ends.text();
}

/// Numbers at the starts, on the side to which the vehicle does not go.
std::string labels(const RunInput& input, const LengthUnit& unit, bool in_space) {
  std::string text;
  for (const VehicleTrace& vehicle : input.data.vehicles) {
    const Vec3 start = vehicle.spec.start.position_m / unit.in_m;
    double east_m = 0.0;
    if (!vehicle.planned.empty()) east_m = vehicle.planned[1].position_m.x() - vehicle.planned[0].position_m.x();
    for (const TracePoint& point : vehicle.flown) {
      if (east_m != 0.0) break;
      east_m = point.position_m.x() - vehicle.spec.start.position_m.x();
    }
    const bool left = east_m >= 0.0;
    const std::string height = in_space ? fmt::format(",{:.9g}", start.z()) : "";
    text += fmt::format("set label '{}' at {:.9g},{:.9g}{} {} front offset char {},0 font ',13'\n", vehicle.spec.id,
                        start.x(), start.y(), height, left ? "right" : "left", left ? -0.7 : 0.7);
  }
  return text;
}

/// What sensors saw and nobody planned for: $seen, where it was, and from above its size ($bodies).
struct Seen {
  std::string blocks;
  std::string plots;
};

Seen seen_in(const RunInput& input, const LengthUnit& unit, bool in_space) {
  if (input.data.seen.empty()) return {};
  Block places("seen");
  Block bodies("bodies");
  for (const SeenObstacle& seen : input.data.seen) {
    const std::size_t stride = 1 + seen.places_m.size() / kSeenPoints;
    for (std::size_t k = 0; k < seen.places_m.size(); k += stride) {
      const Vec3 place = seen.places_m[k] / unit.in_m;
      places.row(place.x(), place.y(), place.z());
    }
    places.gap();
    const Vec3 last = seen.places_m.back() / unit.in_m;
    bodies.row(last.x(), last.y(), seen.radius_m / unit.in_m);
  }
  Seen seen{places.text(), ""};
  if (in_space) {
    seen.plots =
        ", $seen using 1:2:3 with linespoints linewidth 0.8 pointtype 6 pointsize 0.3 pointinterval 20 linecolor "
        "rgb '#7f3c8d' title 'seen on the way'";
  } else {
    seen.blocks += bodies.text();
    seen.plots =
        ", $bodies using 1:2:3 with circles fillstyle solid 0.35 noborder linecolor rgb '#7f3c8d' title 'seen on "
        "the way', $seen using 1:2 with lines linewidth 0.8 linecolor rgb '#7f3c8d' notitle";
  }
  return seen;
}

/// The curves of all vehicles, and what they are called. @param columns "1:2" or "1:2:3"
std::string path_plots(const RunInput& input, const char* columns, bool transit) {
  std::string text;
  bool flown = false;
  bool planned = false;
  for (std::size_t i = 0; i < input.data.vehicles.size(); ++i) {
    if (input.data.vehicles[i].flown.empty()) continue;
    flown = true;
    text += fmt::format(", $f{} using {} with lines linewidth 2.4 {} notitle", i, columns, colour(i));
  }
  for (std::size_t i = 0; i < input.data.vehicles.size(); ++i) {
    if (input.data.vehicles[i].planned.empty()) continue;
    planned = true;
    text += fmt::format(", $p{} using {} with lines linewidth 1.1 dashtype (5,5) linecolor rgb '#000000' notitle", i,
                        columns);
  }
  text += fmt::format(", $starts using {} with points pointtype 7 pointsize 0.6 linecolor rgb '#222222' title 'start'",
                      columns);
  text += fmt::format(
      ", $ends using {} with points pointtype 2 pointsize 1 linewidth 1.6 linecolor rgb '#000000' title '{}'", columns,
      transit ? "goal" : "slot");
  if (flown) text += ", keyentry with lines linewidth 2.4 linecolor rgb '#0072b2' title 'flown'";
  if (planned) text += ", keyentry with lines linewidth 1.1 dashtype (5,5) linecolor rgb '#000000' title 'planned'";
  return text;
}

std::string axes(const Extent& extent, const LengthUnit& unit) {
  return fmt::format(
      "set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\nset xlabel 'x ({})'\nset ylabel 'y ({})'\n",
      extent.x.low / unit.in_m, extent.x.high / unit.in_m, extent.y.low / unit.in_m, extent.y.high / unit.in_m,
      unit.name, unit.name);
}

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
  z_m = {std::min(0.0, z_m.low), z_m.widened(kMargin, 0.0).high};
  Sketch figure;
  figure.height_px = 640;
  figure.caption =
      "Paths in space, as planned before the flight and as flown; heights are drawn larger than distances.";
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
      "set zrange [{:.9g}:{:.9g}]\nset xyplane at {:.9g}\nset zlabel 'height ({})' rotate parallel\nset view "
      "60,332,1.35,1\n"
      "set view equal xy\nset lmargin at screen 0.04\nset rmargin at screen 0.80\nset tmargin at screen 0.97\nset "
      "bmargin at screen 0.06\nset border 127+256+512 linecolor rgb "
      "'#888888'\nset ticslevel 0\n"
      "set key at screen 0.985,0.96 right top vertical Left reverse samplen 2\nsplot {}\n",
      z_m.low / unit.in_m, z_m.high / unit.in_m, z_m.low / unit.in_m, unit.name, plots.substr(2));
  return figure;
}

}  // namespace skein::figure
