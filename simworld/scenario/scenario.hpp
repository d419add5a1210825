// A scenario file, read strictly into the mission that agents are told and the options that only the world knows.
//
// The world is the only reader of scenario files. Everything is SI; each dimensional key ends in its unit
// (docs/scenario.md). Reading stops at the first fault and says it in one line; there are no defaults for what a
// mission is about (vehicles, formation), only for planner, lockstep and world options.
// Source: papers/001, Tables 1 and 2, for what a rendezvous is made of. Departs from source: none.
// Complexity: O(text + vehicles^2 + vehicles * zones).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "planner/core/mission/mission.hpp"
#include "simworld/collision/obstacle.hpp"
#include "simworld/movers/surprises.hpp"

namespace skein {

/// What is wrong with a scenario, and where.
struct ScenarioFault {
  std::string where;    ///< FILE:LINE:COLUMN, or `--set KEY` for an overridden value
  std::string message;  ///< what is wrong, what is allowed

  [[nodiscard]] std::string line() const { return where + ": " + message; }
};

/// One --set KEY=VALUE: a dotted path (list items by id, else by place from 1) and its new value, in YAML.
struct Override {
  std::string key;
  std::string value;
};

/// Overrides whose key depends on the scenario's kind, as the flags of that name say them.
inline constexpr std::string_view kAgentsFlag = "--agents";          ///< vehicles.agents, or those of ring or swap
inline constexpr std::string_view kControllerFlag = "--controller";  ///< controller.name

struct LockstepOptions {
  double deadline_s = 10.0;  ///< wall time after which an agent that leaves a tick unanswered is gone, 0.1 to 3600
  double round_s = 0.1;      ///< what a planning round stands for when a run is paced, 0.001 to 60; key planner.round_s

  bool operator==(const LockstepOptions&) const = default;
};

struct WorldOptions {
  std::uint32_t max_steps = 100'000;   ///< flight steps after which a run is given up, 1 to 10 million
  std::uint32_t max_rounds = 100'000;  ///< planning rounds after which a run is given up, 1 to 10 million
  std::uint32_t extra_steps = 0;       ///< flight steps after nobody is on the way any more, 0 to 10 million
  OnAgentLoss on_agent_loss = OnAgentLoss::Remove;  ///< what becomes of a lost agent's vehicle
  std::vector<Obstacle> hidden;                     ///< of a transit: what agents are not told of
  Surprises surprises;                              ///< what moves or appears, and what really happens

  bool operator==(const WorldOptions&) const = default;
};

struct Scenario {
  Mission mission;
  LockstepOptions lockstep;
  WorldOptions world;
  std::uint64_t scenario_hash = 0;  ///< of the file's text and the overrides, in their order; not of the seed
  std::string path;                 ///< as given
  std::string text;                 ///< of the file, unchanged
  std::vector<Override> overrides;  ///< in their order
};

using ScenarioResult = std::variant<Scenario, ScenarioFault>;

/// Reads a scenario file of at most 1 MB. @param overrides applied in their order, the last one of a key wins
/// @param seed replaces the file's seed
[[nodiscard]] ScenarioResult load_scenario(const std::string& path, std::span<const Override> overrides,
                                           std::optional<std::uint64_t> seed);

/// The same of a text already in memory; `path` is only for messages.
[[nodiscard]] ScenarioResult parse_scenario(const std::string& text, const std::string& path,
                                            std::span<const Override> overrides, std::optional<std::uint64_t> seed);

/// The scenario as it is with another seed: what it draws at random is drawn again. A fault if that finds no room.
[[nodiscard]] ScenarioResult with_seed(const Scenario& scenario, std::uint64_t seed);

}  // namespace skein
