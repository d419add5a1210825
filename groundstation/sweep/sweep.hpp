// Many runs of one scenario, in this process: every combination of swept values, every seed.
//
// Run i of a combination has seed S + i, plans and flies, and equals `skein run --seed S+i`. Runs are independent and
// spread over threads; results do not depend on their number. With `curves` the first run of each combination leaves
// its curves in files.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "simworld/scenario/scenario.hpp"

namespace skein {

/// A scenario key and the values it takes in turn.
struct SweptKey {
  std::string key;
  std::vector<std::string> values;
};

struct SweepPlan {
  std::string scenario;  ///< the file
  std::string text;      ///< the scenario itself, if it is in no file: then `scenario` only names it in messages
  std::vector<SweptKey> keys;
  std::uint64_t first_seed = 0;
  std::uint32_t runs = 1;                                             ///< of each combination
  unsigned jobs = 1;                                                  ///< threads
  std::string curves;                                                 ///< folder for curves.hpp; empty for none
  std::string journal;                                                ///< file of journal.hpp; empty for none
  std::function<bool()> stop;                                         ///< asked between runs; empty for never
  std::function<void(std::size_t done, std::size_t of)> on_progress;  ///< called in any thread, one at a time
  std::function<void(std::size_t done)> on_resume;                    ///< once, of a journal: what was done before
};

struct SweepResult {
  bool stopped = false;  ///< not all runs were made
  /// One per combination: set, runs, success_rate, failures, figures {name: mean, sd, min, p50, p95, max}, per_run
  /// (seed, exit_code, state_hash, reason, plan_feasible, plan_success, figures).
  nlohmann::ordered_json rows;
};

/// Every combination of the plan's values, as overrides; one empty combination if there are no keys.
[[nodiscard]] std::vector<std::vector<Override>> combinations_of(const std::vector<SweptKey>& keys);

/// The figures of one report: its numbers, those of its vehicles by id and of its pairs of vehicles, and
/// longest_path_m.
[[nodiscard]] nlohmann::ordered_json figures_of(const nlohmann::ordered_json& report);

/// mean, sd (n - 1), min, p50, p95 (nearest rank), max. @pre values is not empty
[[nodiscard]] nlohmann::ordered_json summary_of(std::vector<double> values);

/// @throws std::invalid_argument with one line if a combination is not a valid scenario; CurvesNotWritten if curves
/// cannot be, before the first run if the folder does not allow it; JournalRefused.
[[nodiscard]] SweepResult run_sweep(const SweepPlan& plan);

}  // namespace skein
