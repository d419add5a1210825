#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "groundstation/chaos/campaign.hpp"

namespace skein::chaos {
namespace {

using Json = nlohmann::ordered_json;

Json counts_of(const std::vector<const RunOutcome*>& outcomes) {
  const auto results = [&](Result result) { return std::ranges::count(outcomes, result, &RunOutcome::result); };
  const auto runs_where = [&](const auto& holds) {
    return std::ranges::count_if(outcomes, [&](const RunOutcome* run) { return holds(*run); });
  };
  std::size_t orphans = 0;
  std::size_t leftovers = 0;
  std::size_t unexplained = 0;
  for (const RunOutcome* outcome : outcomes) {
    orphans += outcome->orphans.size();
    leftovers += outcome->leftovers.size();
    unexplained += outcome->unexplained.size();
  }
  return {{"runs", outcomes.size()},
          {"injected", std::ranges::count(outcomes, true, &RunOutcome::injected)},
          {"completed", results(Result::Completed)},
          {"degraded", results(Result::Degraded)},
          {"unsafe", results(Result::Unsafe)},
          {"hangs", results(Result::Hung)},
          {"orphans", orphans},
          {"leftovers", leftovers},
          {"unexplained", unexplained},
          {"replay_mismatches", std::ranges::count(outcomes, true, &RunOutcome::replay_differs)},
          {"maps_judged", runs_where([](const RunOutcome& run) { return run.maps_due > 0; })},
          {"maps_differ", runs_where([](const RunOutcome& run) { return run.maps_differ > 0; })},
          {"unaccepted_plans", runs_where([](const RunOutcome& run) { return !run.unaccepted.empty(); })}};
}

/// Mean and most of those runs that have the figure; null without one.
template <typename Figure>
Json spread_of(const std::vector<const RunOutcome*>& outcomes, Figure RunOutcome::*figure) {
  double sum = 0.0;
  double most = 0.0;
  std::size_t count = 0;
  for (const RunOutcome* outcome : outcomes) {
    if (!(outcome->*figure)) continue;
    const auto value = static_cast<double>(*(outcome->*figure));
    sum += value;
    most = std::max(most, value);
    ++count;
  }
  if (count == 0) return nullptr;
  return {{"runs", count}, {"mean", sum / static_cast<double>(count)}, {"max", most}};
}

Json of_kind(const std::vector<const RunOutcome*>& outcomes) {
  Json entry = counts_of(outcomes);
  entry["recovery_steps"] = spread_of(outcomes, &RunOutcome::recovery_steps);
  entry["recovery_s"] = spread_of(outcomes, &RunOutcome::recovery_s);
  Json reasons = Json::array();
  for (const RunOutcome* outcome : outcomes) {
    if (outcome->result != Result::Completed) {
      reasons.push_back({{"seed", outcome->seed}, {"reason", outcome->reason}});
    }
  }
  entry["reasons"] = reasons;
  return entry;
}

std::string spread_text(const Json& spread, int digits) {
  if (spread.is_null()) return "-";
  return fmt::format("{:.{}f} ({:.{}f})", spread.at("mean").get<double>(), digits, spread.at("max").get<double>(),
                     digits);
}

std::string row_of(const std::string& name, const Json& counts) {
  const bool spreads = counts.contains("recovery_s");
  const auto count = [&](const char* key) { return counts.at(key).get<int>(); };
  const std::string maps = fmt::format("{}/{}", count("maps_differ"), count("maps_judged"));
  return fmt::format("{:>9} {:>5} {:>5} {:>9} {:>8} {:>6} {:>5} {:>7} {:>6} {:>7} {:>5} {:>14} {:>14}\n", name,
                     count("runs"), count("injected"), count("completed"), count("degraded"), count("unsafe"),
                     count("hangs"), count("orphans"), count("replay_mismatches"), maps, count("unaccepted_plans"),
                     spreads ? spread_text(counts.at("recovery_steps"), 1) : "",
                     spreads ? spread_text(counts.at("recovery_s"), 2) : "");
}

}  // namespace

Json summary_of(const std::vector<RunOutcome>& outcomes) {
  std::vector<const RunOutcome*> all;
  std::map<Kind, std::vector<const RunOutcome*>> kinds;
  Json runs = Json::array();
  for (const RunOutcome& outcome : outcomes) {
    all.push_back(&outcome);
    kinds[outcome.kind].push_back(&outcome);
    runs.push_back(json_of(outcome));
  }
  Json summary = counts_of(all);
  summary["faults"] = Json::object();
  for (const auto& [kind, of] : kinds) summary["faults"][std::string(name_of(kind))] = of_kind(of);
  summary["per_run"] = runs;
  return summary;
}

std::string text_of(const Json& summary) {
  std::string text = fmt::format("{:>9} {:>5} {:>5} {:>9} {:>8} {:>6} {:>5} {:>7} {:>6} {:>7} {:>5} {:>14} {:>14}\n",
                                 "fault", "runs", "done", "completed", "degraded", "unsafe", "hangs", "orphans",
                                 "replay", "maps", "plans", "recovery steps", "recovery s");
  for (const auto& [name, counts] : summary.at("faults").items()) text += row_of(name, counts);
  text += row_of("all", summary);
  for (const Json& run : summary.at("per_run")) {
    if (run.at("result") == "completed" && run.at("sound").get<bool>()) continue;
    text += fmt::format("seed {}, {}: {}: {}\n", run.at("seed").dump(), run.at("fault").get<std::string>(),
                        run.at("result").get<std::string>(), run.at("reason").get<std::string>());
    for (const char* key : {"orphans", "leftovers", "unexplained", "unaccepted_plans"}) {
      for (const Json& item : run.at(key)) text += fmt::format("  {}: {}\n", key, item.get<std::string>());
    }
    if (run.at("maps_differ") != 0) text += "  maps differ that had the time to become equal\n";
    if (run.at("replay_differs").get<bool>()) text += "  its replay has another state hash\n";
  }
  return text;
}

}  // namespace skein::chaos
