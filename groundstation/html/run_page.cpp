#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "groundstation/html/page.hpp"
#include "groundstation/html/page_parts.hpp"
#include "groundstation/html/pages.hpp"

namespace skein::html {
namespace {

using figure::RunInput;
using figure::VehicleTrace;

constexpr std::size_t kMostRows = 200;

struct Named {
  const char* key;
  const char* name;
};

// Of the report, in this order; what a report lacks is left out.
constexpr std::array<Named, 33> kFigures{{
    {"steps", "steps flown"},
    {"rounds", "planning rounds"},
    {"plan_feasible", "plan feasible"},
    {"plan_success", "plan successful"},
    {"plan_spread_m", "spread of planned lengths (m)"},
    {"arrived", "arrived"},
    {"total_path_m", "flown by all (m)"},
    {"completed_without", "completed without"},
    {"collisions", "collisions"},
    {"near_misses", "near misses"},
    {"rammed_at_rest", "rammed at rest"},
    {"zone_entries", "entries into announced zones"},
    {"min_separation_m", "least separation (m)"},
    {"min_clearance_m", "least clearance (m)"},
    {"replan_rounds", "planning rounds in the air"},
    {"unaccepted_plans", "unaccepted plans"},
    {"map_equal", "maps equal at the end"},
    {"map_equal_since_step", "maps equal since step"},
    {"maps_differ", "maps that differ"},
    {"discovery_s", "discovery (s)"},
    {"plan_s", "planning (s)"},
    {"rounds_per_s", "rounds per s"},
    {"steps_per_s", "steps per s"},
    {"realtime_factor", "times real time"},
    {"pss_mb_per_agent", "memory of an agent (MB)"},
    {"late_steps", "late steps"},
    {"world_restarts", "world started again"},
    {"refused_samples", "samples refused"},
    {"lost_samples", "samples lost by the world"},
    {"fail_fast", "ends at the first loss"},
    {"planner", "planner"},
    {"carrier", "carrier"},
    {"version", "Skein"},
}};

std::string of_facts(const RunInput& input, const char* name) {
  const auto found = input.facts.find(name);
  return found == input.facts.end() ? "" : found->second;
}

std::string scenario_name(const RunInput& input) {
  const std::string reported = input.report.is_object() ? input.report.value("scenario", "") : "";
  return reported.empty() ? input.data.mission.name : reported;
}

/// Seed, hashes, versions: what makes a run the one that it is.
std::vector<std::pair<std::string, std::string>> identity_of(const RunInput& input) {
  std::vector<std::pair<std::string, std::string>> rows{{"scenario", scenario_name(input)}};
  if (!input.scenario_path.empty()) rows.emplace_back("scenario file", input.scenario_path);
  const bool reported = input.report.is_object();
  rows.emplace_back("seed", reported && input.report.contains("seed") ? input.report.at("seed").dump()
                                                                      : std::to_string(input.data.mission.seed));
  for (const Named& item : {Named{"state_hash", "state hash"}, Named{"scenario_hash", "scenario hash"}}) {
    const bool known = reported && input.report.contains(item.key);
    rows.emplace_back(item.name, known ? text_of(input.report.at(item.key)) : "not known: there is no report");
  }
  for (const Named& item :
       {Named{"recorder", "recorder"}, Named{"version", "recorded by Skein"}, Named{"wire_version", "wire version"},
        Named{"samples", "samples"}, Named{"lost", "samples lost while recording"}}) {
    const std::string value = of_facts(input, item.key);
    if (!value.empty()) rows.emplace_back(item.name, value);
  }
  return rows;
}

std::vector<std::pair<std::string, std::string>> figures_of(const Json& report) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (const Named& item : kFigures) {
    if (report.contains(item.key)) rows.emplace_back(item.name, text_of(report.at(item.key)));
  }
  return rows;
}

double flown_m(const VehicleTrace& vehicle) {
  double length_m = 0.0;
  for (std::size_t k = 1; k < vehicle.flown.size(); ++k) {
    length_m += (vehicle.flown[k].position_m - vehicle.flown[k - 1].position_m).norm();
  }
  return length_m;
}

void add_vehicles(Page& page, const RunInput& input) {
  page.heading("Vehicles");
  std::vector<std::vector<std::string>> rows;
  if (!input.report.is_object() || !input.report.contains("vehicles")) {
    for (const VehicleTrace& vehicle : input.data.vehicles) {
      rows.push_back({std::to_string(vehicle.spec.id), fmt::format("{:.1f}", vehicle.planned_length_m),
                      fmt::format("{:.1f}", flown_m(vehicle)), std::to_string(vehicle.flown.size())});
    }
    page.table({"id", "planned (m)", "flown (m)", "steps that are there"}, rows);
    return;
  }
  for (const Json& vehicle : input.report.at("vehicles")) {
    std::vector<std::string> row;
    for (const char* key : {"id", "status", "planned_length_m", "path_length_m", "arrival_step", "arrival_time_s",
                            "max_curvature_per_m", "max_torsion_per_m", "reason"}) {
      row.push_back(text_of(vehicle.value(key, Json())));
    }
    rows.push_back(std::move(row));
  }
  page.table({"id", "status", "planned (m)", "flown (m)", "arrival step", "arrival (s)", "most curvature (1/m)",
              "most torsion (1/m)", "reason"},
             rows);
}

void add_topics(Page& page, const Json& report) {
  if (!report.contains("topics") || !report.at("topics").is_object()) return;
  page.heading("Topics");
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, counts] : report.at("topics").items()) {
    rows.push_back({"skein/" + name, text_of(counts.value("samples", Json())), text_of(counts.value("bytes", Json()))});
  }
  page.table({"topic", "samples", "bytes"}, rows);
}

