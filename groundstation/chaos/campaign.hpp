// Many runs of one scenario over real processes, each with one fault, and a table of what came of them.
//
// Run i has seed S + i and kind i modulo the number of kinds; whom the fault befalls and when is drawn from the stream
// (S, Chaos, i) for the run as it is undisturbed, which one process finds out first. One run at a time: a run has the
// machine's ports and cores for itself. The folder of a run that broke an invariant is kept. Source: own. Departs from
// source: none.
#pragma once

#include <nlohmann/json.hpp>

#include "groundstation/chaos/outcome.hpp"

namespace skein::chaos {

struct CampaignPlan {
  std::string binaries;
  std::string folder;  ///< in which each run has one of its own
  Scenario scenario;
  std::vector<std::string> arguments;  ///< of skein run, without --seed
  std::vector<Disturbance> kinds;      ///< at least one
  std::uint64_t seed = 0;
  std::uint32_t runs = 1;
  double limit_s = 120.0;
  std::string journal;                                         ///< file of journal.hpp; empty for none
  std::function<bool()> interrupted;                           ///< asked all the time
  std::function<void(const RunOutcome&, std::size_t)> on_run;  ///< after each that is made, with how many are done
};

/// @throws std::invalid_argument with one line if a seed leaves the scenario no room @throws JournalRefused
[[nodiscard]] std::vector<RunOutcome> run_campaign(const CampaignPlan& plan);

/// {"runs", "completed", "degraded", "unsafe", "hangs", "orphans", "leftovers", "unexplained", "replay_mismatches",
/// "maps_judged", "maps_differ", "unaccepted_plans", "faults": per kind the same counts, "recovery_steps" and
/// "recovery_s" (mean, max) and "reasons" of what was degraded, "per_run": json_of}.
[[nodiscard]] nlohmann::ordered_json summary_of(const std::vector<RunOutcome>& outcomes);

/// The same for a person: a line a kind, the reasons, and each run that broke an invariant.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& summary);

}  // namespace skein::chaos
