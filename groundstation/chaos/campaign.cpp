#include "groundstation/chaos/campaign.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "groundstation/inprocess/in_process.hpp"
#include "groundstation/sweep/journal.hpp"
#include "planner/core/hash/state_hash.hpp"

namespace skein::chaos {
namespace {

using Json = nlohmann::ordered_json;

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

/// The first runs of a campaign are the same however many there are.
std::uint64_t identity_of(const CampaignPlan& plan) {
  StateHash hash;
  hash.add(plan.scenario.scenario_hash).add(plan.seed);
  for (const Disturbance& kind : plan.kinds) hash.add(kind.kind).add(kind.amount);
  return hash.value();
}

RunOutcome read_again(const Json& run, const std::string& journal) {
  try {
    return outcome_of(run);
  } catch (const std::runtime_error& error) {
    throw JournalRefused(fmt::format("{}: seed {}: {}", journal, run.at("seed").dump(), error.what()));
  }
}

RunOutcome run_one(const CampaignPlan& plan, std::uint32_t index) {
  RunPlan run{plan.binaries,
              fmt::format("{}/{}", plan.folder, index),
              seeded(plan.scenario, plan.seed + index),
              plan.arguments,
              plan.limit_s,
              plan.interrupted};
  run.arguments.insert(run.arguments.begin(), {"--seed", std::to_string(plan.seed + index)});
  RandomStream random(plan.seed, kWorldId, Purpose::Chaos, index);
  const Injection injection = draw(plan.kinds[index % plan.kinds.size()], undisturbed_of(run.scenario),
                                   plan.scenario.lockstep.deadline_s, random);
  std::filesystem::create_directories(run.folder);
  RunOutcome outcome = run_disturbed(run, injection);
  if (outcome.result != Result::Stopped && is_sound(outcome)) std::filesystem::remove_all(run.folder);
  return outcome;
}

}  // namespace

std::vector<RunOutcome> run_campaign(const CampaignPlan& plan) {
  std::optional<RunJournal> journal;
  if (!plan.journal.empty()) journal.emplace(plan.journal, "chaos", std::vector{identity_of(plan)});
  std::vector<RunOutcome> outcomes;
  for (std::uint32_t i = 0; i < plan.runs && !plan.interrupted(); ++i) {
    if (const Json* done = journal ? journal->find(0, plan.seed + i) : nullptr) {
      outcomes.push_back(read_again(*done, plan.journal));
      continue;
    }
    RunOutcome outcome = run_one(plan, i);
    if (outcome.result == Result::Stopped) break;
    outcomes.push_back(std::move(outcome));
    if (journal) journal->add(0, json_of(outcomes.back()));
    if (plan.on_run) plan.on_run(outcomes.back(), outcomes.size());
  }
  return outcomes;
}

}  // namespace skein::chaos
