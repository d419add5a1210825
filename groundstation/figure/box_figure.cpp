#include <fmt/core.h>

#include <algorithm>

#include "groundstation/figure/figures.hpp"
#include "groundstation/figure/gnuplot_text.hpp"
#include "groundstation/sweep/table.hpp"

namespace skein::figure {
namespace {

// What a sweep is about, in this order; those that all runs have equal say nothing.
constexpr std::array<std::string_view, 7> kTelling{"longest_path_m",   "total_path_m",    "plan_spread_m", "steps",
                                                   "min_separation_m", "min_clearance_m", "replan_rounds"};
constexpr double kSame = 1e-6;  // of the largest value, or of 1
constexpr std::size_t kMostPanels = 5;
constexpr int kPanel_px = 330;
constexpr std::size_t kFewRows = 5;      // more: labels stand upright
constexpr std::size_t kWideRows = 12;    // more: one panel a line
constexpr std::size_t kManyLabels = 26;  // letters of all labels from which they are turned

/// What the swept values of a row are, without their keys; those stand below the axis.
std::string label_of(const Json& row) {
  std::string label;
  for (const auto& [key, value] : row.at("set").items()) {
    label += (label.empty() ? "" : ", ") + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  return label.empty() ? "all runs" : label;
}

std::string keys_of(const Json& rows) {
  std::string keys;
  for (const auto& [key, value] : rows.front().at("set").items()) keys += (keys.empty() ? "" : ", ") + key;
  return keys;
}

std::vector<double> values_of(const Json& row, const std::string& name) {
  std::vector<double> values;
  for (const Json& run : row.at("per_run")) {
    const auto found = run.at("figures").find(name);
    if (found != run.at("figures").end() && found->is_number()) values.push_back(found->get<double>());
  }
  return values;
}

Span span_of(const Json& rows, const std::string& name) {
  Span span;
  for (const Json& row : rows) {
    for (const double value : values_of(row, name)) span.take(value);
  }
  return span;
}

std::string ticks_of(const Json& rows) {
  std::string ticks;
  std::size_t letters = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string label = label_of(rows[i]);
    letters += label.size() + 2;
    ticks += fmt::format("{}{} {}", i > 0 ? ", " : "", quote(label), i + 1);
  }
  const char* turn = letters <= kManyLabels ? "" : rows.size() <= kFewRows ? " rotate by -25" : " rotate by -90";
  return fmt::format("set xtics ({}){}\n", ticks, turn);
}

/// "longest_path_m" -> "longest path (m)"; of many metres in kilometres.
std::string axis_of(const std::string& name, const LengthUnit& unit) {
  const bool metres = name.ends_with("_m");
  std::string text = metres ? name.substr(0, name.size() - 2) : name;
  std::ranges::replace(text, '_', ' ');
  return metres ? fmt::format("{} ({})", text, unit.name) : text;
}

std::string box_panel(const Json& rows, const std::string& name, std::size_t panel, std::string& blocks) {
  const Span span = span_of(rows, name);
  const LengthUnit unit = name.ends_with("_m") ? unit_for(span.high) : LengthUnit{};
  std::string plots;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> values = values_of(rows[i], name);
    if (values.empty()) continue;
    const std::string block_name = fmt::format("b{}_{}", panel, i);
    Block block(block_name);
    for (const double value : values) block.row(static_cast<double>(i + 1), value / unit.in_m);
    blocks += block.text();
    plots += fmt::format(", ${} using ({}):2 with boxplot {} notitle", block_name, i + 1, colour(i));
  }
  const Span shown = Span{span.low / unit.in_m, span.high / unit.in_m}.widened(0.08, 0.0);
  return fmt::format("set ylabel {}\nset yrange [{:.9g}:{:.9g}]\nplot {}\n", quote(axis_of(name, unit)), shown.low,
                     shown.high, plots.substr(2));
}

std::string success_panel(const Json& rows, std::string& blocks) {
  Block block("success");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto runs = rows[i].at("runs").get<std::size_t>();
    if (runs == 0) continue;
    const std::size_t count = runs - std::min(runs, rows[i].at("failures").size());
    const Interval95 interval = interval_of(count, runs);
    block.row(static_cast<double>(i + 1), static_cast<double>(count) / static_cast<double>(runs));
    block.row(static_cast<double>(i + 1), interval.low).row(static_cast<double>(i + 1), interval.high).gap();
  }
  blocks += block.text();
  return "set ylabel 'success rate'\nset yrange [-0.03:1.03]\nplot $success using 1:2 every 1:1:1 with lines linewidth "
         "2 "
         "linecolor rgb '#888888' notitle, $success using 1:2 every 3::0 with points pointtype 7 linecolor rgb "
         "'#0072b2' notitle\n";
}

bool is_sound(const Json& rows) {
  return rows.is_array() && !rows.empty() && std::ranges::all_of(rows, [](const Json& row) {
           return row.is_object() && row.contains("set") && row.at("set").is_object() && row.contains("per_run") &&
                  row.at("per_run").is_array() && row.contains("failures") && row.contains("runs");
         });
}

}  // namespace

Sketched sketch_box(const SweepInput& input, const std::string& value) {
  const Json& rows = input.document.at("rows");
  if (!is_sound(rows)) return NoSketch{"the sweep has no rows with their runs"};
  std::vector<std::string> names;
  if (value.empty()) {
    for (const std::string_view name : kTelling) {
      const Span span = span_of(rows, std::string(name));
      const bool differs = !span.empty() && span.width() > kSame * std::max(1.0, span.high);
      if (differs && names.size() < kMostPanels) names.emplace_back(name);
    }
  } else {
    if (span_of(rows, value).empty()) return NoSketch{fmt::format("the sweep has no figure '{}'", value)};
    names.push_back(value);
  }
  std::string blocks;
  std::string panels;
  if (value.empty()) panels += success_panel(rows, blocks);
  for (std::size_t i = 0; i < names.size(); ++i) panels += box_panel(rows, names[i], i, blocks);
  const std::size_t count = names.size() + (value.empty() ? 1 : 0);
  const std::size_t columns = rows.size() > kWideRows ? 1 : 2;
  const std::size_t lines = (count + columns - 1) / columns;
  Sketch figure;
  figure.height_px = kPanel_px * static_cast<int>(lines) + (count == 1 ? 120 : 0);
  figure.caption = "Single runs by swept value: median, quartiles, whiskers to 1.5 times their distance, runs beyond";
  figure.caption += value.empty() ? "; rates of success with Wilson's interval of 95 %." : ".";
  figure.commands = blocks + ticks_of(rows) + "set style boxplot range 1.5 outliers pointtype 6\nset boxwidth 0.5\n" +
                    fmt::format(
                        "set style data boxplot\nset style fill solid 0.25 border\nset xrange [0.4:{}.6]\n"
                        "set xlabel {}\nunset key\n",
                        rows.size(), quote(keys_of(rows)));
  figure.commands +=
      count > 1 ? fmt::format("set multiplot layout {},{}\n{}unset multiplot\n", lines, columns, panels) : panels;
  return figure;
}

}  // namespace skein::figure
