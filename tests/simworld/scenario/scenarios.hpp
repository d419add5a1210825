// What the scenario tests share: where the example files are, and results unwrapped.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "simworld/scenario/scenario.hpp"

namespace skein::test {

inline const std::string kDataDir = SKEIN_SOURCE_DIR "/tests/data/";
inline const std::string kScenarioDir = SKEIN_SOURCE_DIR "/deploy/scenarios/";

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The line of the fault, or 'no fault'.
inline std::string fault_line(const ScenarioResult& result) {
  const auto* fault = std::get_if<ScenarioFault>(&result);
  return fault == nullptr ? "no fault" : fault->line();
}

/// The scenario; a failed test and an empty one if there is a fault.
inline Scenario scenario_of(const ScenarioResult& result) {
  const auto* scenario = std::get_if<Scenario>(&result);
  EXPECT_NE(scenario, nullptr) << fault_line(result);
  return scenario == nullptr ? Scenario{} : *scenario;
}

inline ScenarioResult load_small(const std::vector<Override>& overrides) {
  return load_scenario(kDataDir + "small.yaml", overrides, std::nullopt);
}

}  // namespace skein::test
