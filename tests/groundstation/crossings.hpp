// What the tests of whole transits share: scenarios by name, and what a report says of every vehicle.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "simworld/scenario/scenario.hpp"

namespace skein::test {

/// A scenario of deploy/scenarios. Simulated deadlines cost nothing, and none may be missed by bad luck.
inline Scenario transit_scenario(const std::string& name, std::uint64_t seed,
                                 const std::vector<Override>& changes = {}) {
  ScenarioResult result = load_scenario(SKEIN_SOURCE_DIR "/deploy/scenarios/" + name + ".yaml", changes, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  Scenario scenario = std::get<Scenario>(std::move(result));
  scenario.lockstep.deadline_s = 1000.0;
  return scenario;
}

/// How many vehicles of a report have this status.
template <typename Json>
std::size_t count_status(const Json& report, const std::string& status) {
  std::size_t count = 0;
  for (const auto& vehicle : report.at("vehicles")) count += vehicle.at("status") == status ? 1 : 0;
  return count;
}

}  // namespace skein::test
