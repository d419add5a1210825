#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "planner/core/lockstep/names.hpp"
#include "simworld/lockstep/world_session.hpp"

namespace skein {
namespace {

FaultKind fault_of(InjectionKind kind) {
  return kind == InjectionKind::Pause  ? FaultKind::Stop
         : kind == InjectionKind::Kill ? FaultKind::Kill
                                       : FaultKind::Restart;
}

}  // namespace

template <typename Plain, typename Wire>
void WorldSession::take_command(const Wire& sample, double now_s) {
  WireContext context;
  if (sample.head().run() != 0) context.run = options_.run;  // 0: of whatever run
  const Checked<Plain> checked = from_wire(sample, context);
  if (!checked.ok()) return faults_.add(checked.fault().reason);
  desk_.take(checked.value(), now_s);
}

void WorldSession::on_sample(const wire::Command& sample, double now_s) {
  take_command<Command>(sample, now_s);
}

void WorldSession::on_sample(const wire::Inject& sample, double now_s) {
  take_command<Inject>(sample, now_s);
}

/// What is done to processes, at the coming tick.
void WorldSession::take_faults(const Moment& moment, double now_s) {
  for (const Injection& injection : desk_.take_faults()) {
    const auto& vehicles = mission_.vehicles;
    const bool known = std::ranges::find(vehicles, injection.agent, &VehicleSpec::id) != vehicles.end();
    const FaultKind kind = fault_of(injection.kind);
    if (!known) {
      desk_.answer(injection.id,
                   {OrderResult::UnknownAgent, fmt::format("the mission has no vehicle {}", injection.agent)}, now_s);
    } else if (!interventions_.can_act()) {
      desk_.answer(injection.id,
                   {OrderResult::NoLauncher, "nobody launched this swarm's agents: skein run does, by hand nobody"},
                   now_s);
    } else if (kind != FaultKind::Restart && interventions_.is_ended(injection.agent)) {
      desk_.answer(injection.id,
                   {OrderResult::NotLive, fmt::format("the process of agent {} has ended", injection.agent)}, now_s);
    } else {
      interventions_.add({kind, injection.agent, moment.phase, moment.number});
      desk_.accept(injection.id, run_.rounds() + 1, now_s);
    }
  }
}

void WorldSession::advance(double now_s) {
  const Steered steered = desk_.take_due(
      run_.rounds() + 1, [this](const Order& order) { return run_.objection(order, lost_); }, now_s);
  record_round(steered, now_s);
  repeats_.keep(barrier_, tick_);
  const Tick next = run_.decide(barrier_, std::exchange(lost_, {}), back_, steered);
  desk_.took_effect(next.round, next.orders, run_.finished(), now_s);
  go_on(next, now_s);
}

/// Before the start: only that, where the world waits for it, and the end.
void WorldSession::take_orders_waiting(double now_s) {
  desk_.expire(now_s);
  if (desk_.empty()) return;
  desk_.refuse(
      [this](const Order* order) -> std::optional<Objection> {
        if (order != nullptr && order->kind == OrderKind::Abort && order->agent == kAllAgents) return std::nullopt;
        if (order == nullptr || order->kind != OrderKind::Start) {
          return Objection{OrderResult::NotFlying, "the mission has not started"};
        }
        if (options_.wait_start) return std::nullopt;
        return Objection{OrderResult::Started, "the mission starts by itself: its world does not --wait-start"};
      },
      now_s);
  if (!desk_.told(OrderKind::Abort)) return;
  desk_.accept_all(OrderKind::Abort, tick_.round + 1, now_s);
  refuse_start("aborted by command", now_s, ExitCode::Failed);
}

/// What the first tick says.
Steered WorldSession::take_start(double now_s) {
  const auto objection = [this](const Order& order) -> std::optional<Objection> {
    if (order.kind == OrderKind::Start && options_.wait_start) return std::nullopt;
    return Objection{OrderResult::NotFlying, "the mission has not started"};
  };
  return desk_.take_due(1, objection, now_s);
}

}  // namespace skein