void add_radio(Page& page, const Json& report) {
  if (!report.contains("radio") || !report.at("radio").is_object()) return;
  const Json& radio = report.at("radio");
  page.heading("Radio");
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& [name, value] : radio.items()) {
    if (!value.is_array()) rows.emplace_back(words_of(name), text_of(value));
  }
  page.facts(rows);
  page.objects("Radio links", radio.value("links", Json()), kMostRows);
}

std::string made_by(const RunInput& input) {
  std::string command = run_command(input);
  const std::string recorder = of_facts(input, "recorder");
  if (recorder == "attached") {
    return fmt::format("skein record --swarm {} -o {}", shell_word(of_facts(input, "swarm")), shell_word(input.name));
  }
  if (command.empty()) return "";
  const std::string carrier = input.report.is_object() ? input.report.value("carrier", "") : "";
  if (recorder == "in-process" || carrier == "in-process") command += " --in-process";
  if (!recorder.empty()) return command + " --record " + shell_word(input.name);
  return command + " --out " + shell_word(input.name);
}

}  // namespace

std::string run_command(const RunInput& input) {
  if (input.scenario_path.empty()) return "";
  const std::uint64_t seed = input.report.is_object() && input.report.contains("seed")
                                 ? input.report.at("seed").get<std::uint64_t>()
                                 : input.data.mission.seed;
  std::string command = fmt::format("skein run {} --seed {}", shell_word(input.scenario_path), seed);
  for (const Override& item : input.overrides) command.append(" ").append(override_words(item.key, item.value));
  if (input.report.is_object() && input.report.value("fail_fast", false)) command += " --fail-fast";
  return command;
}

std::string rerun_command(const RunInput& input) {
  std::string command = run_command(input);
  if (command.empty()) return "";
  command += " --in-process";
  constexpr std::array kEvents{"roster_changes", "commands", "injections"};
  const bool changed = input.report.is_object() && std::ranges::any_of(kEvents, [&](const char* name) {
                         return !input.report.value(name, Json::array()).empty();
                       });
  if (!changed) return command;
  if (!of_facts(input, "recorder").empty()) return "skein verify " + shell_word(input.name) + " --rerun";
  return command + " --roster " + shell_word(input.name.ends_with(".json") ? input.name : input.name + "/report.json");
}

std::string page_of(const RunInput& input, const Drawn& drawn) {
  const Json& report = input.report;
  const bool reported = report.is_object();
  Page page("Run of " + scenario_name(input));
  if (reported) {
    const bool success = report.value("success", false);
    page.verdict(fmt::format("{}: {} (exit code {})", success ? "success" : "failed", report.value("reason", ""),
                             text_of(report.value("exit_code", Json()))),
                 success);
  } else {
    page.verdict("no report: what the run came to is not known", false);
  }
  page.notes(input.notes).facts(identity_of(input));
  add_figures(page, drawn);
  if (reported) page.heading("Figures of the run").facts(figures_of(report));
  add_vehicles(page, input);
  if (reported) {
    for (const auto& [key, heading] : {std::pair{"roster_changes", "Roster changes"},
                                       {"commands", "Commands"},
                                       {"replans", "New plans under way"},
                                       {"movers", "What moved or appeared"},
                                       {"partitions", "Partitions"},
                                       {"events", "Events"},
                                       {"processes", "Processes"}}) {
      page.objects(heading, report.value(key, Json()), kMostRows);
    }
    add_topics(page, report);
    add_radio(page, report);
  }
  page.heading("Commands that made it");
  const std::string made = made_by(input);
  const std::string again = rerun_command(input);
  page.preformatted((made.empty() ? std::string() : made + "\n") + drawn.command);
  if (!again.empty()) page.paragraph("The same run again, in one process:").preformatted(again);
  if (!input.overrides.empty()) {
    page.heading("Changes to the scenario");
    std::vector<std::vector<std::string>> rows;
    for (const Override& item : input.overrides) rows.push_back({item.key, item.value});
    page.table({"key", "value"}, rows);
  }
  add_scenario(page, input.scenario_text);
  if (reported) page.folded("The whole report.json", report.dump(2));
  page.paragraph(fmt::format("Written by skein {} from {}.", drawn.version, input.name));
  return page.text();
}

}  // namespace skein::html
