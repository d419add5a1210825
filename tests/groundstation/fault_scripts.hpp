// Random scripts of faults on purpose, up to three a run, for a swarm on a ring (tests/groundstation/ring.hpp).
#pragma once

#include <vector>

#include "planner/core/random/random_stream.hpp"
#include "simworld/lockstep/faults.hpp"

namespace skein::test {

/// Kills, stops and restarts in every phase; a stop is mostly followed by a cont, a kill sometimes by a restart, at the
/// same moment or later. @param planning_rounds @param flight_steps over which the moments are drawn
inline std::vector<Fault> random_script(std::uint64_t seed, unsigned vehicles, unsigned planning_rounds,
                                        unsigned flight_steps) {
  RandomStream random(seed, 0, Purpose::Test, 77);
  const auto draw_moment = [&](Fault& fault) {
    const bool planning = random.uniform() < 0.5;
    fault.phase = planning ? Phase::Planning : Phase::Flying;
    fault.at = static_cast<std::uint32_t>(1 + random.below(planning ? planning_rounds : flight_steps));
  };
  std::vector<Fault> script;
  const std::size_t most = 1 + random.below(3);
  while (script.size() < most) {
    constexpr FaultKind kFirst[] = {FaultKind::Kill, FaultKind::Stop, FaultKind::Restart};
    Fault fault;
    fault.kind = kFirst[random.below(3)];
    fault.agent = static_cast<AgentId>(1 + random.below(vehicles));
    draw_moment(fault);
    script.push_back(fault);
    const bool goes_on = random.uniform() < 0.7 && script.size() < most && fault.kind != FaultKind::Restart;
    if (!goes_on) continue;
    fault.kind = fault.kind == FaultKind::Stop ? FaultKind::Cont : FaultKind::Restart;
    if (random.uniform() < 0.8) fault.at += static_cast<std::uint32_t>(1 + random.below(10));
    script.push_back(fault);
  }
  return script;
}

}  // namespace skein::test
