// A run of two on a stage whose rounds are recorded, through bytes and back: it plans, agent 2 ends, comes back under a
// new incarnation, and both fly to their slots.
#pragma once

#include <vector>

#include "simworld/checkpoint/round_record.hpp"
#include "tests/simworld/lockstep/stage.hpp"

namespace skein::test {

inline constexpr std::uint64_t kNewNonce = 555;

/// Keeps rounds as bytes, and gives them back as a journal would.
class Kept final : public Recorder {
 public:
  void round(const RoundInputs& inputs) override { rounds.push_back(to_bytes(inputs)); }
  void fault(const Fault& fault) override { faults.push_back(fault); }

  [[nodiscard]] RoundInputs inputs(std::size_t index) const {
    const std::vector<AgentId> ids{1, 2};
    WireContext context;
    context.run = kRun;
    context.known = ids;
    return round_inputs_from(rounds.at(index), context).value();
  }

  std::vector<Bytes> rounds;
  std::vector<Fault> faults;
};

/// What an agent answers to a tick: a plan in the third round, arrived in the fourth flight step.
inline void answer(Stage& stage, const Tick& tick) {
  for (const RosterEntry& entry : tick.roster) {
    const bool planning = tick.phase == Phase::Planning;
    Beacon beacon = closing(entry.agent, tick.round, planning ? AgentMode::Planning : AgentMode::Flying);
    if (planning && tick.round >= 4) beacon.mode = AgentMode::Ready;
    if (tick.step >= 3) beacon.mode = AgentMode::Arrived;
    beacon.incarnation = entry.incarnation;
    beacon.nonce = entry.nonce;
    if (entry.incarnation > 1) beacon.mode = AgentMode::Rejoined;
    beacon.representative = planning && entry.incarnation == 1;
    if (beacon.representative) stage.say(representative(entry.agent, tick.round));
    stage.say(beacon);
  }
}

/// Goes on from the open tick to the end. @param ticks all that are opened from then on
inline void play(Stage& stage, Tick tick, std::vector<Tick>& ticks) {
  while (tick.phase != Phase::Finished) {
    if (tick.round == 2) stage.session.process_ended(2, stage.now_s);
    const bool alone = tick.roster.size() == 1 && tick.round >= 3;
    if (alone) {
      stage.port.sees.push_back(kNewNonce);
      stage.say(introduction(2, {kWorldNonce, nonce_of(1)}, kNewNonce));
    }
    answer(stage, tick);
    stage.at(stage.now_s);
    tick = stage.last_tick();
    ticks.push_back(tick);
  }
  answer(stage, tick);
  stage.at(stage.now_s);
}

}  // namespace skein::test
