#include "simworld/lockstep/flight_log.hpp"

#include <array>

namespace skein {
namespace {

constexpr std::size_t kMostEvents = 4096;
constexpr std::size_t kMostReplans = 1024;

}  // namespace

std::string_view name_of(ReplanOutcome outcome) {
  constexpr std::array<std::string_view, 4> kNames{"open", "switched", "no_plan", "replaced"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

void FlightLog::add(std::uint32_t step, std::uint32_t round, const Barrier& answers,
                    std::span<const RosterEntry> roster) {
  for (const RosterEntry& entry : roster) {
    const Beacon* beacon = own_beacon(answers, entry);
    if (beacon != nullptr) note_event(step, *beacon, round);
  }
  note_replan(step, round, answers, roster);
}

void FlightLog::note_event(std::uint32_t step, const Beacon& beacon, std::uint32_t round) {
  const Said now{beacon.safety_mode, beacon.safety_reason, beacon.mode == AgentMode::Replanning};
  Said& before = said_[beacon.agent];
  if (now == before) return;
  before = now;
  if (events_.size() >= kMostEvents) {
    ++left_out_;
    return;
  }
  events_.push_back({step, round, beacon.agent, now.mode, now.reason, now.replanning, beacon.deviation_m,
                     beacon.predicted_separation_m});
}

/// Who opens an attempt says so in a representative; of several the first caller counts.
void FlightLog::note_revision(std::uint32_t step, const Revision& revision, AgentId agent) {
  if (attempt_ != 0 && revision.attempt > attempt_ && revision.reason != SafetyReason::None) {
    replans_.back().outcome = ReplanOutcome::Replaced;
    replans_.back().ended_step = step;
    replans_.push_back({step, revision.attempt, agent, revision.reason, revision.switch_step});
    attempt_ = revision.attempt;
  }
  Replan& open = replans_.back();
  if (attempt_ == 0 && revision.reason != SafetyReason::None) {
    attempt_ = revision.attempt;
    open.agent = agent;
    open.reason = revision.reason;
  }
  if (revision.attempt == attempt_ && revision.switch_step > open.switch_step) open.switch_step = revision.switch_step;
}

void FlightLog::note_replan(std::uint32_t step, std::uint32_t round, const Barrier& answers,
                            std::span<const RosterEntry> roster) {
  bool anybody = false;
  bool without_plan = false;
  for (const RosterEntry& entry : roster) {
    const Beacon* beacon = own_beacon(answers, entry);
    if (beacon == nullptr) continue;
    const bool took_part = std::ranges::find(taking_part_, entry.agent) != taking_part_.end();
    without_plan = without_plan || (took_part && beacon->safety_reason == SafetyReason::NoPlan);
    if (beacon->mode != AgentMode::Replanning) continue;
    anybody = true;
    const bool is_open = !replans_.empty() && replans_.back().outcome == ReplanOutcome::Open;
    if (!is_open && replans_.size() >= kMostReplans) continue;
    if (!is_open) replans_.push_back({step, round, entry.agent, beacon->safety_reason});
    if (!took_part) taking_part_.push_back(entry.agent);
    const auto& sample = answers.answer_of(entry.agent)->representative;
    if (sample && sample->revision) note_revision(step, *sample->revision, entry.agent);
  }
  if (anybody || taking_part_.empty()) return;
  Replan& ended = replans_.back();
  ended.outcome = without_plan ? ReplanOutcome::NoPlan : ReplanOutcome::Switched;
  ended.ended_step = step;
  taking_part_.clear();
  attempt_ = 0;
}

}  // namespace skein
