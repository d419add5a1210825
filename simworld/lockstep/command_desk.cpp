#include "simworld/lockstep/command_desk.hpp"

#include <algorithm>
#include <utility>

#include "idl/wire.hpp"

namespace skein {
namespace {

constexpr double kSaid_s = 3.0;
constexpr std::size_t kMostWaiting = 256;  ///< more are left unread: nobody commands so much

}  // namespace

void CommandDesk::take(const Command& command, double now_s) {
  if (waiting_.size() >= kMostWaiting || !taken_.insert(command.order.id).second) return;
  waiting_.push_back({command.order, std::nullopt, now_s + command.deadline_s});
}

void CommandDesk::take(const Inject& inject, double now_s) {
  if (waiting_.size() >= kMostWaiting || !taken_.insert(inject.injection.id).second) return;
  if (inject.injection.kind == InjectionKind::Obstacle && !(inject.injection.radius_m > 0.0)) {
    return answer(inject.injection.id, {OrderResult::Refused, "an obstacle needs a radius"}, now_s);
  }
  waiting_.push_back({std::nullopt, inject.injection, now_s + inject.deadline_s});
}

void CommandDesk::remember(const Steered& steered, std::uint32_t round) {
  for (const Order& order : steered.orders) taken_.insert(order.id);
  for (const Injection& injection : steered.injections) taken_.insert(injection.id);
  std::erase_if(orders_, [&](const OrderedAt& item) { return item.round <= round; });
  std::erase_if(injections_, [&](const InjectedAt& item) { return item.round <= round; });
}

bool CommandDesk::told(OrderKind kind) const {
  return std::ranges::any_of(waiting_, [kind](const Waiting& item) { return item.order && item.order->kind == kind; });
}

bool CommandDesk::ends(AgentId agent, double now_s) const {
  return std::ranges::any_of(waiting_, [&](const Waiting& item) {
    if (now_s > item.until_s) return false;
    if (item.order) return item.order->kind == OrderKind::Abort && item.order->agent == kAllAgents;
    const InjectionKind kind = item.injection->kind;
    return item.injection->agent == agent && (kind == InjectionKind::Kill || kind == InjectionKind::Restart);
  });
}

void CommandDesk::expire(double now_s) {
  std::erase_if(waiting_, [&](const Waiting& item) {
    if (now_s <= item.until_s) return false;
    answer(item.id(), {OrderResult::Expired, "no round was decided before its deadline"}, now_s);
    return true;
  });
}

std::vector<Injection> CommandDesk::take_faults() {
  std::vector<Injection> faults;
  std::erase_if(waiting_, [&](const Waiting& item) {
    if (!item.injection || item.injection->kind == InjectionKind::Obstacle) return false;
    faults.push_back(*item.injection);
    return true;
  });
  return faults;
}

Steered CommandDesk::take_due(std::uint32_t round,
                              const std::function<std::optional<Objection>(const Order&)>& objection, double now_s) {
  expire(now_s);
  Steered due;
  std::erase_if(orders_, [&](const OrderedAt& item) {
    if (item.round != round) return false;
    due.orders.push_back(item.order);
    return true;
  });
  std::erase_if(injections_, [&](const InjectedAt& item) {
    if (item.round != round) return false;
    due.injections.push_back(item.injection);
    return true;
  });
  std::erase_if(waiting_, [&](const Waiting& item) {
    if (item.order) {
      if (due.orders.size() >= wire::kMaxOrders) return false;
      if (const auto why = objection(*item.order)) {
        answer(item.id(), *why, now_s);
        return true;
      }
      due.orders.push_back(*item.order);
    } else {
      due.injections.push_back(*item.injection);
    }
    doing_.push_back(item);
    return true;
  });
  return due;
}

void CommandDesk::took_effect(std::uint32_t round, const std::vector<Order>& orders, bool finished, double now_s) {
  for (const Waiting& item : std::exchange(doing_, {})) {
    const bool said = item.order && std::ranges::find(orders, item.id(), &Order::id) != orders.end();
    if (said || (item.injection && !finished)) {
      accept(item.id(), round, now_s);
    } else {
      answer(item.id(), {OrderResult::Ended, "the run is over"}, now_s);
    }
  }
}

void CommandDesk::refuse(const std::function<std::optional<Objection>(const Order*)>& objection, double now_s) {
  std::erase_if(waiting_, [&](const Waiting& item) {
    const auto why = objection(item.order ? &*item.order : nullptr);
    if (why) answer(item.id(), *why, now_s);
    return why.has_value();
  });
}

void CommandDesk::accept_all(OrderKind kind, std::uint32_t round, double now_s) {
  std::erase_if(waiting_, [&](const Waiting& item) {
    const bool meant = item.order && item.order->kind == kind;
    if (meant) accept(item.id(), round, now_s);
    return meant;
  });
}

void CommandDesk::answer(std::uint64_t id, const Objection& why, double now_s) {
  put({id, why.result, 0, {}, why.text}, now_s);
}

void CommandDesk::accept(std::uint64_t id, std::uint32_t round, double now_s) {
  put({id, OrderResult::Accepted, round, {}, ""}, now_s);
}

void CommandDesk::put(OrderAnswer answer, double now_s) {
  if (said_.size() >= wire::kMaxAnswers) said_.erase(said_.begin());
  answer.text.resize(std::min(answer.text.size(), wire::kMaxAnswer));
  said_.push_back({std::move(answer), now_s});
}

std::vector<OrderAnswer> CommandDesk::answers(const std::vector<OrderRecord>& known, double now_s) {
  for (Said& said : said_) {
    const auto record = std::ranges::find(known, said.answer.id, [](const OrderRecord& item) { return item.order.id; });
    if (record == known.end() || record->acknowledged == said.answer.acknowledged) continue;
    said.answer.acknowledged = record->acknowledged;
    said.since_s = now_s;
  }
  std::erase_if(said_, [&](const Said& said) { return now_s - said.since_s > kSaid_s; });
  std::vector<OrderAnswer> answers;
  for (const Said& said : said_) answers.push_back(said.answer);
  return answers;
}

}  // namespace skein
