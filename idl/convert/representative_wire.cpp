#include "idl/convert/checker.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/parts.hpp"

namespace skein {
namespace {

wire::Reopening wire_revision(const Revision& revision) {
  require_bound(revision.obstacles.size(), wire::kMaxKnown, "representative.revision.obstacles");
  wire::Reopening out;
  out.attempt(revision.attempt);
  out.switch_step(revision.switch_step);
  out.reason(static_cast<std::uint8_t>(revision.reason));
  out.own(wire_pose(revision.pose));
  out.speed_mps(revision.speed_mps);
  out.obstacles(wire_tracks(revision.obstacles));
  return out;
}

Revision plain_revision(const wire::Reopening& revision) {
  return {revision.attempt(),         revision.switch_step(), static_cast<SafetyReason>(revision.reason()),
          plain_pose(revision.own()), revision.speed_mps(),   plain_tracks(revision.obstacles())};
}

void check_revision(Checker& check, const wire::Reopening& revision) {
  check.enumerator(revision.reason(), SafetyReason::None, SafetyReason::NoPlan, "representative.revision.reason");
  check.pose(revision.own(), "representative.revision.pose");
  check.within(revision.speed_mps(), 0.0, limits::kSpeed_mps, "representative.revision.speed_mps");
  check.tracks(revision.obstacles(), wire::kMaxKnown, "representative.revision.obstacles");
}

}  // namespace

wire::Representative to_wire(const Representative& representative, const Stamp& stamp) {
  require_bound(representative.particle.size(), wire::kMaxParticle, "representative.particle");
  wire::Representative out;
  out.head(wire_head(representative.run, stamp.stamp_ns, representative.agent, representative.incarnation));
  out.agent(representative.agent);
  out.round(representative.round);
  out.stage(static_cast<std::uint8_t>(representative.stage));
  out.violated(static_cast<std::uint8_t>(representative.violated));
  out.particle(representative.particle);
  out.cost(representative.cost);
  out.own_length_m(representative.own_length_m);
  out.path_length_m(representative.path_length_m);
  if (representative.revision) out.reopening().push_back(wire_revision(*representative.revision));
  return out;
}

Checked<Representative> from_wire(const wire::Representative& sample, const WireContext& context) {
  Checker check(context);
  check.agent(sample.agent(), "representative.agent");
  check.sender(sample.head(), sample.agent(), "representative.head.sender");
  check.run(sample.head().run(), "representative.head.run");
  check.incarnation(sample.agent(), sample.head().incarnation(), std::nullopt, "representative.head.incarnation");
  check.enumerator(sample.stage(), PlanStage::Searching, PlanStage::Settled, "representative.stage");
  check.enumerator(sample.violated(), Constraint::None, Constraint::Terrain, "representative.violated");
  check.size_at_most(sample.particle().size(), wire::kMaxParticle, "representative.particle");
  check.size_at_most(sample.reopening().size(), 1, "representative.revision");
  check.require(context.particle_size == 0 || sample.particle().size() == context.particle_size,
                WireFaultReason::OutOfRange, "representative.particle");
  if (!check.ok()) return check.fault();
  for (const double coordinate : sample.particle()) {
    check.within(coordinate, -limits::kParticle, limits::kParticle, "representative.particle");
  }
  check.within(sample.cost(), -limits::kCost, limits::kCost, "representative.cost");
  check.within(sample.own_length_m(), 0.0, limits::kLength_m, "representative.own_length_m");
  check.within(sample.path_length_m(), 0.0, limits::kLength_m, "representative.path_length_m");
  for (const wire::Reopening& revision : sample.reopening()) check_revision(check, revision);
  if (!check.ok()) return check.fault();

  Representative out;
  out.run = sample.head().run();
  out.agent = sample.agent();
  out.incarnation = sample.head().incarnation();
  out.round = sample.round();
  out.stage = static_cast<PlanStage>(sample.stage());
  out.violated = static_cast<Constraint>(sample.violated());
  out.particle = sample.particle();
  out.cost = sample.cost();
  out.own_length_m = sample.own_length_m();
  out.path_length_m = sample.path_length_m();
  for (const wire::Reopening& revision : sample.reopening()) out.revision = plain_revision(revision);
  return out;
}

}  // namespace skein
