#include "groundstation/watch/events.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "planner/core/lockstep/names.hpp"

namespace skein::watch {
namespace {

constexpr std::array<std::string_view, 9> kNames{"phase",     "mode",      "safety",  "roster", "refused",
                                                 "near_miss", "collision", "outcome", "command"};

Event event_at(const Tick& tick, AgentId agent, EventKind kind, std::string_view what, std::string_view reason) {
  return {tick.time_s, tick.step, tick.round, agent, kind, std::string(what), std::string(reason)};
}

const RosterEntry* find(const Tick& tick, AgentId agent) {
  const auto entry = std::ranges::find(tick.roster, agent, &RosterEntry::agent);
  return entry == tick.roster.end() ? nullptr : &*entry;
}

/// Who left and who came; on the ground the whole swarm comes, which is no news.
void add_roster_changes(const Tick& before, const Tick& now, std::vector<Event>& events) {
  for (const RosterEntry& entry : before.roster) {
    const RosterEntry* still = find(now, entry.agent);
    if (still == nullptr || still->incarnation != entry.incarnation) {
      events.push_back(event_at(now, entry.agent, EventKind::Roster, "lost",
                                fmt::format("incarnation_{}_no_longer_live", entry.incarnation)));
    }
  }
  for (const RosterEntry& entry : now.roster) {
    const RosterEntry* known = find(before, entry.agent);
    if (entry.incarnation > 1 && (known == nullptr || known->incarnation != entry.incarnation)) {
      events.push_back(event_at(now, entry.agent, EventKind::Roster, skein::name_of(LossReason::Rejoined),
                                fmt::format("incarnation_{}", entry.incarnation)));
    }
  }
}

std::string constraint_text(const Beacon& beacon) {
  if (beacon.constraint == Constraint::None) return "";
  if (beacon.constraint_peer == 0) return std::string(skein::name_of(beacon.constraint));
  return fmt::format("{} agent {}", skein::name_of(beacon.constraint), beacon.constraint_peer);
}

}  // namespace

std::string_view name_of(EventKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index < kNames.size() ? kNames[index] : std::string_view("unknown");
}

std::vector<Event> changes(const Tick* before, const Tick& now) {
  std::vector<Event> events;
  if (before == nullptr || before->phase != now.phase) {
    events.push_back(
        event_at(now, kWorldId, EventKind::Phase, skein::name_of(now.phase), before == nullptr ? "first_heard" : ""));
  }
  if (before != nullptr) add_roster_changes(*before, now, events);
  for (const Refusal& refusal : now.refused) {
    const bool is_new = before == nullptr || std::ranges::find(before->refused, refusal) == before->refused.end();
    if (is_new) {
      events.push_back(event_at(now, kWorldId, EventKind::Refused, fmt::format("nonce_{:016x}", refusal.nonce),
                                skein::name_of(refusal.reason)));
    }
  }
  for (const OrderAnswer& answer : now.answers) {  // of orders below; an injection is in no tick but as its answer
    const bool is_new = answer.result == OrderResult::Accepted && answer.round == now.round;
    const bool of_order = std::ranges::find(now.orders, answer.id, &Order::id) != now.orders.end();
    if (is_new && !of_order) events.push_back(event_at(now, kWorldId, EventKind::Command, "injection", ""));
  }
  for (const Order& order : now.orders) {  // a tick of a round says them once
    const bool is_goto = order.kind == OrderKind::Goto;
    events.push_back(
        event_at(now, order.agent, EventKind::Command, skein::name_of(order.kind),
                 is_goto ? fmt::format("{:.1f} {:.1f} {:.1f}", order.to_m.x(), order.to_m.y(), order.to_m.z()) : ""));
  }
  if (now.outcome && (before == nullptr || !before->outcome)) {
    events.push_back(event_at(now, kWorldId, EventKind::Outcome, fmt::format("exit_{}", now.outcome->exit_code),
                              now.outcome->reason));
  }
  return events;
}

std::vector<Event> changes(const Beacon* before, const Beacon& now, double time_s) {
  std::vector<Event> events;
  const auto add = [&](EventKind kind, std::string_view what, const std::string& reason) {
    events.push_back({time_s, now.step, now.round, now.agent, kind, std::string(what), reason});
  };
  if (before != nullptr && before->mode != now.mode) {
    add(EventKind::Mode, skein::name_of(now.mode), constraint_text(now));
  }
  const SafetyMode mode_before = before == nullptr ? SafetyMode::Autonomous : before->safety_mode;
  const bool reason_changed =
      before != nullptr && before->safety_reason != now.safety_reason && now.safety_mode != SafetyMode::Autonomous;
  if (mode_before != now.safety_mode || reason_changed) {
    const bool reasoned = now.safety_reason != SafetyReason::None;
    add(EventKind::Safety, skein::name_of(now.safety_mode),
        reasoned ? std::string(skein::name_of(now.safety_reason)) : "");
  }
  return events;
}

}  // namespace skein::watch
