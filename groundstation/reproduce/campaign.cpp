#include "groundstation/reproduce/campaign.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/reproduce/scenarios.hpp"
#include "groundstation/sweep/table.hpp"

namespace skein::reproduce {
namespace {

const SweptKey kLosses{"radio.loss", {"0.1"}};

std::vector<Campaign> rendezvous_campaigns() {
  const SweptKey planners{"planner.name", {"dcpso-solo", "dcpso-paper", "dcpso", "ccga"}};
  const SweptKey printed{"planner.name", {"dcpso-paper"}};
  constexpr Paper kPaper = Paper::Rendezvous;
  return {
      {"rendezvous-2d", kPaper, "rendezvous-2d", {planners}, 100, 1000, 0.016},
      {"readings",
       kPaper,
       "rendezvous-2d",
       {printed, {"planner.own_reference", {"1", "0"}}, {"planner.refresh_costs", {"1", "0"}}},
       100,
       1000,
       0.016},
      {"velocities", kPaper, "rendezvous-2d", {printed, {"planner.velocity_limit", {"0.1", "0.5"}}}, 100, 1000, 0.016},
      {"ccga-own",
       kPaper,
       "rendezvous-2d",
       {{"planner.name", {"ccga"}}, {"planner.own_reference", {"1"}}},
       100,
       1000,
       0.016},
      {"rendezvous-3d", kPaper, "rendezvous-3d", {planners}, 100, 1000, 0.03},
      {"rendezvous-3d-free",
       kPaper,
       "rendezvous-3d",
       {planners, {"obstacles", {"[]"}}, {"no_fly", {"[]"}}, {"planner.clearance_margin_m", {"0"}}},
       100,
       1000,
       0.025},
  };
}

std::vector<Campaign> transit_campaigns() {
  const SweptKey planners{"planner.name", {"peach", "peach3d-paper", "peach3d"}};
  const SweptKey cells{"planner.cell_m", {"2", "4", "6"}};
  const SweptKey swarms{"vehicles.agents", {"3", "5", "7", "9"}};
  const std::string west = "{x_min_m: 0, y_min_m: 0, z_min_m: 0, x_max_m: 240, y_max_m: 500, z_max_m: 100}";
  const std::string east = "{x_min_m: 270, y_min_m: 0, z_min_m: 0, x_max_m: 500, y_max_m: 500, z_max_m: 100}";
  constexpr Paper kPaper = Paper::Transit;
  return {
      {"fig5-listed", kPaper, "transit-power-station", {kLosses, planners, cells, swarms}, 3, 10, 0.04},
      {"fig5-drawn",
       kPaper,
       "transit-power-station",
       {kLosses,
        planners,
        cells,
        swarms,
        {"draw.from", {"connected"}},
        {"draw.own_goals", {"0"}},
        {"draw.starts", {west}},
        {"draw.goals", {east}}},
       3,
       10,
       0.03},
      {"fig8",
       kPaper,
       "transit-corridor",
       {kLosses, {"planner.name", {"peach3d-paper", "peach3d"}}, {"planner.cell_m", {"1", "2", "3", "4"}}},
       3,
       10,
       0.37},
      {"fig9", kPaper, "transit-power-station-3d", {kLosses, planners, {"vehicles.agents", {"4"}}}, 3, 10, 0.12},
  };
}

std::size_t all_runs(const Campaign& campaign, const CampaignOptions& options) {
  return combinations_of(campaign.keys).size() * runs_of(campaign, options);
}

/// About what the first `done` runs take; peach wanders, and flies ten times as long as the others.
double cost_s(const Campaign& campaign, const CampaignOptions& options, std::size_t done) {
  constexpr double kWanderer = 10.0;
  const std::size_t runs = runs_of(campaign, options);
  double sum_s = 0.0;
  std::size_t left = done;
  for (const auto& set : combinations_of(campaign.keys)) {
    const bool wanders = std::ranges::any_of(set, [](const Override& item) { return item.value == "peach"; });
    sum_s += campaign.run_cost_s * (wanders ? kWanderer : 1.0) * static_cast<double>(std::min(left, runs));
    left -= std::min(left, runs);
  }
  return sum_s;
}

bool has(const nlohmann::ordered_json& set, std::span<const Override> values) {
  return std::ranges::all_of(
      values, [&](const Override& value) { return set.contains(value.key) && set.at(value.key) == value.value; });
}

}  // namespace

std::vector<Campaign> campaigns_of(Paper paper) {
  return paper == Paper::Rendezvous ? rendezvous_campaigns() : transit_campaigns();
}

std::uint32_t runs_of(const Campaign& campaign, const CampaignOptions& options) {
  return options.seeds.value_or(options.quick ? campaign.quick_runs : campaign.full_runs);
}

Results run_campaigns(std::span<const Campaign> campaigns, const CampaignOptions& options) {
  double all_s = 0.0;
  for (const Campaign& campaign : campaigns) all_s += cost_s(campaign, options, all_runs(campaign, options));
  Results results;
  double done_s = 0.0;
  double before_s = 0.0;
  for (const Campaign& campaign : campaigns) {
    SweepPlan plan;
    plan.scenario = campaign.scenario;
    plan.text = std::string(scenario_text(campaign.scenario));
    plan.keys = campaign.keys;
    plan.runs = runs_of(campaign, options);
    plan.jobs = options.jobs;
    plan.stop = options.stop;
    if (!options.journals.empty()) plan.journal = options.journals + "/" + campaign.name + ".jsonl";
    plan.on_resume = [&](std::size_t done) { before_s += cost_s(campaign, options, done); };
    plan.on_progress = [&](std::size_t done, std::size_t of) {
      if (!options.on_progress) return;
      const double share = (done_s + cost_s(campaign, options, done)) / all_s;
      options.on_progress(campaign, done, of, share, before_s / all_s);
    };
    SweepResult swept = run_sweep(plan);
    done_s += cost_s(campaign, options, all_runs(campaign, options));
    nlohmann::ordered_json table = table_of(swept.rows);
    results.campaigns.push_back({campaign, plan.runs, std::move(swept.rows), std::move(table)});
    results.complete = !swept.stopped;
    if (swept.stopped) break;
  }
  return results;
}

std::optional<Combination> combination_of(const Results& results, const std::string& campaign,
                                          std::span<const Override> values) {
  const auto found =
      std::ranges::find(results.campaigns, campaign, [](const CampaignResult& result) { return result.campaign.name; });
  if (found == results.campaigns.end()) return std::nullopt;
  for (std::size_t i = 0; i < found->rows.size(); ++i) {
    const auto& row = found->rows.at(i);
    if (has(row.at("set"), values) && row.at("runs") != 0) return Combination{&row, &found->table.at(i)};
  }
  return std::nullopt;
}

std::string command_of(const Campaign& campaign, std::uint32_t runs) {
  std::string command = fmt::format("skein sweep deploy/scenarios/{}.yaml --runs {} --seed 0", campaign.scenario, runs);
  for (const SweptKey& key : campaign.keys) {
    std::string values;
    for (const std::string& value : key.values) values += (values.empty() ? "" : ",") + value;
    const bool plain = values.find_first_of(" {}[]") == std::string::npos;
    command += plain ? fmt::format(" --set {}={}", key.key, values) : fmt::format(" --set '{}={}'", key.key, values);
  }
  return command;
}

}  // namespace skein::reproduce
