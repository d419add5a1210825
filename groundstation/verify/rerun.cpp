#include "groundstation/verify/rerun.hpp"

#include <fmt/core.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "groundstation/inprocess/in_process.hpp"
#include "groundstation/record/recording.hpp"
#include "groundstation/record/tap.hpp"
#include "simworld/report/report.hpp"
#include "simworld/report/steering_report.hpp"

namespace skein {
namespace {

std::string fact(const mcap::Metadata& metadata, const std::string& name) {
  const auto found = metadata.texts.find(name);
  if (found == metadata.texts.end()) throw std::runtime_error(fmt::format("its metadata lacks {}", name));
  return found->second;
}

mcap::Metadata facts_of(const mcap::Reader& file) {
  const auto metadata = file.metadata("skein.scenario");
  if (!metadata) {
    throw std::runtime_error(
        "it holds no scenario to run again: record with skein run --record, or name the "
        "scenario: skein record SCENARIO");
  }
  return *metadata;
}

std::uint64_t seed_of(const mcap::Metadata& metadata) {
  const std::string text = fact(metadata, "seed");
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || end != text.data() + text.size()) throw std::runtime_error("its seed is none: " + text);
  return seed;
}

/// What happened to the run: of losses with the reasons that the report tells, if it is there. Best effort, a recorder
/// may lack an obstacle's sample; the report has it.
void add_events(const mcap::Reader& file, const RecordedRun& recorded, InProcessOptions& options) {
  options.replay = recorded.roster_changes();
  options.orders = recorded.orders();
  options.injections = recorded.injections();
  const auto report = file.attachment(kReportName);
  if (!report) return;
  const auto json = nlohmann::json::parse(report->data, nullptr, false);
  if (json.is_discarded()) throw std::runtime_error("its report is no JSON");
  options.replay = roster_changes_of(json);
  options.injections = injections_of(json);
}

}  // namespace

Scenario scenario_of(const mcap::Reader& file) {
  const mcap::Metadata metadata = facts_of(file);
  const auto attachment = file.attachment(kScenarioName);
  if (!attachment) throw std::runtime_error("its scenario is not attached");
  std::vector<Override> overrides;
  const auto list = nlohmann::json::parse(fact(metadata, "overrides"), nullptr, false);
  if (!list.is_array()) throw std::runtime_error("its overrides are no list");
  for (const auto& item : list) overrides.push_back({item.value("key", ""), item.value("value", "")});
  const std::string text(attachment->data.begin(), attachment->data.end());
  ScenarioResult result = parse_scenario(text, fact(metadata, "path"), overrides, seed_of(metadata));
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

RecordedRun rerun(const mcap::Reader& file, const RecordedRun& recorded,
                  const std::function<std::optional<int>()>& interrupted) {
  const Scenario scenario = scenario_of(file);
  InProcessOptions options;
  options.fail_fast = fact(facts_of(file), "fail_fast") == "true";
  add_events(file, recorded, options);
  options.signal = interrupted;
  RecordedRun again;
  options.tap = [&](AgentId, const wire::Sample& sample) { again.add(topic_of(sample), payload_of(sample)); };
  (void)run_in_process(scenario, options);
  return again;
}

}  // namespace skein
