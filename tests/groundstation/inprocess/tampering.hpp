// What the tests of the in-process harness share: scenarios by name, and buses that treat samples badly.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "groundstation/inprocess/in_process.hpp"
#include "planner/core/random/random_stream.hpp"

namespace skein::test {

/// rendezvous-2d or rendezvous-2d-b. Simulated deadlines cost nothing, and none may be missed by bad luck.
inline Scenario paper_scenario(std::uint64_t seed, const std::string& name = "rendezvous-2d") {
  ScenarioResult result = load_scenario(SKEIN_SOURCE_DIR "/deploy/scenarios/" + name + ".yaml", {}, seed);
  if (const auto* fault = std::get_if<ScenarioFault>(&result)) throw std::runtime_error(fault->line());
  Scenario scenario = std::get<Scenario>(std::move(result));
  scenario.lockstep.deadline_s = 1000.0;
  return scenario;
}

inline InProcessResult run_with(const Scenario& scenario, bus::Tamper tamper) {
  InProcessOptions options;
  options.tamper = std::move(tamper);
  return run_in_process(scenario, options);
}

/// Shares of all samples that a bus drops, doubles and delays past later ones.
struct Losses {
  double drop = 0.0;
  double duplicate = 0.0;
  double delay = 0.0;
};

/// A bus with these losses; the mission, which is latched, arrives in any case. @param lost counts what was dropped
inline bus::Tamper lossy(std::uint64_t seed, const Losses& losses, std::uint64_t& lost) {
  auto random = std::make_shared<RandomStream>(seed, 0, Purpose::Test, 0);
  return [random, losses, &lost](bus::Transit transit) {
    std::vector<bus::Transit> arrived;
    const bool latched = std::holds_alternative<wire::Mission>(transit.sample);
    if (!latched && random->uniform() < losses.drop) {
      ++lost;
      return arrived;
    }
    const bool twice = random->uniform() < losses.duplicate;
    for (int copy = 0; copy < (twice ? 2 : 1); ++copy) {
      if (random->uniform() < losses.delay) transit.held_takes = static_cast<std::uint32_t>(1 + random->below(4));
      arrived.push_back(transit);
    }
    return arrived;
  };
}

}  // namespace skein::test
