#include "simworld/scenario/scenario.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "planner/core/hash/state_hash.hpp"
#include "planner/core/text/utf8.hpp"
#include "simworld/scenario/checks.hpp"
#include "simworld/scenario/overrides.hpp"
#include "simworld/scenario/sections.hpp"
#include "simworld/scenario/transit_checks.hpp"
#include "simworld/scenario/yaml_tree.hpp"

namespace skein {
namespace {

constexpr std::size_t kMaxBytes = 1'000'000;

ScenarioFault file_fault(const std::string& path, std::string_view what) {
  return {fmt::format("{}:1:1", path), fmt::format("{}; allowed: a readable scenario file of at most 1 MB", what)};
}

ScenarioFault fault_at(const std::string& path, const scenario::ReadFault& fault) {
  const scenario::Place& place = fault.place();
  const bool is_flag = place.set_key == kAgentsFlag || place.set_key == kControllerFlag;
  return {place.set_key.empty() ? fmt::format("{}:{}:{}", path, place.line, place.column)
                                : fmt::format("{}{}", is_flag ? "" : "--set ", scenario::on_one_line(place.set_key)),
          fault.what()};
}

/// Reports and recordings quote the text: they hold UTF-8 alone.
std::optional<ScenarioFault> fault_of_bytes(const std::string& text, const std::string& path) {
  std::size_t line = 1;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = utf8_size(rest);
    if (size == 0) return ScenarioFault{fmt::format("{}:{}:1", path, line), "not all is UTF-8; allowed: UTF-8 alone"};
    if (rest.front() == '\n') ++line;
    rest.remove_prefix(size);
  }
  return std::nullopt;
}

std::uint64_t hash_of(const std::string& text, std::span<const Override> overrides) {
  StateHash hash;
  hash.add(std::string_view(text)).add(overrides.size());
  for (const Override& change : overrides) hash.add(std::string_view(change.key)).add(std::string_view(change.value));
  return hash.value();
}

}  // namespace

ScenarioResult load_scenario(const std::string& path, std::span<const Override> overrides,
                             std::optional<std::uint64_t> seed) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return file_fault(path, "this is a directory");
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    return file_fault(path, "this is no regular file");  // a pipe might never end
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return file_fault(path, fmt::format("cannot be read ({})", std::strerror(errno)));
  std::string text(kMaxBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return file_fault(path, "cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxBytes) return file_fault(path, "longer than 1 MB");
  return parse_scenario(text, path, overrides, seed);
}

ScenarioResult parse_scenario(const std::string& text, const std::string& path, std::span<const Override> overrides,
                              std::optional<std::uint64_t> seed) {
  if (auto fault = fault_of_bytes(text, path)) return *std::move(fault);
  Scenario scenario;
  scenario.path = path;
  scenario.text = text;
  scenario.overrides.assign(overrides.begin(), overrides.end());
  try {
    scenario::YamlNode root = scenario::parse_yaml(text);
    for (Override& change : scenario.overrides) {
      change.key = scenario::key_of(root, change.key);
      scenario::apply_override(root, change.key, change.value);
    }
    scenario.scenario_hash = hash_of(text, scenario.overrides);
    const scenario::Places places = scenario::read_sections(root, seed, scenario);
    if (scenario.mission.transit) {
      scenario::check_transit(scenario, places);
    } else {
      scenario::check_mission(scenario.mission, places);
    }
  } catch (const scenario::ReadFault& fault) {
    return fault_at(path, fault);
  }
  return scenario;
}

ScenarioResult with_seed(const Scenario& scenario, std::uint64_t seed) {
  const bool drawn = scenario.mission.transit || !scenario.world.surprises.movers.empty();
  if (drawn) return parse_scenario(scenario.text, scenario.path, scenario.overrides, seed);
  Scenario other = scenario;
  other.mission.seed = seed;
  return other;
}

}  // namespace skein
