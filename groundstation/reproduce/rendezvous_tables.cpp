#include "groundstation/reproduce/rendezvous_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/reproduce/cells.hpp"
#include "groundstation/reproduce/comparison.hpp"

namespace skein::reproduce {
namespace {

constexpr double kKm = 1e-3;      ///< of metres
constexpr double kPerKm = 1e3;    ///< of 1/m
constexpr int kLengthDigits = 4;  ///< as the paper prints lengths in km

std::string length_of(int vehicle) {
  return fmt::format("vehicles.{}.planned_length_m", vehicle);
}

Line mean_line(std::string key, std::string figure, const std::string& of, bool with_sd) {
  return {std::move(key), std::move(figure), "km",
          [of, with_sd](const Combination& c) { return mean_cell(c, of, kKm, kLengthDigits, with_sd); }};
}

std::vector<Line> length_lines(bool with_sd) {
  const char* what = with_sd ? "L{}, mean (sd)" : "L{}";
  std::vector<Line> lines;
  for (const int i : {1, 2, 3}) {
    lines.push_back(mean_line(fmt::format("l{}", i), fmt::format(fmt::runtime(what), i), length_of(i), with_sd));
  }
  return lines;
}

std::vector<Line> separation_lines() {
  std::vector<Line> lines;
  for (const auto& [a, b] : {std::pair{1, 2}, {1, 3}, {2, 3}}) {
    lines.push_back(mean_line(fmt::format("d{}{}", a, b), fmt::format("dis_min,{}{}", a, b),
                              fmt::format("separations.{}-{}.planned_m", a, b), false));
  }
  return lines;
}

/// Of the means of L1, L2 and L3: what the paper calls the mean largest difference of lengths.
Cell difference_of_means(const Combination& combination) {
  const auto& figures = combination.entry->at("figures");
  std::vector<double> means;
  for (const int i : {1, 2, 3}) {
    if (figures.contains(length_of(i))) means.push_back(figures.at(length_of(i)).at("mean").get<double>());
  }
  if (means.empty()) return {};
  const auto [least, most] = std::ranges::minmax(means);
  return number_cell(kKm * (most - least), kLengthDigits);
}

Line runs_line() {
  return {"runs", "runs", "-", [](const Combination& c) {
            const auto runs = c.row->at("runs").get<std::size_t>();
            return Cell{fmt::format("{}", runs), {{"value", runs}}};
          }};
}

Line rate_line(std::string key, std::string figure, const char* rate) {
  return {std::move(key), std::move(figure), "-", [rate](const Combination& c) { return rate_cell(c, rate); }};
}

Line difference_line(std::string key, std::string figure) {
  return mean_line(std::move(key), std::move(figure), "plan_spread_m", false);
}

void append(std::vector<Line>& lines, std::vector<Line> more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

Method ours(const std::string& planner, const std::string& campaign) {
  return {"`" + planner + "`", "", campaign, {{"planner.name", planner}}};
}

void add(std::vector<Table>& tables, std::optional<Table> table, std::string id, std::string title,
         std::vector<std::string> notes) {
  if (!table) return;
  table->id = std::move(id);
  table->title = std::move(title);
  table->notes = std::move(notes);
  tables.push_back(std::move(*table));
}

std::optional<Table> table3(const Results& results) {
  std::vector<Line> lines{runs_line()};
  append(lines, length_lines(false));
  lines.push_back(difference_line("difference", "largest difference of lengths"));
  append(lines, separation_lines());
  return compare(results,
                 {{"paper, no cooperation", "table3.solo", "", {}},
                  ours("dcpso-solo", "rendezvous-2d"),
                  {"paper, DCPSO", "table3.dcpso", "", {}},
                  ours("dcpso-paper", "rendezvous-2d"),
                  ours("dcpso", "rendezvous-2d"),
                  {"paper, CCGA", "table3.ccga", "", {}},
                  ours("ccga", "rendezvous-2d")},
                 lines);
}

std::optional<Table> table4(const Results& results) {
  std::vector<Line> lines{runs_line()};
  lines.push_back(
      {"successes", "successes", "-", [](const Combination& c) { return successes_cell(c, "plan_success"); }});
  lines.push_back(rate_line("rate", "success rate [95 %]", "plan_success"));
  lines.push_back(rate_line("feasible", "feasible [95 %]", "plan_feasible"));
  lines.push_back(rate_line("arrived", "arrived in formation, flown [95 %]", "success"));
  append(lines, length_lines(true));
  lines.push_back({"difference", "largest difference of the means", "km", difference_of_means});
  lines.push_back(difference_line("spread", "mean of the largest differences"));
  lines.push_back({"time", "computation time, mean", "s", [](const Combination& c) {
                     Cell cell = mean_cell(c, "plan_s", 1.0, kLengthDigits, false);
                     cell.timed = true;
                     return cell;
                   }});
  return compare(results,
                 {{"paper, DCPSO", "table4.dcpso", "", {}},
                  ours("dcpso-paper", "rendezvous-2d"),
                  ours("dcpso", "rendezvous-2d"),
                  {"paper, CCGA", "table4.ccga", "", {}},
                  ours("ccga", "rendezvous-2d"),
                  ours("dcpso-solo", "rendezvous-2d")},
                 lines);
}

std::optional<Table> readings(const Results& results) {
  const auto reading = [](std::string title, std::string campaign, std::vector<Override> values) {
    return Method{std::move(title), "", std::move(campaign), std::move(values)};
  };
  const std::string own = "planner.own_reference";
  const std::string fresh = "planner.refresh_costs";
  const std::string speed = "planner.velocity_limit";
  std::vector<Line> lines{runs_line(), rate_line("rate", "success rate [95 %]", "plan_success")};
  lines.push_back(length_lines(true)[0]);
  return compare(results,
                 {{"paper, DCPSO", "table4.dcpso", "", {}},
                  reading("own, refreshed, 0.2", "readings", {{own, "1"}, {fresh, "1"}}),
                  reading("own, as stored, 0.2", "readings", {{own, "1"}, {fresh, "0"}}),
                  reading("modified, refreshed, 0.2", "readings", {{own, "0"}, {fresh, "1"}}),
                  reading("modified, as stored, 0.2", "readings", {{own, "0"}, {fresh, "0"}}),
                  reading("own, refreshed, 0.1", "velocities", {{speed, "0.1"}}),
                  reading("own, refreshed, 0.5", "velocities", {{speed, "0.5"}}),
                  {"paper, CCGA", "table4.ccga", "", {}},
                  reading("`ccga`, own", "ccga-own", {})},
                 lines);
}

std::optional<Table> table6(const Results& results, const std::string& campaign) {
  std::vector<Line> lines{runs_line(), rate_line("rate", "success rate [95 %]", "plan_success")};
  append(lines, length_lines(true));
  lines.push_back(difference_line("difference", "largest difference of lengths"));
  append(lines, separation_lines());
  return compare(results,
                 {{"paper, DCPSO", "table6.dcpso", "", {}},
                  ours("dcpso-paper", campaign),
                  ours("dcpso", campaign),
                  ours("ccga", campaign),
                  ours("dcpso-solo", campaign)},
                 lines);
}

std::optional<Table> curves(const Results& results, const std::string& prefix, const std::string& campaign,
                            bool in_space) {
  const auto most = [](std::string key, std::string figure, const std::string& of) {
    return Line{std::move(key), std::move(figure), "1/km", [of](const Combination& c) {
                  std::vector<std::string> names;
                  for (const int i : {1, 2, 3}) names.push_back(fmt::format("vehicles.{}.{}", i, of));
                  return most_cell(c, names, kPerKm, 3);
                }};
  };
  std::vector<Line> lines{most("curvature", "greatest curvature flown in any run", "max_curvature_per_m")};
  if (in_space) lines.push_back(most("torsion", "greatest torsion flown in any run", "max_torsion_per_m"));
  std::vector<Method> methods{
      {"paper, DCPSO", prefix + ".dcpso", "", {}}, ours("dcpso-paper", campaign), ours("dcpso", campaign)};
  if (!in_space) {
    methods.push_back({"paper, no cooperation", prefix + ".solo", "", {}});
    methods.push_back(ours("dcpso-solo", campaign));
    methods.push_back({"paper, CCGA", prefix + ".ccga", "", {}});
    methods.push_back(ours("ccga", campaign));
  }
  return compare(results, methods, lines);
}

void add_plane(std::vector<Table>& tables, const Results& results) {
  add(tables, table3(results), "rendezvous.table3", "Table 3: lengths and least separations",
      {"The paper shows one run, ours are means of the successful plans (`dcpso-solo` has none: of all feasible "
       "ones).",
       "dis_min,23 and the length of UAV 3 alone hang on the obstacles, which differ."});
  add(tables, table4(results), "rendezvous.table4", "Table 4: statistics",
      {"A plan is a success if it is feasible and its lengths differ by at most 0.35 km; means are of the successes "
       "(`dcpso-solo` has none: of all feasible plans).",
       "What section 4.1 calls the mean largest difference (0.0301 and 0.1515 km) is the difference of the largest and "
       "the least mean length of the table, so that is what stands beside it; the mean of each run's largest "
       "difference "
       "is the row below.",
       "The paper's 27 of 30 is a rate of 0.900 with a Wilson interval of [0.744, 0.965], 13 of 30 one of "
       "[0.274, 0.608].",
       "Our time is that of all three planners one after the other, with what they exchange."});
  add(tables, readings(results), "rendezvous.readings", "Table 4 again: what the paper leaves open",
      {"`dcpso-paper` by reading. First: Lref of Eq. 16 taken from the best particles by their own cost (Eq. 11) or by "
       "the modified one (Eq. 14). Second: stored costs of personal and group bests refreshed in each generation, or "
       "left as stored. Third: Vmax as a share of the search range. The first reading is `dcpso-paper`'s default.",
       "`ccga` has the modified reference by default, which makes it conventional; last, with DCPSO's own."});
  add(tables, curves(results, "curves2d", "rendezvous-2d", false), "rendezvous.curves2d",
      "Fig. 4 and 5: paths and curvature",
      {"The paper prints curves alone; ours are drawn by `deploy/figures.sh` and stand in "
       "[families/rendezvous.md](families/rendezvous.md#figures). The limit is 2 per km (section 4.1, p. 11)."});
}

void add_space(std::vector<Table>& tables, const Results& results) {
  add(tables, table6(results, "rendezvous-3d-free"), "rendezvous.table6", "Table 6: in space, without obstacles",
      {"The paper's cylinders and no-fly zones are in its figures only. Without any (`obstacles` and `no_fly` empty, "
       "no "
       "margin) the lengths are the paper's; the paper shows one run, ours are means of the successful plans."});
  add(tables, table6(results, "rendezvous-3d"), "rendezvous.table6b",
      "Table 6 again: with our cylinders, boxes and hills",
      {"The second cylinder stands in the way that UAV 3 would take alone."});
  add(tables, curves(results, "curves3d", "rendezvous-3d", true), "rendezvous.curves3d",
      "Fig. 6 and 7: paths, curvature and torsion in space",
      {"The paper prints curves alone; ours stand in [families/rendezvous.md](families/rendezvous.md#figures). Both "
       "limits are 2 per km (section 4.2, p. 13). The method as printed holds a path to them at 50 points, `dcpso` "
       "everywhere."});
}

}  // namespace

std::vector<Table> rendezvous_tables(const Results& results) {
  std::vector<Table> tables;
  add_plane(tables, results);
  add_space(tables, results);
  return tables;
}

}  // namespace skein::reproduce
