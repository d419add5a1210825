// Campaigns: sweeps of the scenarios in the source tree, run for run, whatever the number of threads.
#include "groundstation/reproduce/campaign.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "groundstation/reproduce/scenarios.hpp"
#include "groundstation/sweep/table.hpp"
#include "simworld/scenario/scenario.hpp"

namespace skein::reproduce {
namespace {

using Json = nlohmann::ordered_json;

std::string path_of(const std::string& scenario) {
  return SKEIN_SOURCE_DIR "/deploy/scenarios/" + scenario + ".yaml";
}

std::vector<Campaign> all_campaigns() {
  std::vector<Campaign> all = campaigns_of(Paper::Rendezvous);
  for (Campaign& campaign : campaigns_of(Paper::Transit)) all.push_back(std::move(campaign));
  return all;
}

/// Without the figures that depend on the machine's speed.
Json timeless(Json table) {
  for (Json& entry : table) entry["figures"].erase("plan_s");
  return table;
}

CampaignOptions with(std::uint32_t seeds, unsigned jobs) {
  CampaignOptions options;
  options.seeds = seeds;
  options.jobs = jobs;
  return options;
}

TEST(Campaigns, TheirScenariosAreThoseOfTheSourceTree) {
  std::set<std::string> names;
  for (const Campaign& campaign : all_campaigns()) {
    EXPECT_TRUE(names.insert(campaign.name).second) << campaign.name;
    EXPECT_GT(campaign.full_runs, campaign.quick_runs) << campaign.name;
    std::ostringstream text;
    text << std::ifstream(path_of(campaign.scenario)).rdbuf();
    ASSERT_FALSE(text.str().empty()) << campaign.scenario;
    EXPECT_EQ(scenario_text(campaign.scenario), text.str()) << campaign.scenario;
  }
  EXPECT_TRUE(scenario_text("no-such-scenario").empty());
}

TEST(Campaigns, EveryCombinationIsAScenario) {
  for (const Campaign& campaign : all_campaigns()) {
    for (const auto& set : combinations_of(campaign.keys)) {
      const auto result = load_scenario(path_of(campaign.scenario), set, 0);
      const auto* fault = std::get_if<ScenarioFault>(&result);
      EXPECT_EQ(fault, nullptr) << campaign.name << ": " << fault->line();
    }
  }
}

TEST(Campaigns, GiveWhatASweepOfTheFileGives) {
  std::vector<Campaign> campaigns{campaigns_of(Paper::Rendezvous).at(0), campaigns_of(Paper::Transit).at(2)};
  ASSERT_EQ(campaigns[1].keys.back().key, "planner.cell_m");
  campaigns[1].keys.back().values = {"4"};  // the quickest
  const Results results = run_campaigns(campaigns, with(2, 2));
  ASSERT_EQ(results.campaigns.size(), 2U);
  EXPECT_TRUE(results.complete);
  for (const CampaignResult& result : results.campaigns) {
    SweepPlan plan;
    plan.scenario = path_of(result.campaign.scenario);
    plan.keys = result.campaign.keys;
    plan.runs = 2;
    const SweepResult sweep = run_sweep(plan);
    EXPECT_EQ(timeless(result.table), timeless(table_of(sweep.rows))) << result.campaign.name;
    for (std::size_t i = 0; i < sweep.rows.size(); ++i) {
      for (std::size_t run = 0; run < 2; ++run) {
        EXPECT_EQ(result.rows.at(i).at("per_run").at(run).at("state_hash"),
                  sweep.rows.at(i).at("per_run").at(run).at("state_hash"));
      }
    }
  }
}

TEST(Campaigns, QuickAndSeedsChooseTheRuns) {
  const Campaign campaign = campaigns_of(Paper::Rendezvous).at(0);
  CampaignOptions options;
  EXPECT_EQ(runs_of(campaign, options), campaign.full_runs);
  options.quick = true;
  EXPECT_EQ(runs_of(campaign, options), campaign.quick_runs);
  options.seeds = 7;
  EXPECT_EQ(runs_of(campaign, options), 7U);
}

TEST(Campaigns, StoppedTheyKeepWhatWasRun) {
  const std::vector<Campaign> campaigns = campaigns_of(Paper::Rendezvous);
  CampaignOptions options = with(2, 1);
  std::atomic<int> asked{0};
  options.stop = [&] { return ++asked == 3; };
  const Results results = run_campaigns(campaigns, options);
  EXPECT_FALSE(results.complete);
  ASSERT_EQ(results.campaigns.size(), 1U);
  const auto whole = combination_of(results, campaigns[0].name, std::vector<Override>{{"planner.name", "dcpso-solo"}});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->row->at("runs"), 2);
  const auto begun = combination_of(results, campaigns[0].name, std::vector<Override>{{"planner.name", "dcpso-paper"}});
  ASSERT_TRUE(begun);
  EXPECT_EQ(begun->row->at("runs"), 1);
  EXPECT_FALSE(combination_of(results, campaigns[0].name, std::vector<Override>{{"planner.name", "ccga"}}));
  EXPECT_FALSE(combination_of(results, "another", {}));
}

TEST(Campaigns, WhatAJournalHasIsNotRunAgain) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("skein-journals-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::vector<Campaign> campaigns = campaigns_of(Paper::Rendezvous);
  campaigns.resize(2);
  CampaignOptions options = with(1, 1);
  options.journals = folder;
  options.stop = [asked = 0]() mutable { return ++asked == 3; };
  EXPECT_FALSE(run_campaigns(campaigns, options).complete);
  options.stop = {};
  std::size_t made = 0;
  double first_before = 0.0;
  options.on_progress = [&](const Campaign&, std::size_t, std::size_t, double, double before) {
    if (made++ == 0) first_before = before;
  };
  const Results results = run_campaigns(campaigns, options);
  std::filesystem::remove_all(folder);
  EXPECT_EQ(made, 5U) << "of eight runs";
  EXPECT_GT(first_before, 0.0);
  const Results whole = run_campaigns(campaigns, with(1, 1));
  ASSERT_EQ(results.campaigns.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(timeless(results.campaigns[i].table).dump(), timeless(whole.campaigns[i].table).dump());
  }
}

TEST(Campaigns, ProgressEndsAtTheWhole) {
  std::vector<Campaign> campaigns = campaigns_of(Paper::Rendezvous);
  campaigns.resize(2);
  CampaignOptions options = with(1, 1);
  std::vector<double> shares;
  options.on_progress = [&](const Campaign&, std::size_t, std::size_t, double share, double) {
    shares.push_back(share);
  };
  const Results results = run_campaigns(campaigns, options);
  EXPECT_TRUE(results.complete);
  ASSERT_EQ(shares.size(), 8U);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_NEAR(shares.back(), 1.0, 1e-12);
}

TEST(Campaigns, TheirCommandIsThatOfTheSweep) {
  const Campaign campaign{"c", Paper::Transit, "transit-corridor", {{"a", {"1", "2"}}, {"b", {"[]"}}}, 1, 2, 1.0};
  EXPECT_EQ(command_of(campaign, 5),
            "skein sweep deploy/scenarios/transit-corridor.yaml --runs 5 --seed 0 --set a=1,2 --set 'b=[]'");
}

}  // namespace
}  // namespace skein::reproduce
