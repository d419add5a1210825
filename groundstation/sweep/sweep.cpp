#include "groundstation/sweep/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "groundstation/sweep/curves.hpp"
#include "groundstation/sweep/journal.hpp"
#include "groundstation/sweep/table.hpp"
#include "planner/rendezvous/point_separation.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

struct Job {
  std::size_t combination = 0;
  std::uint64_t seed = 0;
};

/// What the seed draws is drawn again for each run.
Scenario reseeded(const Scenario& scenario, std::uint64_t seed) {
  ScenarioResult result = with_seed(scenario, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::invalid_argument(fault->line());
  return std::get<Scenario>(std::move(result));
}

Scenario load(const SweepPlan& plan, const std::vector<Override>& set, std::uint64_t seed) {
  ScenarioResult result =
      plan.text.empty() ? load_scenario(plan.scenario, set, seed) : parse_scenario(plan.text, plan.scenario, set, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::invalid_argument(fault->line());
  return std::get<Scenario>(std::move(result));
}

/// Separations of the plan at the planner's own points; none without a plan.
void add_planned_separations(const Mission& mission, const Json& report, Json& figures) {
  if (report.at("plan_feasible") != true) return;
  std::vector<rendezvous::PlannedPath> paths;
  for (const Json& vehicle : report.at("vehicles")) {
    auto particle = vehicle.at("particle").get<std::vector<double>>();
    if (!particle.empty()) paths.push_back({vehicle.at("id").get<AgentId>(), std::move(particle)});
  }
  for (const rendezvous::PointSeparation& pair : rendezvous::point_separations(mission, paths)) {
    figures["separations." + std::to_string(pair.a) + "-" + std::to_string(pair.b) + ".planned_m"] = pair.least_m;
  }
}

Json run_of(const Scenario& scenario, const InProcessResult& result) {
  Json run{{"seed", scenario.mission.seed},
           {"exit_code", result.exit_code},
           {"state_hash", result.report.at("state_hash")},
           {"reason", result.report.at("reason")},
           {"plan_feasible", result.report.at("plan_feasible")},
           {"plan_success", result.report.at("plan_success")}};
  run["figures"] = figures_of(result.report);
  if (!scenario.mission.transit) add_planned_separations(scenario.mission, result.report, run["figures"]);
  return run;
}

Json empty_row(const std::vector<Override>& set) {
  Json row;
  row["set"] = Json::object();
  for (const Override& item : set) row["set"][item.key] = item.value;
  return row;
}

Json row_of(const std::vector<Override>& set, const std::vector<Json>& runs) {
  Json row = empty_row(set);
  Json failures = Json::array();
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  for (const Json& run : runs) {
    if (run.at("exit_code") != 0) failures.push_back({{"seed", run.at("seed")}, {"reason", run.at("reason")}});
    for (const auto& [name, value] : run.at("figures").items()) {
      if (!columns.contains(name)) names.push_back(name);
      columns[name].push_back(value.get<double>());
    }
  }
  row["runs"] = runs.size();
  row["success_rate"] =
      runs.empty() ? 0.0 : 1.0 - static_cast<double>(failures.size()) / static_cast<double>(runs.size());
  row["failures"] = failures;
  row["figures"] = Json::object();
  for (const std::string& name : names) row["figures"][name] = summary_of(columns[name]);
  row["per_run"] = runs;
  return row;
}

}  // namespace

std::vector<std::vector<Override>> combinations_of(const std::vector<SweptKey>& keys) {
  std::vector<std::vector<Override>> combinations{{}};
  for (const SweptKey& swept : keys) {
    std::vector<std::vector<Override>> longer;
    for (const auto& combination : combinations) {
      for (const std::string& value : swept.values) {
        longer.push_back(combination);
        longer.back().push_back({swept.key, value});
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

Json figures_of(const Json& report) {
  Json figures;
  for (const auto& [name, value] : report.items()) {
    if (value.is_number() && name != "seed" && name != "exit_code") figures[name] = value;
  }
  if (report.contains("radio")) {
    for (const auto& [name, value] : report.at("radio").items()) {
      if (value.is_number()) figures["radio." + name] = value;
    }
  }
  double longest_m = 0.0;
  for (const Json& vehicle : report.at("vehicles")) {
    longest_m = std::max(longest_m, vehicle.at("planned_length_m").get<double>());
    for (const auto& [name, value] : vehicle.items()) {
      if (value.is_number() && name != "id" && name != "pid") {
        figures["vehicles." + vehicle.at("id").dump() + "." + name] = value;
      }
    }
  }
  figures["longest_path_m"] = longest_m;
  for (const Json& pair : report.at("separations")) {
    if (!pair.at("flown_m").is_number()) continue;
    figures["separations." + pair.at("a").dump() + "-" + pair.at("b").dump() + ".flown_m"] = pair.at("flown_m");
  }
  return figures;
}

namespace {

/// What row_of(), table_of() and junit_suites() take from a run.
bool is_run(const Json& run) {
  const auto is = [&](const char* key, auto&& holds) { return run.contains(key) && holds(run.at(key)); };
  const auto is_text = [](const Json& value) { return value.is_string(); };
  const auto is_verdict = [](const Json& value) { return value.is_boolean() || value.is_null(); };
  return is("exit_code", [](const Json& value) { return value.is_number_integer(); }) && is("state_hash", is_text) &&
         is("reason", is_text) && is("plan_feasible", is_verdict) && is("plan_success", is_verdict) &&
         is("figures", [](const Json& figures) {
           return figures.is_object() &&
                  std::ranges::all_of(figures, [](const Json& value) { return value.is_number(); });
         });
}

std::optional<RunJournal> journal_of(const SweepPlan& plan, const std::vector<Scenario>& scenarios) {
  if (plan.journal.empty()) return std::nullopt;
  std::vector<std::uint64_t> hashes;
  hashes.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios) hashes.push_back(scenario.scenario_hash);
  return RunJournal(plan.journal, "sweep", hashes, is_run);
}

/// Takes what the journal has, but for the first run of a row, if that is to leave its curves. @return how many
std::size_t take_done(const SweepPlan& plan, const RunJournal& journal, std::vector<std::vector<Json>>& results) {
  std::size_t taken = 0;
  for (std::size_t row = 0; row < results.size(); ++row) {
    for (std::size_t i = plan.curves.empty() ? 0 : 1; i < results[row].size(); ++i) {
      const Json* run = journal.find(row, plan.first_seed + i);
      if (run == nullptr) continue;
      results[row][i] = *run;
      ++taken;
    }
  }
  if (plan.on_resume) plan.on_resume(taken);
  return taken;
}

}  // namespace

SweepResult run_sweep(const SweepPlan& plan) {
  const auto combinations = combinations_of(plan.keys);
  std::vector<Scenario> scenarios;
  scenarios.reserve(combinations.size());
  std::vector<CurveFiles> curves;
  for (const auto& set : combinations) {
    scenarios.push_back(load(plan, set, plan.first_seed));
    if (!plan.curves.empty()) curves.push_back(curve_files(plan.curves, curves.size(), title_of(empty_row(set))));
  }
  for (std::size_t i = 0; i < curves.size(); ++i) write_zones(scenarios[i], curves[i]);
  const std::size_t total = combinations.size() * plan.runs;
  std::vector<std::vector<Json>> results(combinations.size(), std::vector<Json>(plan.runs));
  std::optional<RunJournal> journal = journal_of(plan, scenarios);
  std::size_t done = journal ? take_done(plan, *journal, results) : 0;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t job = next++; job < total && !stopped; job = next++) {
      Json& run = results[job / plan.runs][job % plan.runs];
      if (!run.is_null()) continue;
      try {
        const Scenario scenario = reseeded(scenarios[job / plan.runs], plan.first_seed + job % plan.runs);
        const bool traced = !curves.empty() && job % plan.runs == 0;
        run = run_of(scenario,
                     traced ? run_with_curves(scenario, curves[job / plan.runs]) : run_in_process(scenario, {}));
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
        stopped = true;
        return;
      }
      const std::lock_guard lock(mutex);
      try {
        if (journal) journal->add(job / plan.runs, run);
      } catch (...) {
        failure = std::current_exception();
        stopped = true;
        return;
      }
      if (plan.on_progress) plan.on_progress(++done, total);
      if (plan.stop && plan.stop()) stopped = true;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < plan.jobs; ++i) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  SweepResult result{false, Json::array()};
  for (std::size_t i = 0; i < combinations.size(); ++i) {
    result.stopped = std::erase_if(results[i], [](const Json& run) { return run.is_null(); }) > 0 || result.stopped;
    result.rows.push_back(row_of(combinations[i], results[i]));
  }
  return result;
}

}  // namespace skein
