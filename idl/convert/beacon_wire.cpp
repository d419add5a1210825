#include <algorithm>
#include <functional>

#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

bool ascends(const std::vector<std::uint64_t>& nonces) {
  return std::ranges::adjacent_find(nonces, std::greater_equal<>()) == nonces.end();
}

void check_origin(Checker& check, const wire::Beacon& sample) {
  const bool introduction = sample.head().incarnation() == 0;
  const bool asks_for_id = introduction && sample.agent() == kWorldId;
  if (!asks_for_id) check.agent(sample.agent(), "beacon.agent");
  check.sender(sample.head(), sample.agent(), "beacon.head.sender");
  if (!introduction || sample.head().run() != 0) check.run(sample.head().run(), "beacon.head.run");
  if (!introduction) {
    check.incarnation(sample.agent(), sample.head().incarnation(), sample.nonce(), "beacon.head.incarnation");
  }
}

void check_lists(Checker& check, const wire::Beacon& sample) {
  check.size_at_most(sample.matched().size(), wire::kMaxMatched, "beacon.matched");
  check.size_at_most(sample.needs().size(), wire::kMaxNeeds, "beacon.needs");
  check.size_at_most(sample.acknowledged().size(), wire::kMaxOrders, "beacon.acknowledged");
  if (!check.ok()) return;
  check.require(ascends(sample.matched()), WireFaultReason::BadOrder, "beacon.matched");
  for (const wire::Lack& lack : sample.needs()) {
    check.agent(lack.agent(), "beacon.needs.agent");
    check.enumerator(lack.topic(), NeedTopic::Answer, NeedTopic::ObstacleMap, "beacon.needs.topic");
  }
}

void check_state(Checker& check, const wire::Beacon& sample) {
  check.enumerator(sample.mode(), AgentMode::Waiting, AgentMode::Landed, "beacon.mode");
  check.enumerator(sample.failing(), Constraint::None, Constraint::Terrain, "beacon.failing");
  if (sample.failing_peer() != 0) check.agent(sample.failing_peer(), "beacon.failing_peer");
  check.pose(sample.own(), "beacon.own");
  check.velocity(sample.commanded_velocity_mps(), "beacon.commanded_velocity_mps");
  check.within(sample.planned_length_m(), 0.0, limits::kLength_m, "beacon.planned_length_m");
  check.within(sample.cost(), -limits::kCost, limits::kCost, "beacon.cost");
  check.enumerator(sample.safety_mode(), SafetyMode::Autonomous, SafetyMode::Hold, "beacon.safety_mode");
  check.enumerator(sample.safety_reason(), SafetyReason::None, SafetyReason::NoPlan, "beacon.safety_reason");
  check.within(sample.deviation_m(), 0.0, limits::kLength_m, "beacon.deviation_m");
  check.within(sample.predicted_separation_m(), 0.0, limits::kLength_m, "beacon.predicted_separation_m");
}

}  // namespace

wire::Beacon to_wire(const Beacon& beacon, const Stamp& stamp) {
  require_bound(beacon.matched.size(), wire::kMaxMatched, "beacon.matched");
  require_bound(beacon.needs.size(), wire::kMaxNeeds, "beacon.needs");
  wire::Beacon out;
  out.head(wire_head(beacon.run, stamp.stamp_ns, beacon.agent, beacon.incarnation));
  out.agent(beacon.agent);
  out.nonce(beacon.nonce);
  out.step(beacon.step);
  out.round(beacon.round);
  out.closes_round(beacon.closes_round);
  out.sent_representative(beacon.representative);
  out.sent_obstacle_map(beacon.obstacle_map);
  out.matched(beacon.matched);
  out.needs().resize(beacon.needs.size());
  for (std::size_t i = 0; i < beacon.needs.size(); ++i) {
    out.needs()[i].agent(beacon.needs[i].agent);
    out.needs()[i].round(beacon.needs[i].round);
    out.needs()[i].topic(static_cast<std::uint8_t>(beacon.needs[i].topic));
  }
  out.mode(static_cast<std::uint8_t>(beacon.mode));
  out.failing(static_cast<std::uint8_t>(beacon.constraint));
  out.failing_peer(beacon.constraint_peer);
  out.own(wire_pose(beacon.pose));
  out.commanded_velocity_mps(wire_point(beacon.commanded_velocity_mps));
  out.planned_length_m(beacon.planned_length_m);
  out.cost(beacon.cost);
  out.generation(beacon.generation);
  out.map_hash(beacon.map_hash);
  out.plan_view(beacon.plan_view);
  out.safety_mode(static_cast<std::uint8_t>(beacon.safety_mode));
  out.safety_reason(static_cast<std::uint8_t>(beacon.safety_reason));
  out.deviation_m(beacon.deviation_m);
  out.predicted_separation_m(beacon.predicted_separation_m);
  require_bound(beacon.acknowledged.size(), wire::kMaxOrders, "beacon.acknowledged");
  out.state_hash(beacon.state_hash);
  out.acknowledged(beacon.acknowledged);
  return out;
}

Checked<Beacon> from_wire(const wire::Beacon& sample, const WireContext& context) {
  Checker check(context);
  check_origin(check, sample);
  check_lists(check, sample);
  check_state(check, sample);
  if (!check.ok()) return check.fault();

  Beacon out;
  out.run = sample.head().run();
  out.agent = sample.agent();
  out.incarnation = sample.head().incarnation();
  out.nonce = sample.nonce();
  out.step = sample.step();
  out.round = sample.round();
  out.closes_round = sample.closes_round();
  out.representative = sample.sent_representative();
  out.obstacle_map = sample.sent_obstacle_map();
  out.matched = sample.matched();
  for (const wire::Lack& lack : sample.needs()) {
    out.needs.push_back({lack.agent(), lack.round(), static_cast<NeedTopic>(lack.topic())});
  }
  out.mode = static_cast<AgentMode>(sample.mode());
  out.constraint = static_cast<Constraint>(sample.failing());
  out.constraint_peer = sample.failing_peer();
  out.pose = plain_pose(sample.own());
  out.commanded_velocity_mps = plain_point(sample.commanded_velocity_mps());
  out.planned_length_m = sample.planned_length_m();
  out.cost = sample.cost();
  out.generation = sample.generation();
  out.map_hash = sample.map_hash();
  out.plan_view = sample.plan_view();
  out.safety_mode = static_cast<SafetyMode>(sample.safety_mode());
  out.safety_reason = static_cast<SafetyReason>(sample.safety_reason());
  out.deviation_m = sample.deviation_m();
  out.predicted_separation_m = sample.predicted_separation_m();
  out.state_hash = sample.state_hash();
  out.acknowledged = sample.acknowledged();
  return out;
}

}  // namespace skein
