#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/orders_wire.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

void check_roster(Checker& check, const std::vector<wire::LiveAgent>& roster) {
  std::uint32_t before = 0;
  for (const wire::LiveAgent& live : roster) {
    check.agent(live.agent(), "tick.roster.agent");
    check.require(live.agent() > before, WireFaultReason::BadOrder, "tick.roster");
    check.require(live.incarnation() > 0, WireFaultReason::OutOfRange, "tick.roster.incarnation");
    before = live.agent();
  }
}

}  // namespace

wire::Tick to_wire(const Tick& tick, const Stamp& stamp) {
  require_bound(tick.roster.size(), wire::kMaxVehicles, "tick.roster");
  require_bound(tick.refused.size(), wire::kMaxRefused, "tick.refused");
  require_bound(tick.assigned.size(), wire::kMaxVehicles, "tick.given");
  wire::Tick out;
  out.head(wire_head(tick.run, stamp.stamp_ns, kWorldId, 0));
  out.step(tick.step);
  out.round(tick.round);
  out.phase(static_cast<std::uint8_t>(tick.phase));
  out.time_s(tick.time_s);
  out.roster().resize(tick.roster.size());
  for (std::size_t i = 0; i < tick.roster.size(); ++i) {
    const RosterEntry& entry = tick.roster[i];
    wire::LiveAgent& live = out.roster()[i];
    live.agent(entry.agent);
    live.incarnation(entry.incarnation);
    live.nonce(entry.nonce);
    live.counts_representative(entry.representative);
    live.gets_sense(entry.sense);
    live.counts_obstacle_map(entry.obstacle_map);
  }
  out.refused().resize(tick.refused.size());
  for (std::size_t i = 0; i < tick.refused.size(); ++i) {
    out.refused()[i].nonce(tick.refused[i].nonce);
    out.refused()[i].reason(static_cast<std::uint8_t>(tick.refused[i].reason));
  }
  out.given().resize(tick.assigned.size());
  for (std::size_t i = 0; i < tick.assigned.size(); ++i) {
    out.given()[i].nonce(tick.assigned[i].nonce);
    out.given()[i].agent(tick.assigned[i].agent);
  }
  out.world_hash(tick.world_hash);
  if (tick.outcome) {
    require_bound(tick.outcome->reason.size(), wire::kMaxReason, "tick.reason");
    out.exit_code(tick.outcome->exit_code);
    out.reason(tick.outcome->reason);
  }
  out.commands(wire_orders(tick.orders));
  out.answers(wire_answers(tick.answers));
  return out;
}

Checked<Tick> from_wire(const wire::Tick& sample, const WireContext& context) {
  Checker check(context);
  check.sender(sample.head(), kWorldId, "tick.head.sender");
  check.run(sample.head().run(), "tick.head.run");
  check.enumerator(sample.phase(), Phase::Waiting, Phase::Finished, "tick.phase");
  check.within(sample.time_s(), 0.0, limits::kTime_s, "tick.time_s");
  check.size_at_most(sample.roster().size(), wire::kMaxVehicles, "tick.roster");
  check.size_at_most(sample.refused().size(), wire::kMaxRefused, "tick.refused");
  check.size_at_most(sample.given().size(), wire::kMaxVehicles, "tick.given");
  check.text(sample.reason().c_str(), "tick.reason");
  if (!check.ok()) return check.fault();
  check_roster(check, sample.roster());
  for (const wire::TurnedAway& refusal : sample.refused()) {
    check.enumerator(refusal.reason(), RefusalReason::IdInUse, RefusalReason::RunStarted, "tick.refused.reason");
  }
  for (const wire::GivenId& given : sample.given()) check.agent(given.agent(), "tick.given.agent");
  check_orders(check, sample.commands());
  check_answers(check, sample.answers());
  if (!check.ok()) return check.fault();

  Tick out;
  out.run = sample.head().run();
  out.step = sample.step();
  out.round = sample.round();
  out.phase = static_cast<Phase>(sample.phase());
  out.time_s = sample.time_s();
  out.roster.reserve(sample.roster().size());
  for (const wire::LiveAgent& live : sample.roster()) {
    out.roster.push_back({live.agent(), live.incarnation(), live.nonce(), live.counts_representative(),
                          live.gets_sense(), live.counts_obstacle_map()});
  }
  for (const wire::TurnedAway& refusal : sample.refused()) {
    out.refused.push_back({refusal.nonce(), static_cast<RefusalReason>(refusal.reason())});
  }
  for (const wire::GivenId& given : sample.given()) out.assigned.push_back({given.nonce(), given.agent()});
  out.world_hash = sample.world_hash();
  out.orders = plain_orders(sample.commands());
  out.answers = plain_answers(sample.answers());
  if (out.phase == Phase::Finished) out.outcome = Outcome{sample.exit_code(), sample.reason().to_string()};
  return out;
}

}  // namespace skein
