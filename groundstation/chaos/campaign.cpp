#include "groundstation/chaos/campaign.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "groundstation/inprocess/in_process.hpp"

namespace skein::chaos {
namespace {

Undisturbed undisturbed_of(const Scenario& scenario) {
  const InProcessResult result = run_in_process(scenario, {});
  Undisturbed run;
  run.rounds = result.report.at("rounds").get<std::uint32_t>();
  const auto steps = result.report.at("steps").get<std::uint32_t>();
  run.steps = steps > scenario.world.extra_steps ? steps - scenario.world.extra_steps : 1;
  run.step_s = scenario.mission.step_s;
  run.agents = ids_of(scenario.mission);
  run.state_hash = result.report.at("state_hash").get<std::string>();
  return run;
}

Scenario seeded(const Scenario& scenario, std::uint64_t seed) {
  ScenarioResult result = with_seed(scenario, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::invalid_argument(fault->line());
  return std::get<Scenario>(std::move(result));
}

}  // namespace

bool is_sound(const RunOutcome& outcome) {
  const bool ended = outcome.result == Result::Completed || outcome.result == Result::Degraded;
  return ended && outcome.orphans.empty() && outcome.leftovers.empty() && outcome.unexplained.empty() &&
         !outcome.replay_differs && outcome.maps_differ == 0 && outcome.unaccepted.empty();
}

std::vector<RunOutcome> run_campaign(const CampaignPlan& plan) {
  std::vector<RunOutcome> outcomes;
  for (std::uint32_t i = 0; i < plan.runs && !plan.interrupted(); ++i) {
    RunPlan run{plan.binaries,
                fmt::format("{}/{}", plan.folder, i),
                seeded(plan.scenario, plan.seed + i),
                plan.arguments,
                plan.limit_s,
                plan.interrupted};
    run.arguments.insert(run.arguments.begin(), {"--seed", std::to_string(plan.seed + i)});
    RandomStream random(plan.seed, kWorldId, Purpose::Chaos, i);
    const Injection injection = draw(plan.kinds[i % plan.kinds.size()], undisturbed_of(run.scenario),
                                     plan.scenario.lockstep.deadline_s, random);
    std::filesystem::create_directories(run.folder);
    const RunOutcome outcome = run_disturbed(run, injection);
    if (outcome.result == Result::Stopped) break;
    outcomes.push_back(outcome);
    if (is_sound(outcome)) std::filesystem::remove_all(run.folder);
    if (plan.on_run) plan.on_run(outcome, outcomes.size());
  }
  return outcomes;
}

}  // namespace skein::chaos
