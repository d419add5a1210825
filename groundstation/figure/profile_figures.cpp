#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot_text.hpp"

namespace skein::figure {
namespace {

constexpr double kStraight_per_m = 1e-12;

struct Along {
  const char* what;
  double rendezvous::ProfilePoint::*value;
  double VehicleSpec::*limit;
  double unlimited_per_m;  ///< a limit that stands for none
};

/// Curves along the planned paths, and their limits on the sides where there are values.
Sketched sketch_along(const RunInput& input, const Along& along) {
  const auto& vehicles = input.data.vehicles;
  Span arc_m;
  Span value_per_m;
  std::set<double> limits_per_m;
  for (const VehicleTrace& vehicle : vehicles) {
    if (vehicle.planned.empty()) continue;
    const double limit_per_m = vehicle.spec.*along.limit;
    if (limit_per_m < along.unlimited_per_m) limits_per_m.insert(limit_per_m);
    for (const auto& point : vehicle.planned) {
      arc_m.take(point.arc_m);
      value_per_m.take(point.*along.value);
    }
  }
  if (arc_m.empty())
    return NoSketch{"there are no planned paths: a transit plans on its way, other runs may have failed"};
  const LengthUnit unit = unit_for(arc_m.high);
  const bool two_sided = value_per_m.low < -kStraight_per_m;
  std::string blocks;
  std::string plots;
  for (const double limit_per_m : limits_per_m) {
    for (const double side : {-1.0, 1.0}) {
      if (side < 0.0 && !two_sided) continue;
      const char* title = side > 0.0 && limit_per_m == *limits_per_m.begin() ? "title 'limit'" : "notitle";
      plots += fmt::format(", {:.9g} with lines linewidth 1.4 dashtype (2,3) linecolor rgb '#000000' {}",
                           side * limit_per_m * unit.in_m, title);
      value_per_m.take(side * limit_per_m);
    }
  }
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (vehicles[i].planned.empty()) continue;
    Block block(fmt::format("v{}", i));
    for (const auto& point : vehicles[i].planned) block.row(point.arc_m / unit.in_m, point.*along.value * unit.in_m);
    blocks += block.text();
    plots += fmt::format(", $v{} using 1:2 with lines linewidth 2 {} {} title 'UAV {}'", i, colour(i), dash(i),
                         vehicles[i].spec.id);
  }
  if (value_per_m.low >= 0.0) value_per_m.take(0.0);
  const Span shown = value_per_m.widened(0.06, 0.0);
  Sketch figure;
  figure.caption = fmt::format("{} along the planned paths.",
                               std::string(1, static_cast<char>(along.what[0] - 32)) + (along.what + 1));
  figure.commands = blocks + key_for(vehicles.size()) +
                    fmt::format(
                        "set xlabel 'distance along the path ({})'\nset ylabel '{} (1/{}){}'\nset xrange [0:{:.9g}]\n"
                        "set yrange [{:.9g}:{:.9g}]\nplot {}\n",
                        unit.name, along.what, unit.name, two_sided && along.what[0] == 'c' ? ", left positive" : "",
                        arc_m.high / unit.in_m, shown.low * unit.in_m, shown.high * unit.in_m, plots.substr(2));
  return figure;
}

}  // namespace

Sketched sketch_curvature(const RunInput& input) {
  return sketch_along(
      input, {"curvature", &rendezvous::ProfilePoint::curvature_per_m, &VehicleSpec::max_curvature_per_m, 1e3});
}

Sketched sketch_torsion(const RunInput& input) {
  if (is_planar(input.data)) return NoSketch{"all is in one plane: there is no torsion"};
  return sketch_along(input, {"torsion", &rendezvous::ProfilePoint::torsion_per_m, &VehicleSpec::max_torsion_per_m,
                              kUnlimitedTorsion_per_m});
}

}  // namespace skein::figure
