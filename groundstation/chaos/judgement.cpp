#include "groundstation/chaos/judgement.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "groundstation/inprocess/in_process.hpp"
#include "simworld/report/report.hpp"

namespace skein::chaos {
namespace {

constexpr int kStartUp = 3;

/// 0 after a run, 4 when the world went on without it; of whom the fault befell a kill where the fault is one, or stops
/// an agent: one that stands still when the run is over is killed by the launcher, and one that is cut off until then
/// is asked to end. Of a run that never began all are turned away, or asked to end.
bool is_explained(const std::string& ended_by, AgentId agent, const RunOutcome& outcome) {
  if (outcome.exit_code == kStartUp && (ended_by == "exit status 3" || ended_by == "exit status 143")) return true;
  if (ended_by == "exit status 0" || ended_by == "exit status 4") return true;
  if (std::ranges::find(outcome.befallen, agent) == outcome.befallen.end()) return false;
  return ended_by == (outcome.kind == Kind::Partition ? "exit status 143" : "signal 9 (Killed)");
}

void note_recovery(const nlohmann::json& report, const std::vector<RosterChange>& changes, double step_s,
                   RunOutcome& outcome) {
  for (const double seconds : report.value("world_recovery_s", std::vector<double>{})) {
    outcome.recovery_s = std::max(outcome.recovery_s.value_or(0.0), seconds);
    outcome.recovery_steps = 0;
  }
  for (auto back = changes.begin(); back != changes.end(); ++back) {
    if (back->reason != LossReason::Rejoined) continue;
    const auto loss = std::find_if(changes.begin(), back, [&](const RosterChange& change) {
      return change.agent == back->agent && change.incarnation + 1 == back->incarnation;
    });
    if (loss == back) continue;
    const std::uint32_t steps = back->step - loss->step;
    outcome.recovery_steps = std::max(outcome.recovery_steps.value_or(0), steps);
    outcome.recovery_s = std::max(outcome.recovery_s.value_or(0.0), steps * step_s);
  }
}

/// Whether maps that had the time are equal, and all plans flown were accepted.
void note_agreement(const nlohmann::json& report, RunOutcome& outcome) {
  outcome.maps_due = report.value("maps_due", std::size_t{0});
  outcome.maps_differ = report.value("maps_differ", std::size_t{0});
  if (report.at("unaccepted_plans") == 0) return;
  const nlohmann::json& first = report.at("first_unaccepted_plan");
  outcome.unaccepted.push_back(fmt::format("{} agent-rounds, first agent {} at step {}",
                                           report.at("unaccepted_plans").dump(), first.at("agent").dump(),
                                           first.at("step").dump()));
}

}  // namespace

void judge(const nlohmann::json& report, const Scenario& scenario, RunOutcome& outcome) {
  if (!report.is_object() || report.value("reason", "").empty()) {
    outcome.result = Result::Degraded;
    outcome.reason = "there is no report";
    outcome.unexplained.push_back(fmt::format("no report, exit code {}", outcome.exit_code));
    return;
  }
  outcome.reason = report.at("reason");
  outcome.state_hash = report.at("state_hash");
  outcome.result = outcome.exit_code == 0 ? Result::Completed : Result::Degraded;
  if (report.at("collisions").get<int>() > 0) outcome.result = Result::Unsafe;
  if (report.at("exit_code") != outcome.exit_code) {
    outcome.unexplained.push_back(
        fmt::format("exit code {}, of the report {}", outcome.exit_code, report.at("exit_code").dump()));
  }
  for (const auto& process : report.value("processes", nlohmann::json::array())) {
    const std::string ended_by = process.at("ended_by");
    if (is_explained(ended_by, process.at("agent").get<AgentId>(), outcome)) continue;
    outcome.unexplained.push_back(fmt::format("agent {}: {}", process.at("agent").dump(), ended_by));
  }
  note_agreement(report, outcome);
  if (outcome.exit_code == kStartUp) return;  // there is no run to repeat
  InProcessOptions options;
  options.replay = roster_changes_of(report);
  note_recovery(report, options.replay, scenario.mission.step_s, outcome);
  const InProcessResult replay = run_in_process(scenario, options);
  outcome.replay_differs = replay.report.at("state_hash") != outcome.state_hash;
}

}  // namespace skein::chaos
