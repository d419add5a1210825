#include "idl/convert/orders_wire.hpp"

#include <algorithm>
#include <functional>

#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

/// What an order says, whether it stands in a tick or in a command.
template <typename Wire>
void put_order(const Order& order, Wire& out) {
  out.id(order.id);
  out.agent(order.agent);
  out.kind(static_cast<std::uint8_t>(order.kind));
  out.to_m(wire_point(order.to_m));
  out.speed_mps(order.speed_mps);
}

template <typename Wire>
void check_order(Checker& check, const Wire& order, const char* where) {
  check.require(order.id() != 0, WireFaultReason::OutOfRange, where);
  check.require(order.agent() <= kMaxAgents, WireFaultReason::UnknownAgent, where);
  check.enumerator(order.kind(), OrderKind::Start, OrderKind::Goto, where);
  check.position(order.to_m(), where);
  check.within(order.speed_mps(), 0.0, limits::kSpeed_mps, where);
}

template <typename Wire>
Order plain_order(const Wire& order) {
  return {order.id(), order.agent(), static_cast<OrderKind>(order.kind()), plain_point(order.to_m()),
          order.speed_mps()};
}

}  // namespace

std::vector<wire::Ordered> wire_orders(const std::vector<Order>& orders) {
  require_bound(orders.size(), wire::kMaxOrders, "tick.commands");
  std::vector<wire::Ordered> out(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) put_order(orders[i], out[i]);
  return out;
}

std::vector<wire::Answered> wire_answers(const std::vector<OrderAnswer>& answers) {
  require_bound(answers.size(), wire::kMaxAnswers, "tick.answers");
  std::vector<wire::Answered> out(answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    require_bound(answers[i].acknowledged.size(), kMaxAgents, "tick.answers.acknowledged");
    require_bound(answers[i].text.size(), wire::kMaxAnswer, "tick.answers.text");
    out[i].id(answers[i].id);
    out[i].result(static_cast<std::uint8_t>(answers[i].result));
    out[i].round(answers[i].round);
    out[i].acknowledged(answers[i].acknowledged);
    out[i].text(answers[i].text);
  }
  return out;
}

void check_orders(Checker& check, const std::vector<wire::Ordered>& orders) {
  check.size_at_most(orders.size(), wire::kMaxOrders, "tick.commands");
  if (!check.ok()) return;
  for (const wire::Ordered& order : orders) check_order(check, order, "tick.commands");
}

void check_answers(Checker& check, const std::vector<wire::Answered>& answers) {
  check.size_at_most(answers.size(), wire::kMaxAnswers, "tick.answers");
  if (!check.ok()) return;
  for (const wire::Answered& answer : answers) {
    check.require(answer.id() != 0, WireFaultReason::OutOfRange, "tick.answers.id");
    check.enumerator(answer.result(), OrderResult::Accepted, OrderResult::Refused, "tick.answers.result");
    check.size_at_most(answer.acknowledged().size(), kMaxAgents, "tick.answers.acknowledged");
    check.text(answer.text().c_str(), "tick.answers.text");
    if (!check.ok()) return;
    AgentId before = 0;
    for (const AgentId agent : answer.acknowledged()) {
      check.require(agent > before && agent <= kMaxAgents, WireFaultReason::BadOrder, "tick.answers.acknowledged");
      before = agent;
    }
  }
}

std::vector<Order> plain_orders(const std::vector<wire::Ordered>& orders) {
  std::vector<Order> out;
  out.reserve(orders.size());
  for (const wire::Ordered& order : orders) out.push_back(plain_order(order));
  return out;
}

std::vector<OrderAnswer> plain_answers(const std::vector<wire::Answered>& answers) {
  std::vector<OrderAnswer> out;
  out.reserve(answers.size());
  for (const wire::Answered& answer : answers) {
    out.push_back({answer.id(), static_cast<OrderResult>(answer.result()), answer.round(), answer.acknowledged(),
                   answer.text().to_string()});
  }
  return out;
}

wire::Command to_wire(const Command& command, const Stamp& stamp) {
  wire::Command out;
  out.head(wire_head(command.run, stamp.stamp_ns, kWorldId, 0));
  put_order(command.order, out);
  out.deadline_s(command.deadline_s);
  return out;
}

Checked<Command> from_wire(const wire::Command& sample, const WireContext& context) {
  Checker check(context);
  check.run(sample.head().run(), "command.head.run");
  check_order(check, sample, "command");
  check.within(sample.deadline_s(), 0.0, limits::kTime_s, "command.deadline_s");
  if (!check.ok()) return check.fault();
  return Command{sample.head().run(), plain_order(sample), sample.deadline_s()};
}

wire::Inject to_wire(const Inject& inject, const Stamp& stamp) {
  const Injection& injection = inject.injection;
  wire::Inject out;
  out.head(wire_head(inject.run, stamp.stamp_ns, kWorldId, 0));
  out.id(injection.id);
  out.kind(static_cast<std::uint8_t>(injection.kind));
  out.agent(injection.agent);
  out.position_m(wire_point(injection.position_m));
  out.velocity_mps(wire_point(injection.velocity_mps));
  out.radius_m(injection.radius_m);
  out.column(injection.column);
  out.deadline_s(inject.deadline_s);
  return out;
}

Checked<Inject> from_wire(const wire::Inject& sample, const WireContext& context) {
  Checker check(context);
  check.run(sample.head().run(), "inject.head.run");
  check.require(sample.id() != 0, WireFaultReason::OutOfRange, "inject.id");
  check.enumerator(sample.kind(), InjectionKind::Obstacle, InjectionKind::Restart, "inject.kind");
  check.require(sample.agent() <= kMaxAgents, WireFaultReason::UnknownAgent, "inject.agent");
  check.position(sample.position_m(), "inject.position_m");
  check.velocity(sample.velocity_mps(), "inject.velocity_mps");
  check.within(sample.radius_m(), 0.0, limits::kLength_m, "inject.radius_m");
  check.within(sample.deadline_s(), 0.0, limits::kTime_s, "inject.deadline_s");
  if (!check.ok()) return check.fault();
  const Injection injection{sample.id(),
                            static_cast<InjectionKind>(sample.kind()),
                            sample.agent(),
                            plain_point(sample.position_m()),
                            plain_point(sample.velocity_mps()),
                            sample.radius_m(),
                            sample.column()};
  return Inject{sample.head().run(), injection, sample.deadline_s()};
}

}  // namespace skein
