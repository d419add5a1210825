// The runs that the tables are made of: each campaign is a sweep of one scenario, as `skein sweep` would run it.
//
// Seeds count from 0; run i of each combination has seed i. What a campaign gives is the sweep's rows (a combination
// of values each) and their table, so every figure can be had again by `skein sweep`.
// Source: papers/001, section 4; papers/004, section IV. Departs from source: more seeds.
// Complexity: the sum of the runs.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "groundstation/reproduce/paper_figures.hpp"
#include "groundstation/sweep/sweep.hpp"

namespace skein::reproduce {

struct Campaign {
  std::string name;  ///< "rendezvous-2d"; unique
  Paper paper = Paper::Rendezvous;
  std::string scenario;        ///< one of scenario_text
  std::vector<SweptKey> keys;  ///< as of a sweep
  std::uint32_t quick_runs;    ///< of each combination
  std::uint32_t full_runs;     ///< of each combination
  double run_cost_s;           ///< about what a run takes of one core; for the time left alone (peach: ten times)
};

[[nodiscard]] std::vector<Campaign> campaigns_of(Paper paper);

struct CampaignOptions {
  bool quick = false;
  std::optional<std::uint32_t> seeds;  ///< instead of each campaign's own number of runs
  unsigned jobs = 1;                   ///< threads; what comes out does not depend on it
  std::function<bool()> stop;          ///< asked between runs; empty for never
  std::string journals;                ///< folder with a journal (journal.hpp) of each campaign; empty for none
  /// Called in any thread, one at a time: the campaign, its runs, the share of all work that is done, and that share of
  /// it which the journals had.
  std::function<void(const Campaign&, std::size_t done, std::size_t of, double share, double before)> on_progress;
};

struct CampaignResult {
  Campaign campaign;
  std::uint32_t runs = 0;        ///< of each combination, as asked for
  nlohmann::ordered_json rows;   ///< as run_sweep
  nlohmann::ordered_json table;  ///< as table_of
};

struct Results {
  bool complete = true;  ///< false: stopped; the last campaign may have fewer runs, and others are missing
  std::vector<CampaignResult> campaigns;
};

[[nodiscard]] std::uint32_t runs_of(const Campaign& campaign, const CampaignOptions& options);

/// One after the other. @throws std::invalid_argument if a scenario is not valid, JournalRefused
[[nodiscard]] Results run_campaigns(std::span<const Campaign> campaigns, const CampaignOptions& options);

/// What one combination gave: the sweep's row, and its entry in the table.
struct Combination {
  const nlohmann::ordered_json* row = nullptr;
  const nlohmann::ordered_json* entry = nullptr;
};

/// The combination of a campaign that has all of these values and at least one run; none if it was not run.
[[nodiscard]] std::optional<Combination> combination_of(const Results& results, const std::string& campaign,
                                                        std::span<const Override> values);

/// The sweep's command line that gives a campaign's figures, with the scenario's path in the source tree.
[[nodiscard]] std::string command_of(const Campaign& campaign, std::uint32_t runs);

}  // namespace skein::reproduce
