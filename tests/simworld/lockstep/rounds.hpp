// Drives a Run by hand-made beacons, without agents: one answer an agent and round.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "simworld/lockstep/run.hpp"
#include "tests/simworld/lockstep/samples.hpp"

namespace skein::test {

/// Changes a closing beacon before it is answered; empty for none.
using Edit = std::function<void(Beacon&)>;

/// Decides the open round: all agents of `tick` but `lost` answer in `mode`.
inline Tick decide(Run& run, const Tick& tick, AgentMode mode, std::span<const Loss> lost = {}, const Edit& edit = {}) {
  Barrier barrier;
  barrier.open(tick, 0.0);
  for (const RosterEntry& entry : tick.roster) {
    const bool gone = std::ranges::find(lost, entry.agent, &Loss::agent) != lost.end();
    if (gone) continue;
    Beacon beacon = closing(entry.agent, tick.round, mode);
    if (edit) edit(beacon);
    barrier.accept(beacon);
  }
  return run.decide(barrier, lost);
}

/// Decides rounds in which all fly straight on, until the run is over or `most` rounds are decided.
inline Tick fly_on(Run& run, Tick tick, int most) {
  for (int i = 0; i < most && !run.finished(); ++i) tick = decide(run, tick, AgentMode::Flying);
  return tick;
}

}  // namespace skein::test
