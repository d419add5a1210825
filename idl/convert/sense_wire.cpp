#include "idl/convert/checker.hpp"
#include "idl/convert/parts.hpp"

namespace skein {

wire::Sense to_wire(const Sense& sense, const Stamp& stamp) {
  wire::Sense out;
  out.head(wire_head(sense.run, stamp.stamp_ns, kWorldId, sense.incarnation));
  out.agent(sense.agent);
  out.round(sense.round);
  out.own(wire_pose(sense.pose));
  out.velocity_mps(wire_point(sense.velocity_mps));
  return out;
}

Checked<Sense> from_wire(const wire::Sense& sample, const WireContext& context) {
  Checker check(context);
  check.sender(sample.head(), kWorldId, "sense.head.sender");
  check.run(sample.head().run(), "sense.head.run");
  check.agent(sample.agent(), "sense.agent");
  check.incarnation(sample.agent(), sample.head().incarnation(), std::nullopt, "sense.head.incarnation");
  check.pose(sample.own(), "sense.own");
  check.velocity(sample.velocity_mps(), "sense.velocity_mps");
  if (!check.ok()) return check.fault();

  Sense out;
  out.run = sample.head().run();
  out.agent = sample.agent();
  out.incarnation = sample.head().incarnation();
  out.round = sample.round();
  out.pose = plain_pose(sample.own());
  out.velocity_mps = plain_point(sample.velocity_mps());
  return out;
}

}  // namespace skein
