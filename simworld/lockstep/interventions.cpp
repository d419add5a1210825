#include "simworld/lockstep/interventions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace skein {

Interventions::Interventions(std::vector<Fault> faults, std::vector<RosterChange> replay, ProcessControl* control)
    : faults_(std::move(faults)), replay_(std::move(replay)), replaying_(!replay_.empty()), control_(control) {
  if (control_ == nullptr && !faults_.empty()) {
    throw std::invalid_argument("faults need a launcher that can act on processes");
  }
}

void Interventions::forget(const Fault& fault) {
  const auto found = std::ranges::find(faults_, fault);
  if (found != faults_.end()) faults_.erase(found);
}

std::vector<Loss> Interventions::repeat(std::uint32_t round, std::span<const RosterEntry> roster, double now_s) {
  if (std::exchange(repeated_round_, round) != round) expected_.clear();
  std::vector<Loss> losses;
  const auto due = [&](const RosterChange& change) {
    if (change.round != round) return false;
    if (change.reason == LossReason::Rejoined) {
      expected_.push_back(change.agent);
      awaited_.push_back({.agent = change.agent, .back = true, .start = true, .since_s = now_s});
      return true;
    }
    const auto entry = std::ranges::find(roster, change.agent, &RosterEntry::agent);
    if (entry == roster.end() || entry->incarnation != change.incarnation) return false;
    losses.push_back({change.agent, change.reason});
    return true;
  };
  std::erase_if(replay_, due);
  return losses;
}

void Interventions::end(AgentId agent) {
  if (control_ != nullptr) control_->kill(agent);
}

bool Interventions::carry_out(const Moment& moment, const IsLive& live, double now_s) {
  bool acted = false;
  forget_confirmed();
  for (Awaited& awaited : awaited_) {
    if (!std::exchange(awaited.start, false) || control_ == nullptr) continue;
    processes_[awaited.agent] = Process::Running;
    control_->restart(awaited.agent);
    acted = true;
  }
  const auto is_due = [&](const Fault& fault) { return Moment{fault.phase, fault.at} == moment; };
  const bool dies = is_awaited(kWorldId) || std::ranges::any_of(faults_, [&](const Fault& fault) {
                      return fault.agent == kWorldId && is_due(fault);
                    });
  for (std::size_t i = 0; i < faults_.size();) {
    const Fault fault = faults_[i];
    const bool due = is_due(fault) && dies == (fault.agent == kWorldId) && !is_awaited(fault.agent);
    if (due && carry_out(fault, live(fault.agent), now_s)) {
      faults_.erase(faults_.begin() + static_cast<std::ptrdiff_t>(i));
      acted = true;
    } else {
      ++i;
    }
  }
  return acted;
}

bool Interventions::carry_out(const Fault& fault, bool live, double now_s) {
  const Process process = process_of(fault.agent);
  if (fault.kind != FaultKind::Restart && process == Process::Ended) return false;
  if (recorder_ != nullptr) recorder_->fault(fault);
  Awaited awaited{.agent = fault.agent, .since_s = now_s};
  switch (fault.kind) {
    case FaultKind::Kill:
      awaited.end = true;
      awaited_.push_back(awaited);
      control_->kill(fault.agent);
      break;
    case FaultKind::Stop:
      awaited.stop = true;
      awaited_.push_back(awaited);
      control_->stop(fault.agent);
      break;
    case FaultKind::Cont:
      awaited.back = !live;
      if (awaited.back) awaited_.push_back(awaited);
      processes_[fault.agent] = Process::Running;
      control_->cont(fault.agent);
      break;
    case FaultKind::Restart:
      awaited.end = process != Process::Ended;
      awaited.back = true;
      awaited_.push_back(awaited);
      processes_[fault.agent] = Process::Running;
      control_->restart(fault.agent);
      break;
  }
  return true;
}

void Interventions::process_ended(AgentId agent) {
  bool another = false;
  for (Awaited& awaited : awaited_) {
    if (awaited.agent != agent) continue;
    awaited.failed = awaited.back && !awaited.end && !awaited.start;
    another = another || (awaited.back && awaited.end);
    awaited.end = awaited.stop = false;
  }
  processes_[agent] = another ? Process::Running : Process::Ended;
}

void Interventions::process_stopped(AgentId agent) {
  processes_[agent] = Process::Stopped;
  for (Awaited& awaited : awaited_) {
    if (awaited.agent == agent) awaited.stop = false;
  }
}

void Interventions::forget_confirmed() {
  std::erase_if(awaited_, [](const Awaited& awaited) { return !awaited.end && !awaited.stop && !awaited.back; });
}

bool Interventions::holds(std::span<const RosterEntry> back) {
  forget_confirmed();
  const auto open = [&](const Awaited& awaited) {
    const bool ready = std::ranges::find(back, awaited.agent, &RosterEntry::agent) != back.end();
    return awaited.end || awaited.stop || awaited.failed || !ready;
  };
  if (std::ranges::any_of(awaited_, open)) return true;
  awaited_.clear();
  return false;
}

bool Interventions::awaits_return() const {
  return std::ranges::any_of(awaited_, &Awaited::back);
}

bool Interventions::may_return(AgentId agent) const {
  return !replaying_ || std::ranges::find(expected_, agent) != expected_.end();
}

bool Interventions::is_stopped(AgentId agent) const {
  return process_of(agent) == Process::Stopped;
}

bool Interventions::is_awaited(AgentId agent) const {
  return std::ranges::find(awaited_, agent, &Awaited::agent) != awaited_.end();
}

Interventions::Process Interventions::process_of(AgentId agent) const {
  const auto found = processes_.find(agent);
  return found == processes_.end() ? Process::Running : found->second;
}

std::optional<std::string> Interventions::failure(double now_s, double patience_s, double return_patience_s) const {
  for (const Awaited& awaited : awaited_) {
    if (awaited.failed) return fmt::format("agent {} ended before it was back", awaited.agent);
    const double limit_s = awaited.back ? return_patience_s : patience_s;
    if (now_s - awaited.since_s > limit_s) {
      return fmt::format("the fault on agent {} took no effect within {} s", awaited.agent, limit_s);
    }
  }
  return std::nullopt;
}

}  // namespace skein
