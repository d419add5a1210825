#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "simworld/lockstep/world_session.hpp"

namespace skein {
namespace {

/// The same moment in a clock that differs by `shift_s`.
double shifted(double time_s, double shift_s) {
  return time_s < 0.0 ? time_s : time_s + shift_s;
}

}  // namespace

void WorldSession::record_round(const Steered& steered, double now_s) const {
  if (options_.recorder == nullptr) return;
  RoundInputs inputs;
  inputs.round = run_.rounds();
  inputs.world_hash = run_.state_hash();
  inputs.lost = lost_;
  inputs.back = back_;
  inputs.steered = steered;
  inputs.figures = {now_s, times_, topics_, pacer_.late()};
  if (inputs.round == 0) inputs.roster = tick_.roster;
  for (const RosterEntry& entry : tick_.roster) {
    const Answer* answer = barrier_.answer_of(entry.agent);
    if (answer != nullptr && answer->beacon) inputs.answers.push_back(*answer);
  }
  options_.recorder->round(inputs);
}

void WorldSession::replay(const RoundInputs& inputs) {
  if (run_.finished() || inputs.round != run_.rounds() || inputs.world_hash != run_.state_hash()) {
    throw std::invalid_argument(fmt::format("what was recorded of round {} is not what the run came to", inputs.round));
  }
  replayed_ = inputs.figures;
  desk_.remember(inputs.steered, inputs.round + 1);
  if (inputs.round == 0) {
    for (const RosterEntry& entry : inputs.roster) admission_.restore(entry);
  }
  for (const Loss& loss : inputs.lost) {
    admission_.lose(loss.agent, run_.rounds() + 1, loss.reason == LossReason::Deadline);
  }
  if (inputs.round == 0) {
    tick_ = run_.begin(inputs.roster, inputs.lost, inputs.back, inputs.steered);
  } else {
    barrier_.open(tick_, 0.0);
    for (const Answer& answer : inputs.answers) {
      if (answer.beacon) barrier_.accept(*answer.beacon);
      if (answer.representative) barrier_.accept(*answer.representative);
      if (answer.obstacle_map) barrier_.accept(*answer.obstacle_map);
    }
    repeats_.keep(barrier_, tick_);
    tick_ = run_.decide(barrier_, inputs.lost, inputs.back, inputs.steered);
  }
  for (const RosterEntry& entry : inputs.back) {
    if (std::ranges::find(tick_.roster, entry.nonce, &RosterEntry::nonce) != tick_.roster.end()) {
      admission_.restore(entry);
    }
  }
}

void WorldSession::resume(std::uint32_t restarts, double now_s) {
  restarts_ = restarts;
  if (run_.rounds() == 0) return;  // the swarm had not started
  const double shift_s = now_s - replayed_.now_s;
  for (double PhaseTimes::*time : {&PhaseTimes::created_s, &PhaseTimes::started_s, &PhaseTimes::flying_s}) {
    times_.*time = shifted(replayed_.times.*time, shift_s);
  }
  if (tick_.phase == Phase::Flying && times_.flying_s < 0.0) times_.flying_s = now_s;
  topics_ = replayed_.topics;
  pacer_.count_late(replayed_.late_steps);
  state_ = State::Running;
  if (mission_sent_s_ < 0.0) publish_mission(now_s);
  if (run_.finished()) close(now_s);
  expect(tick_, now_s);
  resumed_s_ = now_s;
}

/// What is heard meanwhile counts; what is not counts against nobody.
void WorldSession::rematch(double now_s) {
  world_matched_ = port_.matched();
  const bool all = std::ranges::all_of(tick_.roster, [this](const RosterEntry& entry) {
    return !is_live(entry.agent) || std::ranges::binary_search(world_matched_, entry.nonce);
  });
  const bool waits = !all && !interrupted_ && now_s - *resumed_s_ < options_.startup_timeout_s;
  if (waits && now_s - last_sent_s_ < kWaitingTick_s) return;
  if (!interrupted_) repeat_tick(now_s);
  if (waits) return;
  away_s_ = now_s - barrier_.opened_s();
  if (state_ == State::Closing) times_.finished_s = now_s;
  resumed_s_.reset();
}

void WorldSession::repeat_tick(double now_s) {
  publish_tick(now_s);
  const std::vector<AgentId> waiting = barrier_.waiting_for();
  for (const RosterEntry& entry : tick_.roster) {
    const bool lacks = std::ranges::binary_search(waiting, entry.agent) || gate_.lacks(tick_, entry.agent);
    if (entry.sense && lacks) publish_sense(entry, now_s);
  }
}

void WorldSession::expect(const Tick& tick, double now_s) {
  tick_ = tick;
  if (tick_.phase == Phase::Finished) {
    tick_.outcome = outcome();
    tick_.outcome->reason.resize(std::min(tick_.outcome->reason.size(), wire::kMaxReason));
  }
  away_s_ = 0.0;
  barrier_.open(tick_, now_s);
  pacer_.opened(tick_.step > 0 ? Phase::Flying : tick_.phase, now_s, run_.rounds_in_step());
}

}  // namespace skein
