#include <fmt/core.h>

#include <array>

#include "groundstation/html/page.hpp"
#include "groundstation/html/page_parts.hpp"
#include "groundstation/html/pages.hpp"
#include "groundstation/sweep/table.hpp"

namespace skein::html {
namespace {

using figure::SweepInput;

constexpr std::size_t kMostFailures = 100;
constexpr std::array<const char*, 6> kStatistics{"mean", "sd", "min", "p50", "p95", "max"};

std::string row_title(const Json& row) {
  const std::string title = title_of(row);
  return title.empty() ? "all runs" : title;
}

std::string rate_text(const Json& rate) {
  if (!rate.is_object()) return "–";
  return fmt::format("{}: {:.4f} [{:.4f}, {:.4f}]", rate.value("count", 0), rate.value("rate", 0.0),
                     rate.value("low", 0.0), rate.value("high", 0.0));
}

void add_rates(Page& page, const Json& table) {
  page.heading("Rates, with Wilson's interval of 95 %");
  std::vector<std::vector<std::string>> rows;
  for (const Json& entry : table) {
    rows.push_back({row_title(entry), text_of(entry.value("runs", Json())), rate_text(entry.value("success", Json())),
                    rate_text(entry.value("plan_success", Json())), rate_text(entry.value("plan_feasible", Json()))});
  }
  page.table({"row", "runs", "success", "plan successful", "plan feasible"}, rows);
}

/// Figures of the run as a whole: those of single vehicles and pairs are in the JSON.
void add_statistics(Page& page, const Json& rows) {
  page.heading("Figures over all runs");
  std::vector<std::vector<std::string>> lines;
  for (const auto& [name, unused] : rows.front().at("figures").items()) {
    if (name.starts_with("vehicles.") || name.starts_with("separations.")) continue;
    for (const Json& row : rows) {
      const auto found = row.at("figures").find(name);
      if (found == row.at("figures").end()) continue;
      std::vector<std::string> line{name, row_title(row)};
      for (const char* statistic : kStatistics) line.push_back(text_of(found->value(statistic, Json())));
      lines.push_back(std::move(line));
    }
  }
  std::vector<std::string> columns{"figure", "row"};
  columns.insert(columns.end(), kStatistics.begin(), kStatistics.end());
  page.table(columns, lines);
}

void add_failures(Page& page, const Json& rows) {
  std::vector<std::vector<std::string>> lines;
  std::size_t count = 0;
  for (const Json& row : rows) {
    for (const Json& failure : row.at("failures")) {
      if (++count > kMostFailures) continue;
      lines.push_back({row_title(row), text_of(failure.value("seed", Json())), failure.value("reason", "")});
    }
  }
  page.heading(fmt::format("Runs that failed: {}", count));
  if (lines.empty()) return;
  page.table({"row", "seed", "reason"}, lines);
  if (count > lines.size()) page.paragraph(fmt::format("{} more are in the JSON.", count - lines.size()));
}

std::string seeds_of(const Json& rows) {
  const Json& runs = rows.front().at("per_run");
  if (runs.empty()) return "–";
  return fmt::format("{} to {}", text_of(runs.front().value("seed", Json())),
                     text_of(runs.back().value("seed", Json())));
}

std::string version_row(const Json& document, const Drawn& drawn) {
  return document.value("version", drawn.version);
}

}  // namespace

std::string page_of(const SweepInput& input, const Drawn& drawn) {
  const Json& rows = input.document.at("rows");
  const std::string scenario = input.document.value("scenario", "");
  Page page("Sweep of " + scenario);
  page.notes(input.notes);
  page.facts({{"scenario", scenario},
              {"rows", std::to_string(rows.size())},
              {"runs of each row", text_of(rows.front().at("runs"))},
              {"seeds", seeds_of(rows)},
              {"Skein", version_row(input.document, drawn)}});
  add_figures(page, drawn);
  add_rates(page, input.document.at("table"));
  add_statistics(page, rows);
  add_failures(page, rows);
  page.heading("Commands that made it");
  page.preformatted(input.command.empty() ? drawn.command : input.command + "\n" + drawn.command);
  add_scenario(page, input.scenario_text);
  Json hashes = Json::array();
  for (const Json& row : rows) {
    for (const Json& run : row.at("per_run")) {
      hashes.push_back({{"row", row_title(row)},
                        {"seed", run.value("seed", Json())},
                        {"exit_code", run.value("exit_code", Json())},
                        {"state_hash", run.value("state_hash", Json())}});
    }
  }
  page.objects("State hashes", hashes, 400);
  page.paragraph(fmt::format("Written by skein {} from {}.", drawn.version, input.name));
  return page.text();
}

}  // namespace skein::html
