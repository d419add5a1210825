#include "groundstation/figure/input.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "groundstation/figure/recorded_input.hpp"
#include "groundstation/inprocess/in_process.hpp"
#include "groundstation/mcap/file.hpp"
#include "groundstation/record/tap.hpp"
#include "simworld/report/report.hpp"
#include "simworld/report/steering_report.hpp"

namespace skein::figure {
namespace {

namespace fs = std::filesystem;

constexpr int kSignalled = 128;

std::vector<Override> overrides_of(const Json& report) {
  std::vector<Override> overrides;
  for (const Json& item : report.value("overrides", Json::array())) {
    overrides.push_back({item.value("key", ""), item.value("value", "")});
  }
  return overrides;
}

Scenario scenario_beside(const RunInput& input, const std::string& path) {
  const std::string named = input.scenario_path.empty() ? path : input.scenario_path;
  const auto seed = input.report.at("seed").get<std::uint64_t>();
  ScenarioResult result = parse_scenario(input.scenario_text, named, input.overrides, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  return std::get<Scenario>(std::move(result));
}

/// The run of a report once more; what differs from the report is noted.
void run_again(const Scenario& scenario, RunInput& input) {
  InProcessOptions options;
  RunCollector collector;
  options.fail_fast = input.report.value("fail_fast", false);
  options.replay = roster_changes_of(input.report);
  options.orders = orders_of(input.report);
  options.injections = injections_of(input.report);
  options.tap = [&](AgentId, const wire::Sample& sample) { collector.add(topic_of(sample), payload_of(sample)); };
  const InProcessResult again = run_in_process(scenario, options);
  input.data = collector.data();
  for (const Zone& zone : scenario.mission.zones) input.outlines.push_back(outline_of(zone));
  for (const Announcement& item : scenario.mission.announced) input.outlines.push_back(outline_of(item));
  for (const Obstacle& hidden : scenario.world.hidden) input.outlines.push_back(outline_of(hidden));
  const bool same = again.report.at("state_hash") == input.report.at("state_hash");
  if (same) {
    input.notes.emplace_back("the figures are of the run done again in this process, to the same state hash");
  } else if (input.report.value("exit_code", 0) >= kSignalled) {
    input.notes.emplace_back(
        "the run was interrupted; the figures are of the run done again in this process, to its end");
  } else {
    input.notes.push_back(
        fmt::format("the figures are of the run done again in this process, which ended with another state hash ({})",
                    again.report.at("state_hash").get<std::string>()));
  }
}

RunInput input_of_report(const std::string& name, const fs::path& path) {
  RunInput input;
  input.name = name;
  input.report = Json::parse(text_of_file(path.string()), nullptr, false);
  const bool is_report = input.report.is_object() && input.report.contains("vehicles") &&
                         input.report.contains("state_hash") && input.report.contains("seed");
  if (!is_report) throw std::runtime_error(fmt::format("{}: no report of a run", path.string()));
  const std::string scenario_file = (path.parent_path() / "scenario.yaml").string();
  input.scenario_path = input.report.value("scenario_path", "");
  input.overrides = overrides_of(input.report);
  try {
    input.scenario_text = text_of_file(scenario_file);
    const Scenario scenario = scenario_beside(input, scenario_file);
    const std::string obstacle = replay_obstacle(input.report, scenario, input.report.value("fail_fast", false));
    if (!obstacle.empty()) throw std::runtime_error(fmt::format("{}: {}", scenario_file, obstacle));
    run_again(scenario, input);
  } catch (const std::exception& error) {
    input.notes.push_back(fmt::format("no figures of the run, for it cannot be done again: {}", error.what()));
  }
  return input;
}

bool is_recording(const std::string& text) {
  return text.size() >= mcap::kMagic.size() &&
         std::equal(mcap::kMagic.begin(), mcap::kMagic.end(), text.begin(),
                    [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
}

}  // namespace

std::string text_of_file(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw std::runtime_error(fmt::format("{}: it is a folder", path));
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw std::runtime_error(fmt::format("{}: {}", path, std::strerror(errno)));
  return text;
}

SweepInput input_of_sweep(const std::string& name, Json document) {
  SweepInput input;
  input.name = name;
  input.document = std::move(document);
  input.command = input.document.value("command", "");
  const std::string scenario = input.document.value("scenario", "");
  try {
    input.scenario_text = text_of_file(scenario);
  } catch (const std::exception& error) {
    input.notes.push_back(fmt::format("the scenario is not there any more: {}", error.what()));
  }
  if (!input.document.value("complete", true)) input.notes.emplace_back("the sweep was interrupted");
  return input;
}

Input read_input(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    const fs::path report = fs::path(path) / "report.json";
    if (!fs::exists(report, error)) throw std::runtime_error(fmt::format("{}: it holds no report.json", path));
    return input_of_report(path, report);
  }
  const std::string text = text_of_file(path);
  if (is_recording(text)) return input_of_recording(path);
  Json document = Json::parse(text, nullptr, false);
  if (document.is_object() && document.contains("rows") && document.contains("table")) {
    return input_of_sweep(path, std::move(document));
  }
  if (document.is_object() && document.contains("vehicles")) return input_of_report(path, path);
  throw std::runtime_error(fmt::format("{}: neither a recording, a report.json nor the JSON of a sweep", path));
}

}  // namespace skein::figure
