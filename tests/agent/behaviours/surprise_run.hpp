// One rendezvous with random starts, into which a random fixed obstacle falls at a random moment, on somebody's path.
#pragma once

#include <string>

#include "planner/core/mission/mission.hpp"

namespace skein::test {

struct SurpriseRun {
  bool planned = false;    ///< on the ground
  bool surprised = false;  ///< a place for an obstacle was found
  bool together = false;   ///< all arrived, in one step
  bool arrived = false;
  int switches = 0;  ///< to new plans
  int failures = 0;  ///< attempts without one
  double least_clearance_m = 1e9;
  double least_separation_m = 1e9;
  bool agreed = true;  ///< whoever turned to a new plan did so in one step with all others, to paths of one length
  std::uint64_t hash = 0;
  std::string arrivals;
};

/// surprise_mission with starts moved at random.
[[nodiscard]] Mission random_mission(std::uint64_t seed);
/// @param late the share of the way after which the obstacle falls: from 0.1 to 0.1 + late
[[nodiscard]] SurpriseRun run_surprise(std::uint64_t seed, double late = 0.8);

}  // namespace skein::test
