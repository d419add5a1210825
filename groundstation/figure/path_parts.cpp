#include "groundstation/figure/path_parts.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace skein::figure {
namespace {

constexpr double kReach = 0.2;  // so far beyond the paths obstacles widen the picture
constexpr std::size_t kSeenPoints = 150;

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

}  // namespace

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
  return {extent.x.widened(0.0, kPathMargin * size_m), extent.y.widened(0.0, kPathMargin * size_m)};
}

bool has(const RunInput& input, ZoneKind kind) {
  return std::ranges::any_of(input.outlines, [&](const Outline& o) { return o.kind == kind && !o.corners_m.empty(); });
}

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

}  // namespace skein::figure
