#include <fmt/core.h>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot_text.hpp"

namespace skein::figure {
namespace {

std::string cost_unit(double length_unit_m) {
  if (length_unit_m == 1.0) return "m";
  if (length_unit_m == 1000.0) return "km";
  return fmt::format("lengths of {:.9g} m", length_unit_m);
}

}  // namespace

Sketched sketch_separation(const RunInput& input) {
  const std::vector<SeparationPoint> points = separation(input.data);
  if (points.empty()) return NoSketch{"there are no two vehicles in the air at the same time"};
  Span least_m;
  Span shown_m;
  for (const SeparationPoint& point : points) {
    least_m.take(point.least_m);
    for (const double value_m : {point.least_m, point.safety_m, point.contact_m}) shown_m.take(value_m);
  }
  const bool logarithmic = is_logarithmic(shown_m);
  const LengthUnit unit = logarithmic ? LengthUnit{} : unit_for(least_m.high);
  if (!logarithmic) shown_m.take(0.0);
  const std::size_t stride = stride_for(points.size());
  Block least("least");
  Block safety("safety");
  Block contact("contact");
  for (std::size_t k = 0; k < points.size(); ++k) {
    const SeparationPoint& point = points[k];
    if (k % stride != 0 && k + 1 != points.size() && point.least_m > least_m.low) continue;
    least.row(point.time_s, point.least_m / unit.in_m);
    safety.row(point.time_s, point.safety_m / unit.in_m);
    contact.row(point.time_s, point.contact_m / unit.in_m);
  }
  Sketch figure;
  figure.caption = fmt::format("Least distance of two vehicles at the beginning of each step, {:.1f} m at least{}.",
                               least_m.low, logarithmic ? "; the axis is logarithmic" : "");
  figure.commands =
      least.text() + safety.text() + contact.text() +
      fmt::format(
          "set xlabel 'time (s)'\nset ylabel 'least separation ({})'\n{}"
          "set xrange [{:.9g}:{:.9g}]\n{}"
          "plot $least using 1:2 with lines linewidth 2.4 linecolor rgb '#0072b2' title 'nearest two centres', "
          "$safety using 1:2 with lines linewidth 1.8 dashtype (10,5) linecolor rgb '#d55e00' "
          "title 'safety radii together', "
          "$contact using 1:2 with lines linewidth 1.8 dashtype (3,4) linecolor rgb '#000000' "
          "title 'bodies touch'\n",
          unit.name, y_axis({shown_m.low / unit.in_m, shown_m.high / unit.in_m}), points.front().time_s,
          points.back().time_s, kKeyBelow);
  return figure;
}

Sketched sketch_cost(const RunInput& input) {
  const auto& vehicles = input.data.vehicles;
  Span cost;
  std::string blocks;
  std::string plots;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (vehicles[i].costs.size() < 2) continue;
    Block block(fmt::format("v{}", i));
    for (const CostPoint& point : vehicles[i].costs) {
      block.row(point.generation, point.cost);
      cost.take(point.cost);
    }
    blocks += block.text();
    plots += fmt::format(", $v{} using 1:2 with lines linewidth 2 {} {} title 'UAV {}'", i, colour(i), dash(i),
                         vehicles[i].spec.id);
  }
  if (cost.empty()) return NoSketch{"nobody planned by generations"};
  Sketch figure;
  figure.caption = fmt::format("Cost of the best particle of each sub-swarm{}.",
                               is_logarithmic(cost) ? "; the axis is logarithmic" : "");
  figure.commands = blocks + key_for(vehicles.size()) +
                    fmt::format("set xlabel 'generation'\nset ylabel 'cost ({})'\n{}plot {}\n",
                                cost_unit(input.data.mission.length_unit_m), y_axis(cost), plots.substr(2));
  return figure;
}

}  // namespace skein::figure
