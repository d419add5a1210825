// One fault of a campaign: what is done to whom, and when, drawn for a run that is known undisturbed.
//
// Faults at ticks fall on any round or step of the undisturbed run; those of the wall clock into a flight that is paced
// to kPacedFlight_s. Source: own. Departs from source: none. Complexity: O(1).
#pragma once

#include <string>
#include <vector>

#include "groundstation/chaos/disturbance.hpp"
#include "planner/core/random/random_stream.hpp"
#include "simworld/lockstep/faults.hpp"

namespace skein::chaos {

inline constexpr double kPacedFlight_s = 2.0;  ///< of wall time, when a fault needs room

/// What a run is without faults.
struct Undisturbed {
  std::uint32_t rounds = 0;  ///< of planning
  std::uint32_t steps = 0;   ///< of flight, until nobody is on the way any more
  double step_s = 1.0;
  std::vector<AgentId> agents;
  std::string state_hash;
};

struct Injection {
  Disturbance kind;
  AgentId agent = 0;          ///< 0: the world, all, or those that are cut off
  std::vector<AgentId> cut;   ///< of a partition: who is on the other side than the world, ascending
  std::vector<Fault> script;  ///< at ticks
  double after_s = 0.0;       ///< of signals and partitions: wall time after the flight has begun
  double for_s = 0.0;         ///< and for how long
  double realtime = 0.0;      ///< the pace of the run; 0: as fast as it goes
};

/// @param deadline_s of the lockstep. @pre at least one agent, round and step
[[nodiscard]] Injection draw(const Disturbance& kind, const Undisturbed& run, double deadline_s, RandomStream& random);

/// In words: "stop:3@fly:40 cont:3@fly:52", "pause:2 0.31 s", "drop 0.02",
/// "partition:2,5 0.31 s".
[[nodiscard]] std::string text_of(const Injection& injection);

}  // namespace skein::chaos
