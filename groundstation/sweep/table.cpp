#include "groundstation/sweep/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "groundstation/sweep/sweep.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kZ = 1.96;

/// Names end in these, whichever vehicles they are of.
constexpr std::array<std::string_view, 8> kShown{"planned_length_m", "plan_spread_m", "longest_path_m", "arrived",
                                                 "total_path_m",     "planned_m",     "flown_m",        "plan_s"};

bool is_shown(const std::string& name) {
  return std::ranges::any_of(kShown, [&](std::string_view end) {
    return name == end || (name.ends_with(end) && name[name.size() - end.size() - 1] == '.');
  });
}

Json rate_of(std::size_t count, std::size_t of) {
  if (of == 0) return {{"count", 0}, {"rate", nullptr}, {"low", nullptr}, {"high", nullptr}};
  const Interval95 interval = interval_of(count, of);
  return {{"count", count},
          {"rate", static_cast<double>(count) / static_cast<double>(of)},
          {"low", interval.low},
          {"high", interval.high}};
}

Json mean_of(const std::vector<double>& values) {
  const Json summary = summary_of(values);
  const double mean = summary.at("mean");
  const double half = kZ * summary.at("sd").get<double>() / std::sqrt(static_cast<double>(values.size()));
  return {
      {"count", values.size()}, {"mean", mean}, {"sd", summary.at("sd")}, {"low", mean - half}, {"high", mean + half}};
}

std::size_t count_if(const Json& runs, const char* key) {
  return static_cast<std::size_t>(std::ranges::count_if(runs, [&](const Json& run) { return run.at(key) == true; }));
}

Json entry_of(const Json& row) {
  const Json& runs = row.at("per_run");
  const std::size_t successes = count_if(runs, "plan_success");
  const std::size_t feasible = count_if(runs, "plan_feasible");
  const auto arrived = std::ranges::count_if(runs, [](const Json& run) { return run.at("exit_code") == 0; });
  Json entry;
  entry["set"] = row.at("set");
  entry["runs"] = runs.size();
  const bool plans = !runs.empty() && !runs[0].at("plan_success").is_null();
  if (plans) {
    entry["plan_success"] = rate_of(successes, runs.size());
    entry["plan_feasible"] = rate_of(feasible, runs.size());
  }
  entry["success"] = rate_of(static_cast<std::size_t>(arrived), runs.size());
  entry["over"] = !plans ? "all runs" : successes > 0 ? "successful plans" : feasible > 0 ? "feasible plans" : "none";
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  for (const Json& run : runs) {
    if (plans && run.at(successes > 0 ? "plan_success" : "plan_feasible") != true) continue;
    for (const auto& [name, value] : run.at("figures").items()) {
      if (!is_shown(name)) continue;
      if (!columns.contains(name)) names.push_back(name);
      columns[name].push_back(value.get<double>());
    }
  }
  entry["figures"] = Json::object();
  for (const std::string& name : names) entry["figures"][name] = mean_of(columns[name]);
  return entry;
}

std::string rate_text(const Json& rate) {
  if (rate.at("rate").is_null()) return "-";
  return fmt::format("{:.4f} [{:.4f}, {:.4f}]", rate.at("rate").get<double>(), rate.at("low").get<double>(),
                     rate.at("high").get<double>());
}

std::string mean_text(const Json& figures, const std::string& name) {
  if (!figures.contains(name)) return "-";
  const Json& figure = figures.at(name);
  const int digits = name == "plan_s" ? 4 : 2;
  const double mean = figure.at("mean");
  return fmt::format("{:.{}f} +-{:.{}f} ({:.{}f})", mean, digits, figure.at("high").get<double>() - mean, digits,
                     figure.at("sd").get<double>(), digits);
}

bool is_of_a_pair(const std::string& name) {
  return name.starts_with("separations.");
}

}  // namespace

bool is_printed(const std::string& name, const Json& figures) {
  if (!is_of_a_pair(name)) return true;
  const std::string kind = name.substr(name.rfind('.'));
  std::size_t pairs = 0;
  for (const auto& [other, figure] : figures.items()) {
    pairs += is_of_a_pair(other) && other.ends_with(kind) ? 1 : 0;
  }
  return pairs <= kPairsPrinted;
}

Interval95 interval_of(std::size_t count, std::size_t of) {
  const double n = static_cast<double>(of);
  const double p = static_cast<double>(count) / n;
  const double scale = 1.0 + kZ * kZ / n;
  const double centre = (p + kZ * kZ / (2.0 * n)) / scale;
  const double half = kZ * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n)) / scale;
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Json table_of(const Json& rows) {
  Json table = Json::array();
  for (const Json& row : rows) table.push_back(entry_of(row));
  return table;
}

std::string title_of(const Json& row) {
  std::string title;
  for (const auto& [key, value] : row.at("set").items()) {
    title += title.empty() ? "" : ", ";
    title += (key == "planner.name" ? "" : key + "=") + value.get<std::string>();
  }
  return title.empty() ? "as in the scenario" : title;
}

std::string text_of_table(const Json& table) {
  constexpr std::string_view kLine = "{:<32}";
  std::vector<std::string> names;
  std::size_t width = 30;
  for (const Json& entry : table) {
    width = std::max(width, title_of(entry).size() + 2);
    for (const auto& [name, figure] : entry.at("figures").items()) {
      if (!is_printed(name, entry.at("figures"))) continue;
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  std::string text;
  const auto line = [&](const std::string& name, const auto& cell_of) {
    text += fmt::format(kLine, name);
    for (const Json& entry : table) text += fmt::format("{:>{}}", cell_of(entry), width);
    text += '\n';
  };
  line("", [](const Json& entry) { return title_of(entry); });
  line("runs", [](const Json& entry) { return entry.at("runs").dump(); });
  for (const char* rate : {"plan_success", "plan_feasible", "success"}) {
    if (!table.empty() && !table[0].contains(rate)) continue;
    line(rate, [&](const Json& entry) { return rate_text(entry.at(rate)); });
  }
  line("mean +-95 % (sd) over", [](const Json& entry) { return entry.at("over").get<std::string>(); });
  for (const std::string& name : names) {
    line(name, [&](const Json& entry) { return mean_text(entry.at("figures"), name); });
  }
  return text;
}

}  // namespace skein
